// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <memory>

#include "arrays.hpp"
#include "rooms.hpp"
#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/operators/half_space.hpp"

namespace samcontact::bindings {

namespace {

using contact::ContactSolver;
using contact::Drive;

py::dict solve(const ContactSolver& solver, const Array& gap, bool load_driven, double value,
               const py::object& initial_pressure, double tol, int max_iterations,
               bool error_on_border) {
  const Field h = to_field(gap), start = to_field_or_empty(initial_pressure);
  const contact::ContactSettings settings{
      tol, max_iterations, error_on_border ? contact::OnBorder::error : contact::OnBorder::warn};
  contact::Solution solution;
  {
    const py::gil_scoped_release release;
    solution =
        solver.solve(h, load_driven ? Drive::load(value) : Drive::approach(value), start, settings);
  }
  py::dict result;
  result["pressure"] = surface_array(std::move(solution.tractions.pressure), solver.grid());
  result["gap"] = surface_array(std::move(solution.gap), solver.grid());
  result["approach"] = solution.motion.approach;
  result["load"] = solution.load;
  result["error"] = solution.error;
  result["iterations"] = solution.iterations;
  result["operator_applications"] = solution.operator_applications;
  result["work"] = solution.work;
  result["converged"] = solution.converged;
  result["border_complaint"] = solution.border_complaint;
  return result;
}

/// Shear s_x on body 2 that goes with a pressure; None without friction.
py::object shear(const ContactSolver& solver, const Array& pressure) {
  Field along_x = solver.sliding().tractions(to_field(pressure)).shear_x;
  if (along_x.empty()) return py::none();
  return surface_array(std::move(along_x), solver.grid());
}

}  // namespace

void bind_contact(py::module_& m) {
  py::class_<ContactSolver>(m, "ContactSolver")
      .def(py::init([](const Grid& grid, const Elastic& body1, const Elastic& body2,
                       double friction, const operators::HeatingPair& heating) {
             return std::make_unique<ContactSolver>(grid, operators::half_space(body1),
                                                    operators::half_space(body2),
                                                    contact::GrossSliding(friction), heating);
           }),
           py::arg("grid"), py::arg("body1"), py::arg("body2"), py::arg("friction"),
           py::arg("heating"))
      .def("solve", &solve, py::arg("gap"), py::arg("load_driven"), py::arg("value"),
           py::arg("initial_pressure"), py::arg("tol"), py::arg("max_iterations"),
           py::arg("error_on_border"))
      .def("shear", &shear, py::arg("pressure"));
}

}  // namespace samcontact::bindings
