// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "rooms.hpp"
#include "samcontact/base/stack.hpp"
#include "samcontact/operators/medium/layered_half_space.hpp"
#include "samcontact/plasticity/body.hpp"
#include "samcontact/plasticity/return_mapping.hpp"

namespace samcontact::bindings {
namespace {

template <class Function>
Values each(const Array& g, const Function& function) {
  Values out(g.size());
  std::transform(g.data(), g.data() + g.size(), out.mutable_data(), function);
  return out;
}

void bind_descriptions(py::module_& m) {
  using plasticity::LawDescription;
  py::class_<LawDescription>(m, "LawDescription")
      .def_readonly("name", &LawDescription::name)
      .def_readonly("says", &LawDescription::says)
      .def_readonly("yields", &LawDescription::yields)
      .def_readonly("parameters", &LawDescription::parameters);
  m.def("hardening_laws", &plasticity::Hardening::descriptions);
}

void bind_stack(py::module_& m) {
  py::class_<Stack>(m, "Stack")
      .def(py::init([](const Elastic& elastic) { return Stack{{}, elastic}; }), py::arg("elastic"))
      .def(
          "wave_compliance",
          [](const Stack& stack, const Array& wavenumbers) {
            const auto medium = operators::medium_of(stack);
            return each(wavenumbers, [&](double q) { return medium->wave_compliance(q); });
          },
          py::arg("wavenumbers"))
      .def("__eq__", [](const Stack& one, const py::object& other) {
        return py::isinstance<Stack>(other) && one == other.cast<const Stack&>();
      });
}

using plasticity::Material;

Material with_backstresses(const Material& s, const std::vector<std::pair<double, double>>& terms) {
  std::vector<plasticity::Backstress> backstresses;
  backstresses.reserve(terms.size());
  for (const auto& [modulus, recovery] : terms) backstresses.push_back({modulus, recovery});
  return s.with_backstresses(backstresses);
}

plasticity::Body body_of(const Material& substrate,
                         const std::vector<std::pair<Material, double>>& given) {
  std::vector<plasticity::MaterialLayer> layers;
  layers.reserve(given.size());
  for (const auto& [material, h] : given) layers.push_back({material, h});
  return {substrate, std::move(layers)};
}

using plasticity::Tensor;

std::tuple<Tensor, double, std::vector<Tensor>> radial_return(
    const Material& s, const Tensor& stress, double g, const std::vector<Tensor>& backstresses) {
  const auto r = plasticity::radial_return(stress, {}, g, s, backstresses);
  std::vector<Tensor> after;
  after.reserve(backstresses.size());
  for (std::size_t n = 0; n < backstresses.size(); ++n) {
    after.push_back(
        plasticity::advanced(backstresses[n], s.backstresses[n], r.increment, r.equivalent));
  }
  return {r.increment, r.equivalent, std::move(after)};
}

/// Materials with an additional property.
void bind_properties(py::class_<Material>& material) {
  material.def("with_backstresses", &with_backstresses, py::arg("terms"))
      .def(
          "with_thermal",
          [](const Material& s, double conductivity, double expansion, double diffusivity) {
            return s.with_thermal(Thermal::of(conductivity, expansion, diffusivity));
          },
          py::arg("conductivity"), py::arg("expansion"), py::arg("diffusivity"))
      .def(
          "with_yield_profile",
          [](const Material& s, const std::vector<double>& z, const std::vector<double>& factor) {
            return s.with_yield_profile({z, factor});
          },
          py::arg("z"), py::arg("factor"))
      .def(
          "with_initial_stress",
          [](const Material& s, const std::vector<double>& z, const std::vector<double>& sxx,
             const std::vector<double>& syy, const std::vector<double>& sxy) {
            return s.with_initial_stress({{z, sxx}, {z, syy}, {z, sxy}});
          },
          py::arg("z"), py::arg("sxx"), py::arg("syy"), py::arg("sxy"))
      .def(
          "with_free_faces",
          [](const Material& s, double low, double high, bool exact) {
            return s.with_free_faces({low, high, exact ? FaceMethod::exact : FaceMethod::factor});
          },
          py::arg("low"), py::arg("high"), py::arg("exact"))
      .def(
          "with_relaxation",
          [](const Material& s, const std::vector<double>& times,
             const std::vector<double>& shares) { return s.with_relaxation({times, shares}); },
          py::arg("times"), py::arg("shares"));
}

void bind_material(py::module_& m) {
  py::class_<Material> material(m, "Material");
  material.def_static("rigid", &Material::make_rigid)
      .def_static("with_law",
                  py::overload_cast<double, double, const std::string&,
                                    const plasticity::Hardening::Values&>(&Material::with_law),
                  py::arg("E"), py::arg("nu"), py::arg("law"), py::arg("values"));
  bind_properties(material);
  material.def_property_readonly("stack", [](const Material& s) { return Stack{{}, s.elastic}; })
      .def_property_readonly("elastic_constants", [](const Material& s) { return s.elastic; })
      .def_property_readonly("is_plastic", &Material::is_plastic)
      .def(
          "yield_stress",
          [](const Material& s, const Array& g) {
            return each(g, [&](double one) { return s.hardening.yield_stress(one); });
          },
          py::arg("g"))
      .def(
          "work",
          [](const Material& s, const Array& g) {
            return each(g, [&](double one) { return s.hardening.work(one); });
          },
          py::arg("g"))
      .def(
          "uniaxial_stress",
          [](const Material& s, const std::vector<double>& strain) {
            return plasticity::uniaxial_stress(s, strain);
          },
          py::arg("strain"))
      .def("radial_return", &radial_return, py::arg("stress"), py::arg("g"),
           py::arg("backstresses"))
      .def(
          "equivalent_increment",
          [](const Material& s, double trial, double g) {
            return plasticity::equivalent_increment(trial, g, s.elastic.shear_modulus(),
                                                    s.hardening);
          },
          py::arg("trial"), py::arg("g"));
}

void bind_body(py::module_& m) {
  using plasticity::Body;
  py::class_<Body>(m, "Body")
      .def(py::init<Material>(), py::arg("substrate"))
      .def(py::init(&body_of), py::arg("substrate"), py::arg("layers"))
      .def_property_readonly("stack", &Body::stack);
  py::implicitly_convertible<Material, Body>();
}

}  // namespace

void bind_plasticity(py::module_& m) {
  bind_descriptions(m);
  py::class_<Elastic>(m, "Elastic")
      .def_static("isotropic", &Elastic::isotropic, py::arg("E"), py::arg("nu"))
      .def_static("rigid", &Elastic::rigid)
      .def_readonly("E", &Elastic::E)
      .def_readonly("nu", &Elastic::nu);
  bind_stack(m);
  bind_material(m);
  bind_body(m);
}

}  // namespace samcontact::bindings
