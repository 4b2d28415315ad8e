// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "rooms.hpp"
#include "samcontact/plasticity/material.hpp"
#include "samcontact/plasticity/return_mapping.hpp"

namespace samcontact::bindings {

void bind_plasticity(py::module_& m) {
  using plasticity::Material;
  py::class_<Elastic>(m, "Elastic")
      .def_static("isotropic", &Elastic::isotropic, py::arg("E"), py::arg("nu"))
      .def_static("rigid", &Elastic::rigid)
      .def_readonly("E", &Elastic::E)
      .def_readonly("nu", &Elastic::nu);
  py::class_<Material>(m, "Material")
      .def_static("elastic", &Material::make_elastic, py::arg("E"), py::arg("nu"))
      .def_static("rigid", &Material::make_rigid)
      .def_static("perfect_plastic", &Material::make_perfect_plastic, py::arg("E"), py::arg("nu"),
                  py::arg("yield_stress"))
      .def_static("linear_hardening", &Material::make_linear_hardening, py::arg("E"), py::arg("nu"),
                  py::arg("yield_stress"), py::arg("tangent_modulus"))
      .def_static("swift", &Material::make_swift, py::arg("E"), py::arg("nu"), py::arg("B"),
                  py::arg("C"), py::arg("n"))
      .def(
          "with_backstresses",
          [](const Material& s, const std::vector<std::pair<double, double>>& terms) {
            std::vector<plasticity::Backstress> backstresses;
            backstresses.reserve(terms.size());
            for (const auto& [modulus, recovery] : terms) {
              backstresses.push_back({modulus, recovery});
            }
            return s.with_backstresses(backstresses);
          },
          py::arg("terms"))
      .def(
          "with_thermal",
          [](const Material& s, double conductivity, double expansion, double diffusivity) {
            return s.with_thermal(Thermal::of(conductivity, expansion, diffusivity));
          },
          py::arg("conductivity"), py::arg("expansion"), py::arg("diffusivity"))
      .def_property_readonly("elastic_constants", [](const Material& s) { return s.elastic; })
      .def_property_readonly("is_plastic", &Material::is_plastic)
      .def(
          "yield_stress",
          [](const Material& s, const Array& g) {
            py::array_t<double> out(g.size());
            double* to = out.mutable_data();
            for (py::ssize_t i = 0; i < g.size(); ++i) {
              to[i] = s.hardening.yield_stress(g.data()[i]);
            }
            return out;
          },
          py::arg("g"))
      .def(
          "uniaxial_stress",
          [](const Material& s, const std::vector<double>& strain) {
            return plasticity::uniaxial_stress(s, strain);
          },
          py::arg("strain"))
      .def(
          "radial_return",
          [](const Material& s, const plasticity::Tensor& stress, double g,
             const std::vector<plasticity::Tensor>& backstresses) {
            const auto r = plasticity::radial_return(stress, {}, g, s, backstresses);
            std::vector<plasticity::Tensor> after;
            after.reserve(backstresses.size());
            for (std::size_t n = 0; n < backstresses.size(); ++n) {
              after.push_back(plasticity::advanced(backstresses[n], s.backstresses[n], r.increment,
                                                   r.equivalent));
            }
            return py::make_tuple(r.increment, r.equivalent, after);
          },
          py::arg("stress"), py::arg("g"), py::arg("backstresses"))
      .def(
          "equivalent_increment",
          [](const Material& s, double trial, double g) {
            return plasticity::equivalent_increment(trial, g, s.elastic.shear_modulus(),
                                                    s.hardening);
          },
          py::arg("trial"), py::arg("g"));
}

}  // namespace samcontact::bindings
