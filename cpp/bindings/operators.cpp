// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <array>
#include <complex>
#include <stdexcept>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "long_work.hpp"
#include "rooms.hpp"
#include "samcontact/base/errors.hpp"
#include "samcontact/kernels/heated_wave.hpp"
#include "samcontact/operators/heat/temperature.hpp"
#include "samcontact/operators/medium/finite_body.hpp"
#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/operators/surface/surface_displacement.hpp"
#include "samcontact/operators/volume/volume_operators.hpp"
#include "samcontact/operators/zones/zone_operators.hpp"

namespace samcontact::bindings {

namespace {

Values residual_stress(const Grid& grid, const Array& strain, const Elastic& elastic, bool exact,
                       double image_tol) {
  const Field field = to_field(strain);
  Field stress;
  {
    const LongWork work;
    using operators::ResidualMethod;
    const operators::VolumeOperators volume(
        grid, operators::half_space(elastic),
        {operators::Tensor::full, operators::Symmetry::none,
         exact ? ResidualMethod::exact : ResidualMethod::fast, image_tol});
    stress = volume.stress(field.data(), nullptr, 1.0);
  }
  return tensor_array(std::move(stress), grid, grid.nz);
}

/// Fast residual stress in a box of cells that begins below the surface.
class ResidualBox {
 public:
  /// above: number of layers between the surface and the box.
  ResidualBox(const Grid& grid, int above, const Elastic& elastic, double image_tol)
      : grid_(below(grid, above)),
        volume_(grid_, operators::half_space(elastic),
                {operators::Tensor::full,
                 operators::Symmetry::none,
                 operators::ResidualMethod::fast,
                 image_tol,
                 {}}) {}

  Values stress(const Array& strain) const {
    const Field field = to_field(strain);
    if (field.size() != 6 * grid_.volume_size()) {
      throw std::invalid_argument("strain must have six components on the cells of the box");
    }
    Field out;
    {
      const LongWork work;
      out = volume_.stress(field.data(), nullptr, 1.0);
    }
    return tensor_array(std::move(out), grid_, grid_.nz);
  }

 private:
  static Grid below(Grid grid, int above) {
    require(above >= 0, "above", ">= 0 layers", above);
    grid.k0 = above;
    return grid;
  }

