// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "long_work.hpp"
#include "rooms.hpp"
#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/contact/creeping_contact.hpp"
#include "samcontact/contact/outline.hpp"
#include "samcontact/contact/paraboloid.hpp"
#include "samcontact/contact/partial_slip_contact.hpp"
#include "samcontact/operators/medium/finite_body.hpp"
#include "samcontact/operators/surface/creeping_tractions.hpp"
#include "typed.hpp"

namespace samcontact::bindings {

namespace {

using contact::ContactSolver;
using contact::Drive;

/// Fields of a ContactSolution.
Content to_python(contact::Solution solution, const Grid& grid, const contact::ContactLaw& law) {
  Content result;
  Field repulsion;
  if (law.attracts()) {
    repulsion = contact::repulsion(law, solution.tractions.pressure, solution.gap);
  }
  const Values pressure = surface_array(std::move(solution.tractions.pressure), grid);
  result["pressure"] = pressure;
  result["repulsion"] = law.attracts() ? surface_array(std::move(repulsion), grid) : pressure;
  result["gap"] = surface_array(std::move(solution.gap), grid);
  result["approach"] = solution.motion.approach;
  result["tilt"] = py::array_t<double>(2, solution.motion.tilt.data());
  result["moment"] = py::array_t<double>(2, solution.moment.data());
  result["load"] = solution.load;
  result["error"] = solution.error;
  result["iterations"] = solution.iterations;
  result["operator_applications"] = solution.operator_applications;
  result["work"] = solution.work;
  result["converged"] = solution.converged;
  result["border_complaint"] = solution.edge_warning;
  return result;
}

template <class Solver>
Content solve(const Solver& solver, const Array& gap, const Drive& drive,
              const MaybeArray& initial_pressure, double tol, int max_iterations,
              bool error_on_border) {
  const Field h = to_field(gap), start = to_field_or_empty(initial_pressure);
  const contact::ContactSettings settings{
      tol, max_iterations, error_on_border ? contact::OnBorder::error : contact::OnBorder::warn};
  contact::Solution solution;
  {
    const LongWork work;
    solution = solver.solve(h, drive, start, settings);
  }
  return to_python(std::move(solution), solver.grid(), solver.law());
}

py::array_t<bool> flags_array(const std::vector<unsigned char>& flags, const Grid& grid) {
  py::array_t<bool> array({grid.nx, grid.ny});
  std::copy(flags.begin(), flags.end(), array.mutable_data());
  return array;
}

/// Fields of a PartialSlipSolution, without the totals of earlier increments.
Content to_python(contact::PartialSlipSolution solution,
                  const contact::PartialSlipContact& contact) {
  auto& normal = solution.normal;
  auto& tangential = solution.tangential;
  const Grid& grid = contact.grid();
  Content result = to_python(std::move(normal), grid, contact.law());
  result["shear"] = vector_array(std::move(tangential.shear), grid);
  result["slip"] = vector_array(std::move(tangential.slip), grid);
  result["sticking"] = flags_array(tangential.sticking, grid);
  result["motion"] = tangential.motion;
  result["force"] = tangential.force;
  result["friction_work"] = tangential.friction_work;
  result["tangential_error"] = tangential.error;
  result["energy_gap"] = tangential.energy_gap;
  result["tangential_iterations"] = tangential.iterations;
  result["tangential_applications"] = tangential.operator_applications;
  result["tangential_work"] = tangential.work;
  result["fallbacks"] = tangential.fallbacks;
  result["sweeps"] = solution.sweeps;
  result["joint_steps"] = solution.joint.steps;
  if (!solution.slip_rate.empty()) {
    result["slip_rate"] = surface_array(std::move(solution.slip_rate), grid);
    result["falling_number"] = solution.falling_number;
  }
  if (!solution.plastic_slip.empty()) {
    result["plastic_slip"] = surface_array(std::move(solution.plastic_slip), grid);
  }
  return result;
}

contact::ContactSettings slip_settings(double tol, int max_iterations, bool error_on_border,
                                       bool accept_stall) {
  return {tol, max_iterations, error_on_border ? contact::OnBorder::error : contact::OnBorder::warn,
          accept_stall ? contact::AfterStall::accept : contact::AfterStall::join};
}

Content stick_and_slip(const contact::PartialSlipContact& contact, const Array& gap,
                       const Drive& drive, const std::array<bool, 3>& is_force,
                       const std::array<double, 3>& tangential, const MaybeArray& pressure,
                       const MaybeArray& shear, const MaybeArray& gap_before,
                       double approach_before, const contact::AboutAxes& tilt_before,
                       bool has_moved, const MaybeArray& initial_pressure, double tol,
                       int max_iterations, bool error_on_border, bool accept_stall, double duration,
                       const MaybeArray& slip_rate, bool selects, const MaybeArray& plastic_slip) {
  const Field h = to_field(gap);
  const contact::PartialSlipStart start{.pressure = to_field_or_empty(initial_pressure)};
  const contact::ContactHistory before{to_field_or_empty(pressure),
                                       to_field_or_empty(shear),
                                       to_field_or_empty(gap_before),
                                       {approach_before, tilt_before},
                                       has_moved};
  const auto settings = slip_settings(tol, max_iterations, error_on_border, accept_stall);
  const contact::FrictionConditions conditions{
      {}, duration, to_field_or_empty(slip_rate), to_field_or_empty(plastic_slip), selects};
  contact::PartialSlipSolution solution;
  {
    const LongWork work;
    solution = contact.solve(h, drive, contact::tangential_drive(is_force, tangential), before,
                             start, settings, conditions);
  }
  return to_python(std::move(solution), contact);
}

Content roll(const contact::PartialSlipContact& contact, const Array& gap, const Drive& drive,
             const std::array<bool, 3>& is_force, const std::array<double, 3>& tangential,
             const MaybeArray& pressure, const MaybeArray& shear,
             const std::array<double, 3>& creepage, double tol, int max_iterations,
             bool error_on_border, bool accept_stall, double duration,
             const MaybeArray& displacement) {
  const Field h = to_field(gap), moved = to_field_or_empty(displacement);
  const contact::PartialSlipStart start{
      to_field_or_empty(pressure), to_field_or_empty(shear), {}, creepage};
  const auto settings = slip_settings(tol, max_iterations, error_on_border, accept_stall);
  const contact::FrictionConditions conditions{{}, duration, {}, {}, false};
  contact::PartialSlipSolution solution;
  {
    const LongWork work;
    solution = contact.roll(h, drive, contact::tangential_drive(is_force, tangential), start,
                            settings, conditions, moved);
  }
  return to_python(std::move(solution), contact);
}

/// Shear s_x on body 2 that follows from a pressure; None without friction.
std::optional<Values> shear(const ContactSolver& solver, const Array& pressure) {
  Field along_x = solver.friction().tractions(to_field(pressure)).shear_x;
  if (along_x.empty()) return {};
  return surface_array(std::move(along_x), solver.grid());
}

contact::Cells cells_of(const Array& field, bool along_x, bool along_y) {
  return {static_cast<int>(field.shape(0)), static_cast<int>(field.shape(1)), along_x, along_y};
}

/// Cells, sides, reach, whether the pressure rises to a side, and the largest pressure.
std::tuple<std::size_t, std::size_t, int, bool, double> outline(const Array& pressure, bool along_x,
                                                                bool along_y, double rise) {
  const auto found =
      contact::outline(numbers_of(pressure), cells_of(pressure, along_x, along_y), rise);
  return {found.cells, found.sides, found.reach, found.rises, found.largest};
}

bool may_have_steps(const Array& heights, bool along_x, bool along_y, double ratio) {
  return contact::may_have_steps(numbers_of(heights), cells_of(heights, along_x, along_y), ratio);
}

/// Larger and smaller radius, cosine and reach of the paraboloid that approximates a gap.
std::optional<std::tuple<double, double, double, std::pair<double, double>>> paraboloid_of(
    const Array& gap, const Grid& grid, double on_grid, double at_reach) {
  const auto found = contact::fitted_paraboloid(numbers_of(gap), grid, {on_grid, at_reach});
  if (!found) return {};
  return std::tuple{found->larger, found->smaller, found->cosine,
                    std::pair{found->reach[0], found->reach[1]}};
}

void bind_outline(py::module_& m) {
  m.def("paraboloid_of", &paraboloid_of, py::arg("gap"), py::arg("grid"), py::arg("on_grid"),
        py::arg("at_reach"));
  m.def("contact_outline", &outline, py::arg("pressure"), py::arg("along_x"), py::arg("along_y"),
        py::arg("rise"));
  m.def("may_have_steps", &may_have_steps, py::arg("heights"), py::arg("along_x"),
        py::arg("along_y"), py::arg("ratio"));
}

void bind_friction(py::module_& m) {
  using contact::FrictionLaw;
  m.def("friction_laws", [] {
    std::vector<std::tuple<std::string, bool, std::vector<LawParameter>>> laws;
    for (const auto& law : FrictionLaw::descriptions()) {
      laws.emplace_back(law.name, law.sticks, law.parameters);
    }
    return laws;
  });
  py::class_<FrictionLaw>(m, "FrictionLaw")
      .def(py::init(&FrictionLaw::named), py::arg("name"), py::arg("values"))
      .def("ratio", &FrictionLaw::ratio, py::arg("pressure"))
      .def(
          "bound",
          [](const FrictionLaw& law, const Array& pressure) {
            const std::vector<py::ssize_t> shape(pressure.shape(),
                                                 pressure.shape() + pressure.ndim());
            py::array_t<double> out(shape);
            const Field bound = law.bound(to_field(pressure));
            std::copy(bound.begin(), bound.end(), out.mutable_data());
            return out;
          },
          py::arg("pressure"));
}

void bind_creeping(py::module_& m) {
  using operators::MovingCreep;
  py::class_<MovingCreep>(m, "MovingCreep")
      .def(py::init(
               [](std::vector<double> amounts, std::vector<double> distances, bool towards_plus_x) {
                 return MovingCreep{std::move(amounts), std::move(distances), towards_plus_x};
               }),
           py::arg("amounts"), py::arg("distances"), py::arg("towards_plus_x"));
  using operators::CreepingTractions;
  py::class_<CreepingTractions>(m, "CreepingTractions")
      .def(py::init([](const Grid& grid, const plasticity::Body& body1,
                       const plasticity::Body& body2, const MovingCreep& creep1,
                       const MovingCreep& creep2) {
             return std::make_unique<CreepingTractions>(
                 grid,
                 std::array<operators::CreepingBody, 2>{{{operators::medium_of(body1), creep1},
                                                         {operators::medium_of(body2), creep2}}});
           }),
           py::arg("grid"), py::arg("body1"), py::arg("body2"), py::arg("creep1"),
           py::arg("creep2"))
      .def(
          "displacement",
          [](const CreepingTractions& bodies, const Array& pressure, const Array& shear) {
            return vector_array<3>(bodies.displacement(to_field(pressure), to_field(shear)),
                                   bodies.grid());
          },
          py::arg("pressure"), py::arg("shear"));
  py::class_<contact::CreepingContact>(m, "CreepingContact")
      .def(py::init([](const Grid& grid, const plasticity::Body& body1,
                       const plasticity::Body& body2, const MovingCreep& creep1,
                       const MovingCreep& creep2) {
             std::vector<operators::CreepingBody> bodies{{operators::medium_of(body1), creep1},
                                                         {operators::medium_of(body2), creep2}};
             return std::make_unique<contact::CreepingContact>(grid, std::move(bodies));
           }),
           py::arg("grid"), py::arg("body1"), py::arg("body2"), py::arg("creep1"),
           py::arg("creep2"))
      .def(
          "displacement",
          [](const contact::CreepingContact& solver, const Array& pressure) {
            return surface_array(solver.displacement(to_field(pressure)), solver.grid());
          },
          py::arg("pressure"))
      .def("solve", &solve<contact::CreepingContact>, py::arg("gap"), py::arg("drive"),
           py::arg("initial_pressure"), py::arg("tol"), py::arg("max_iterations"),
           py::arg("error_on_border"));
}

void bind_partial_slip(py::module_& m) {
  m.attr("spin_lead") = contact::spin_lead;
  py::class_<contact::PartialSlipContact>(m, "PartialSlipContact")
      .def(py::init([](const Grid& grid, const plasticity::Body& body1,
                       const plasticity::Body& body2, const contact::FrictionLaw& friction,
                       const std::shared_ptr<contact::ContactLaw>& law) {
             return std::make_unique<contact::PartialSlipContact>(
                 grid, operators::medium_of(body1), operators::medium_of(body2), friction, law);
           }),
           py::arg("grid"), py::arg("body1"), py::arg("body2"), py::arg("friction"),
           py::arg("contact_law"))
      .def_property_readonly("is_coupled", &contact::PartialSlipContact::is_coupled)
      .def("solve", &stick_and_slip, py::arg("gap"), py::arg("drive"), py::arg("is_force"),
           py::arg("tangential"), py::arg("previous_pressure"), py::arg("previous_shear"),
           py::arg("previous_gap"), py::arg("previous_approach"), py::arg("previous_tilt"),
           py::arg("has_moved"), py::arg("initial_pressure"), py::arg("tol"),
           py::arg("max_iterations"), py::arg("error_on_border"), py::arg("accept_stall"),
           py::arg("duration") = 0.0, py::arg("slip_rate") = py::none(), py::arg("selects") = false,
           py::arg("plastic_slip") = py::none())
      .def("roll", &roll, py::arg("gap"), py::arg("drive"), py::arg("is_force"),
           py::arg("tangential"), py::arg("initial_pressure"), py::arg("initial_shear"),
           py::arg("initial_creepage"), py::arg("tol"), py::arg("max_iterations"),
           py::arg("error_on_border"), py::arg("accept_stall"), py::arg("duration") = 0.0,
           py::arg("displacement") = py::none());
}

}  // namespace

void bind_contact(py::module_& m) {
  bind_outline(m);
  bind_friction(m);
  py::class_<contact::ContactLaw, std::shared_ptr<contact::ContactLaw>>(m, "ContactLaw")
      .def(py::init([](const std::string& kind, const std::vector<double>& parameters,
                       bool rubs_by_compression) {
             contact::SharedContactLaw law = contact::contact_law(kind, parameters);
             if (rubs_by_compression) law = contact::rubbing_by_compression(std::move(law));
             return std::const_pointer_cast<contact::ContactLaw>(law);
           }),
           py::arg("kind"), py::arg("parameters"), py::arg("rubs_by_compression") = false)
      .def_property_readonly("attracts", &contact::ContactLaw::attracts)
      .def_property_readonly("largest_attraction", &contact::ContactLaw::largest_attraction)
      .def_property_readonly("steepest_fall", &contact::ContactLaw::steepest_fall)
      .def_property_readonly("work",
                             [](const contact::ContactLaw& law) { return law.energy(1e300); });

  m.def(
      "self_influence",
      [](const Grid& grid, const plasticity::Body& body1, const plasticity::Body& body2) {
        operators::SurfaceInfluence influence;
        influence.add(operators::medium_of(body1));
        influence.add(operators::medium_of(body2));
        return influence.elastic(grid, operators::CellOffsets::lattice(1, 1))[0];
      },
      py::arg("grid"), py::arg("body1"), py::arg("body2"));

  py::class_<Drive>(m, "Drive")
      .def(py::init([](bool is_load, double value, const std::array<bool, 2>& is_moment,
                       const contact::AboutAxes& tilt, double spring) {
             Drive drive = is_load ? Drive::load(value) : Drive::approach(value);
             drive.spring = spring;
             for (int k = 0; k < 2; ++k) {
               drive.tilt[k] =
                   is_moment[k] ? contact::Given::force(tilt[k]) : contact::Given::motion(tilt[k]);
             }
             return drive;
           }),
           py::arg("is_load"), py::arg("value"), py::arg("is_moment"), py::arg("tilt"),
           py::arg("spring") = 0.0);

  py::class_<ContactSolver>(m, "ContactSolver")
      .def(py::init([](const Grid& grid, const plasticity::Body& body1,
                       const plasticity::Body& body2, const contact::FrictionLaw& friction,
                       const operators::HeatingPair& heating,
                       const std::shared_ptr<contact::ContactLaw>& law) {
             return std::make_unique<ContactSolver>(grid, operators::medium_of(body1),
                                                    operators::medium_of(body2), friction, heating,
                                                    law);
           }),
           py::arg("grid"), py::arg("body1"), py::arg("body2"), py::arg("friction"),
           py::arg("heating"), py::arg("contact_law"))
      .def("solve", &solve<ContactSolver>, py::arg("gap"), py::arg("drive"),
           py::arg("initial_pressure"), py::arg("tol"), py::arg("max_iterations"),
           py::arg("error_on_border"))
      .def("shear", &shear, py::arg("pressure"));
  bind_creeping(m);
  bind_partial_slip(m);
}

}  // namespace samcontact::bindings
