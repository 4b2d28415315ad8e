// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "long_work.hpp"
#include "parts.hpp"
#include "rooms.hpp"
#include "samcontact/simulation/simulation.hpp"
#include "samcontact/simulation/state/description.hpp"
#include "softening.hpp"
#include "typed.hpp"

namespace samcontact::bindings {

namespace {

using simulation::Counters;
using simulation::Settings;
using simulation::Simulation;
using simulation::State;
using simulation::Target;

/// Each None or (heights (rows, ny), first row, whether periodic, worn depth or None).
using ReliefTuple = std::tuple<Array, int, bool, MaybeArray>;
simulation::Reliefs to_reliefs(const std::array<std::optional<ReliefTuple>, 2>& given) {
  simulation::Reliefs reliefs;
  for (int b = 0; b < 2; ++b) {
    const std::optional<ReliefTuple>& relief = given[b];
    if (!relief) continue;
    const auto& [heights, first_row, periodic, worn] = *relief;
    reliefs[b] = {to_field(heights), static_cast<int>(heights.shape(0)), first_row, periodic,
                  to_field_or_empty(worn)};
  }
  return reliefs;
}

/// Each None or (first cell, index of each cell among the mixed cells [k][i][j] or -1, constants of
/// the mixed cells by row: bulk, shear, share, six misfit strains, index of the material, normal,
/// misfit strain per kelvin; materials).
using InclusionsTuple =
    std::tuple<std::array<int, 3>, py::array_t<std::int32_t, py::array::c_style>, Array,
               std::vector<plasticity::Material>>;
simulation::InclusionsPair to_inclusions(
    const std::array<std::optional<InclusionsTuple>, 2>& given) {
  simulation::InclusionsPair inclusions;
  for (int b = 0; b < 2; ++b) {
    const std::optional<InclusionsTuple>& body = given[b];
    if (!body) continue;
    const auto& [first, number, constants, materials] = *body;
    const Box box{first[0], first[1], static_cast<int>(number.shape(1)),
                  static_cast<int>(number.shape(2)), static_cast<int>(number.shape(0))};
    std::vector<plasticity::MixedCell> cells(constants.shape(0));
    for (std::size_t n = 0; n < cells.size(); ++n) {
      const double* row = constants.data(static_cast<py::ssize_t>(n), 0);
      cells[n] = {row[0], row[1], row[2], {}, static_cast<int>(row[9]), {row[10], row[11], row[12]},
                  row[13]};
      std::copy_n(row + 3, 6, cells[n].misfit.begin());
    }
    inclusions[b] = std::make_shared<const simulation::Inclusions>(
        box, first[2], std::vector<std::int32_t>(number.data(), number.data() + number.size()),
        std::move(cells), materials);
  }
  return inclusions;
}

State step(Simulation& simulation, const contact::Drive& drive, const MaybeArray& pressure,
           const MaybeArray& shear_x, const MaybeArray& shear_y,
           const operators::HeatingPair& heating, double duration,
           const std::array<std::array<double, 2>, 2>& advance, const std::array<bool, 3>& is_force,
           const std::array<double, 3>& tangential, double lasts) {
  const Target target{.drive = drive,
                      .tangential = contact::tangential_drive(is_force, tangential),
                      .tractions = {to_field_or_empty(pressure), to_field_or_empty(shear_x),
                                    to_field_or_empty(shear_y)},
                      .advance = {advance[0], advance[1]},
                      .heating = heating,
                      .duration = duration,
                      .lasts = lasts};
  const LongWork work;
  return simulation.step(target);
}

Content counters(const Simulation& simulation) {
  PartWriter visit;
  describe(simulation.counters(), visit);
  visit.content["volume_bytes"] = simulation.volume_bytes();
  return visit.content;
}

/// Sets state and counters from their content; heating: that of the state.
void restore(Simulation& simulation, const Content& content, const Content& counters,
             const operators::HeatingPair& heating) {
  State state(simulation.shared_setup(), operators::ResidualMethod::fast);
  state.heating = heating;
  PartReader of_state(content);
  describe(state, of_state);
  of_state.require_no_more();
  if (state.duration > 0) {
    for (auto& heat : state.heating) heat.age = state.duration;
  }
  require_consistent(state);
  Counters work;
  PartReader of_work(counters);
  describe(work, of_work);
  simulation.restore(state, work);
}

void bind_settings(py::module_& m) {
  py::class_<Settings>(m, "Settings")
      .def(py::init([](double tol, double increment_tol, int max_iterations,
                       const std::string& on_border, const std::string& on_stall,
                       const std::string& residual_stress, double image_tol, bool one_zone,
                       int reach) {
             using operators::ResidualMethod;
             return Settings{.tol = tol,
                             .increment_tol = increment_tol,
                             .max_iterations = max_iterations,
                             .on_border = on_border == "error" ? contact::OnBorder::error
                                                               : contact::OnBorder::warn,
                             .accepts_stall = on_stall == "warn",
                             .residual_stress = residual_stress == "exact" ? ResidualMethod::exact
                                                                           : ResidualMethod::fast,
                             .image_tol = image_tol,
                             .reach = reach,
                             .one_zone = one_zone};
           }),
           py::kw_only(), py::arg("tol"), py::arg("increment_tol"), py::arg("max_iterations"),
           py::arg("on_border"), py::arg("on_stall"), py::arg("residual_stress"),
           py::arg("image_tol"), py::arg("one_zone"), py::arg("reach"));
}

}  // namespace

void bind_simulation(py::module_& m) {
  bind_state(m);
  bind_settings(m);
  py::class_<Simulation>(m, "Simulation")
      .def(py::init([](const Grid& grid, const plasticity::Body& body1,
                       const plasticity::Body& body2, const Array& gap,
                       const contact::FrictionLaw& friction, Settings settings,
                       const std::array<double, 4>& march,
                       const std::array<std::optional<SofteningFunction>, 2>& softening,
                       const std::array<std::optional<ReliefTuple>, 2>& reliefs,
                       const std::shared_ptr<contact::ContactLaw>& contact_law,
                       const std::array<std::optional<InclusionsTuple>, 2>& inclusions) {
             for (int b = 0; b < 2; ++b) {
               if (softening[b]) settings.softening[b] = softening_law(*softening[b], grid);
             }
             const Team team;
             return std::make_unique<Simulation>(
                 grid, body1, body2, to_field(gap), friction, settings,
                 simulation::TransientHeating{march[0], march[1], {march[2], march[3]}},
                 to_reliefs(reliefs), contact_law, to_inclusions(inclusions));
           }),
           py::kw_only(), py::arg("grid"), py::arg("body1"), py::arg("body2"), py::arg("gap"),
           py::arg("friction"), py::arg("settings"), py::arg("march"), py::arg("softening"),
           py::arg("reliefs"), py::arg("contact_law"), py::arg("inclusions"))
      .def("step", &step, py::arg("drive"), py::arg("pressure"), py::arg("shear_x"),
           py::arg("shear_y"), py::arg("heating"), py::arg("duration"), py::arg("advance"),
           py::arg("is_force"), py::arg("tangential"), py::arg("lasts"))
      .def(
          "set_plastic_state",
          [](Simulation& s, int body, int first_row, const Array& strain,
             const MaybeArray& equivalent, const MaybeArray& backstress) {
            const Box box{first_row, 0, static_cast<int>(strain.shape(2)), s.setup().grid.ny,
                          static_cast<int>(strain.shape(1))};
            s.set_plastic_state(body, box, to_field(strain), to_field_or_empty(equivalent),
                                to_field_or_empty(backstress));
          },
          py::arg("body"), py::arg("first_row"), py::arg("strain"), py::arg("equivalent"),
          py::arg("backstress"))
      .def(
          "add_eigenstrain",
          [](Simulation& s, int body, const std::array<int, 3>& first, const Array& strain) {
            const Box box{first[0], first[1], static_cast<int>(strain.shape(2)),
                          static_cast<int>(strain.shape(3)), static_cast<int>(strain.shape(1))};
            s.add_eigenstrain(body, box, first[2], to_field(strain));
          },
          py::arg("body"), py::arg("first"), py::arg("strain"))
      .def_property_readonly("state", [](const Simulation& s) { return s.state(); })
      .def_property_readonly("tilt", [](const Simulation& s) { return s.state().tilt; })
      .def_property_readonly("counters", &counters)
      .def("restore", &restore, py::arg("content"), py::arg("counters"), py::arg("heating"))
      .def(
          "take_over",
          [](Simulation& s, const Simulation& smaller) {
            s.restore(smaller.state().widened(s.shared_setup()), smaller.counters());
          },
          py::arg("smaller"))
      .def(
          "stand_at", [](Simulation& s, const State& state) { s.restore(state, s.counters()); },
          py::arg("state"));
}

}  // namespace samcontact::bindings