  Grid grid_;
  operators::VolumeOperators volume_;
};

/// Axis 0, 1 or 2: along x, y or z.
Values residual_displacement(const Grid& grid, const Array& strain, double nu, int axis) {
  const Field field = to_field(strain);
  Field out(grid.surface_size());
  {
    const LongWork work;
    const operators::VolumeOperators volume(grid, operators::half_space({1.0, nu}), {});
    operators::VolumeSpectrum spectrum = volume.make_spectrum();
    operators::forward(volume.transform(), field.data(), spectrum);
    volume.residual_displacement(static_cast<operators::Axis>(axis)).apply(spectrum, out.data());
  }
  return surface_array(std::move(out), grid);
}

/// axis: 0, 1 or 2 along x, y or z.
Values surface_displacement(const Grid& grid, const plasticity::Body& body,
                            const operators::Heating& heating, const Array& pressure,
                            const MaybeArray& shear_x, const MaybeArray& shear_y, int axis) {
  const operators::Tractions tractions{to_field(pressure), to_field_or_empty(shear_x),
                                       to_field_or_empty(shear_y)};
  Field out;
  {
    const LongWork work;
    out = operators::surface_displacement(grid, *operators::medium_of(body), heating, tractions,
                                          1.0, static_cast<operators::Axis>(axis));
  }
  return surface_array(std::move(out), grid);
}

Values surface_stress(const Grid& grid, const plasticity::Body& body,
                      const operators::Heating& heating, const std::vector<double>& z,
                      const Array& pressure, const MaybeArray& shear_x, const MaybeArray& shear_y) {
  const operators::Tractions tractions{to_field(pressure), to_field_or_empty(shear_x),
                                       to_field_or_empty(shear_y)};
  Field out;
  {
    const LongWork work;
    out = operators::traction_stress(grid, operators::medium_of(body), heating, z, tractions);
  }
  return tensor_array(std::move(out), grid, static_cast<py::ssize_t>(z.size()));
}

/// Stress in zones (i0, j0, nx, ny, nz), 0 elsewhere, due to a strain and to tractions on body 2,
/// and displacement [axis][i][j] due to the strain, by the operators of zones.
std::pair<Values, Values> zone_fields(const Grid& grid, const Elastic& elastic,
                                      const std::vector<std::array<int, 5>>& boxes,
                                      const Array& strain, const MaybeArray& pressure,
                                      const MaybeArray& shear_x, const MaybeArray& shear_y,
                                      double image_tol) {
  const Field field = to_field(strain);
  const operators::Tractions tractions{to_field_or_empty(pressure), to_field_or_empty(shear_x),
                                       to_field_or_empty(shear_y)};
  Field stress(6 * grid.volume_size(), 0.0), displacement(3 * grid.surface_size(), 0.0);
  {
    const LongWork work;
    const Box whole = Box::whole(grid);
    std::vector<Box> zones;
    zones.reserve(boxes.size());
    for (const auto& [i0, j0, nx, ny, nz] : boxes) {
      const bool inside = i0 >= 0 && j0 >= 0 && nx > 0 && ny > 0 && nz > 0 && nx <= grid.nx - i0 &&
                          ny <= grid.ny - j0 && nz <= grid.nz;
      if (!inside) {
        throw std::invalid_argument(
            "each zone (i0, j0, nx, ny, nz) must have nx, ny, nz > 0 and lie inside the grid, "
            "got " +
            to_text(i0) + ", " + to_text(j0) + ", " + to_text(nx) + ", " + to_text(ny) + ", " +
            to_text(nz));
      }
      zones.push_back({i0, j0, nx, ny, nz});
    }
    operators::ZoneOperators operators(
        std::make_shared<const operators::ZoneTables>(grid, operators::half_space(elastic),
                                                      operators::Tensor::full, image_tol),
        zones);
    Field own(6 * operators.cells());
    std::size_t first = 0;
    for (const Box& zone : zones) {
      for (int c = 0; c < 6; ++c) {
        extract(field.data() + c * grid.volume_size(), whole,
                own.data() + c * operators.cells() + first, zone);
      }
      first += zone.volume_size();
    }
    operators.transform(own, operators::all_axes);
    for (const operators::Axis axis : operators::all_axes) {
      const auto place = static_cast<std::size_t>(axis) * grid.surface_size();
      operators.displacement(axis, displacement.data() + place);
    }
    operators.for_each_layer(&own, tractions, 1.0, [&](std::size_t z, int k, const double* layer) {
      Box plane = zones[z];
      plane.nz = 1;
      for (int c = 0; c < 6; ++c) {
        insert(layer + c * plane.surface_size(), plane,
               stress.data() + c * grid.volume_size() + k * grid.surface_size(),
               Box::surface(grid));
      }
    });
  }
  const py::ssize_t nx = grid.nx, ny = grid.ny;
  return {tensor_array(std::move(stress), grid, grid.nz),
          bindings::own(std::move(displacement), {py::ssize_t{3}, nx, ny},
                        {item * nx * ny, item * ny, item})};
}

/// Fields [6][mode] of Fourier modes of heat flux: temperature, stress 11, 22, 33 and i s_13 at a
/// depth, and u_z of the surface.
py::array_t<std::complex<double>> heated_wave(const Stack& body, const operators::Heating& heating,
                                              const std::vector<double>& q,
                                              const std::vector<std::complex<double>>& rate,
                                              double z) {
  const HeatedStack stack = HeatedStack::of(body, heating.thermal);
  kernels::HeatedWave<std::complex<double>> wave(stack);
  const auto count = static_cast<py::ssize_t>(q.size());
  py::array_t<std::complex<double>> out({py::ssize_t{6}, count});
  auto to = out.mutable_unchecked<2>();
  for (py::ssize_t n = 0; n < count; ++n) {
    wave.set(q[n], rate[n]);
    const auto [temperature, s11, s22, s33, shear] = wave.at(stack.elastic.layer_at(z), z);
    const std::array all{temperature, s11, s22, s33, shear, wave.displacement()};
    for (py::ssize_t c = 0; c < 6; ++c) to(c, n) = all[c];
  }
  return out;
}

Values temperature(const Grid& grid, const operators::Heating& heating,
                   const std::vector<double>& z, const Array& pressure) {
  const Field p = to_field(pressure);
  Field rise;
  {
    const LongWork work;
    rise = operators::Temperature(grid, heating).rise(p.data(), z);
  }
  return volume_array(std::move(rise), grid, static_cast<py::ssize_t>(z.size()));
}

}  // namespace

namespace {

using operators::HeatHistory;

/// Heat history with the shapes of its arrays, which the core does not store.
struct BoundHistory {
  Grid grid;
  HeatHistory history;

  Values temperature(double ahead, const std::vector<double>& z) const {
    Field rise;
    {
      const LongWork work;
      rise = history.temperature(ahead, z);
    }
    return volume_array(std::move(rise), grid, static_cast<py::ssize_t>(z.size()));
  }
  Values displacement(double ahead) const {
    Field u;
    {
      const LongWork work;
      u = history.displacement(ahead);
    }
    return surface_array(std::move(u), grid);
  }
  Values stress(double ahead, const std::vector<double>& z) const {
    Field stress;
    {
      const LongWork work;
      stress = history.stress(ahead, z);
    }
    return tensor_array(std::move(stress), grid, static_cast<py::ssize_t>(z.size()));
  }
};

void bind_heat_history(py::module_& m) {
  py::class_<BoundHistory>(m, "HeatHistory")
      .def(py::init([](const Grid& grid, const operators::Heating& heating, const Stack& elastic,
                       double shortest, double longest, double tolerance, bool in_depth,
                       const operators::PlaneVector& track) {
             const LongWork work;
             return BoundHistory{
                 grid, operators::heated_body(elastic)->history(
                           grid, heating, {shortest, longest, tolerance, in_depth, track})};
           }),
           py::arg("grid"), py::arg("heating"), py::arg("elastic"), py::arg("shortest"),
           py::arg("longest"), py::arg("tolerance"), py::arg("in_depth"),
           py::arg("track") = operators::PlaneVector{})
      .def(
          "add",
          [](BoundHistory& self, const Array& flux, double dt,
             const operators::PlaneVector& speed) {
            const Field q = to_field(flux);
            const LongWork work;
            self.history.add(q.data(), dt, speed);
          },
          py::arg("flux"), py::arg("dt"), py::arg("speed") = operators::PlaneVector{})
      .def(
          "move",
          [](BoundHistory& self, const operators::PlaneVector& by) { self.history.move(by); },
          py::arg("by"))
      .def("temperature", &BoundHistory::temperature, py::arg("ahead"), py::arg("z"))
      .def("displacement", &BoundHistory::displacement, py::arg("ahead"))
      .def("stress", &BoundHistory::stress, py::arg("ahead"), py::arg("z"))
      .def("copy", [](const BoundHistory& self) { return self; })
      .def("state",
           [](const BoundHistory& self) {
             const std::vector<double> state = self.history.state();
             return Array(static_cast<py::ssize_t>(state.size()), state.data());
           })
      .def(
          "set_state",
          [](BoundHistory& self, const Array& state) { self.history.set_state(numbers_of(state)); },
          py::arg("state"))
      .def_property_readonly("size", [](const BoundHistory& self) { return self.history.size(); });
}

}  // namespace

namespace {

/// From conductivity, expansion and diffusivity of each layer, the substrate last, and the
/// thicknesses of the layers.
ThermalStack thermal_stack(const std::vector<std::array<double, 3>>& constants,
                           const std::vector<double>& thickness) {
  const auto of = [](const std::array<double, 3>& c) { return Thermal::of(c[0], c[1], c[2]); };
  if (constants.size() != thickness.size() + 1) {
    throw std::invalid_argument(
        "thermal must contain one set of constants more than thickness, got " +
        std::to_string(constants.size()) + " and " + std::to_string(thickness.size()));
  }
  ThermalStack stack{{}, of(constants.back())};
  for (std::size_t n = 0; n < thickness.size(); ++n) {
    stack.layers.push_back({of(constants[n]), thickness[n]});
  }
  return stack;
}

}  // namespace

void bind_heating(py::module_& m) {
  using operators::Heating;
  py::class_<Heating>(m, "Heating")
      .def(py::init<>())
      .def(py::init([](double factor, const std::vector<std::array<double, 3>>& thermal,
                       const std::vector<double>& thickness, double speed_x, double speed_y,
                       double age, double reference, bool of_slip,
                       std::pair<double, double> period) {
             return Heating{factor,       thermal_stack(thermal, thickness),
                            speed_x,      speed_y,
                            age,          reference,
                            of_slip,      period.first,
                            period.second};
           }),
           py::arg("factor"), py::arg("thermal"), py::arg("thickness"), py::arg("speed_x"),
           py::arg("speed_y"), py::arg("age"), py::arg("reference"), py::arg("of_slip"),
           py::arg("period") = std::pair(0.0, 0.0))
      .def_readonly("factor", &Heating::factor);
}

void bind_operators(py::module_& parent) {
  auto m = parent.def_submodule("operators");
  bind_heat_history(m);
  py::class_<ResidualBox>(m, "ResidualBox")
      .def(py::init<Grid, int, const Elastic&, double>(), py::arg("grid"), py::arg("above"),
           py::arg("elastic"), py::arg("image_tol"))
      .def("stress", &ResidualBox::stress, py::arg("strain"));
  m.def("residual_stress", &residual_stress, py::arg("grid"), py::arg("strain"), py::arg("elastic"),
        py::arg("exact"), py::arg("image_tol"));
  m.def("residual_displacement", &residual_displacement, py::arg("grid"), py::arg("strain"),
        py::arg("nu"), py::arg("axis"));
  m.def("surface_displacement", &surface_displacement, py::arg("grid"), py::arg("body"),
        py::arg("heating"), py::arg("pressure"), py::arg("shear_x"), py::arg("shear_y"),
        py::arg("axis"));
  m.def("zone_fields", &zone_fields, py::arg("grid"), py::arg("elastic"), py::arg("zones"),
        py::arg("strain"), py::arg("pressure"), py::arg("shear_x"), py::arg("shear_y"),
        py::arg("image_tol"));
  m.def("temperature", &temperature, py::arg("grid"), py::arg("heating"), py::arg("z"),
        py::arg("pressure"));
  m.def("heated_wave", &heated_wave, py::arg("body"), py::arg("heating"), py::arg("q"),
        py::arg("rate"), py::arg("z"));
  m.def("surface_stress", &surface_stress, py::arg("grid"), py::arg("body"), py::arg("heating"),
        py::arg("z"), py::arg("pressure"), py::arg("shear_x"), py::arg("shear_y"));
}

}  // namespace samcontact::bindings
