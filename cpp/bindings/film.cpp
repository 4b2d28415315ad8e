// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "long_work.hpp"
#include "rooms.hpp"
#include "samcontact/film/film_solver.hpp"
#include "samcontact/operators/medium/finite_body.hpp"
#include "typed.hpp"

namespace samcontact::bindings {
namespace {

using film::FilmSolver;
using film::LubricantTable;

film::FilmState to_state(const Content& given) {
  const auto field = [&](const char* name) { return to_field(given[name].cast<Array>()); };
  return {field("fluid_pressure"),
          field("boundary_pressure"),
          field("void_fraction"),
          {},
          given["approach"].cast<double>()};
}

/// Factor, fluidity, slope and added flow along x, then along y; empty for none.
film::PressureFlow to_pressure_flow(const std::vector<Array>& given) {
  if (given.empty()) return {};
  const auto faces = [&](std::size_t first) {
    const auto field = [&](std::size_t n) { return to_field(given.at(first + n)); };
    return film::PressureFlow::Faces{field(0), field(1), field(2), field(3)};
  };
  return {faces(0), faces(4)};
}

Content to_python(film::FilmSolution solution, const Grid& grid) {
  film::FilmState& state = solution.state;
  Content result;
  result["fluid_pressure"] = surface_array(std::move(state.fluid_pressure), grid);
  result["boundary_pressure"] = surface_array(std::move(state.boundary_pressure), grid);
  result["void_fraction"] = surface_array(std::move(state.void_fraction), grid);
  result["film"] = surface_array(std::move(state.film), grid);
  result["approach"] = state.approach;
  result["load"] = solution.load;
  result["error"] = solution.error;
  result["iterations"] = solution.iterations;
  result["krylov_steps"] = solution.krylov_steps;
  result["operator_applications"] = solution.applications;
  result["fill"] = solution.fill;
  result["converged"] = solution.converged;
  return result;
}

Content solve_film(FilmSolver& solver, const LubricantTable& lubricant, const Array& gap,
                   bool is_load, double target, const Array& along_x, const Array& along_y,
                   int order, double supply, double thinnest,
                   const std::pair<double, double>& layer, const Content& start, double tol,
                   int max_iterations, const std::pair<double, double>& time,
                   const MaybeArray& content, const std::vector<Array>& pressure_flow,
                   const std::pair<double, double>& order_change) {
  const Field undeformed = to_field(gap);
  const film::FaceVelocities velocities{to_field(along_x), to_field(along_y)};
  film::FlowSettings flow;
  flow.order = order;
  flow.supply = supply;
  flow.thinnest = thinnest;
  flow.first_order_below = order_change.first;
  flow.higher_order_above = order_change.second;
  flow.pressure_flow = to_pressure_flow(pressure_flow);
  film::FilmState state = to_state(start);
  Field earlier = to_field_or_empty(content);
  film::FilmSolution solution;
  {
    const LongWork work;
    solution = solver.solve(
        {undeformed, is_load, target}, velocities, lubricant, flow, {layer.first, layer.second},
        {time.first, time.second, std::move(earlier)}, std::move(state), {tol, max_iterations});
  }
  return to_python(std::move(solution), solver.grid());
}

/// Outflow of each cell [m^3/s], and its derivatives in the direction of given changes.
Values film_outflow(const Grid& grid, const LubricantTable& lubricant, const Array& along_x,
                    const Array& along_y, int order, double supply, double layer,
                    const std::vector<Array>& fields, const std::vector<Array>& pressure_flow) {
  film::FlowSettings flow;
  flow.pressure_flow = to_pressure_flow(pressure_flow);
  flow.order = order;
  flow.supply = supply;
  flow.boundary_thickness = layer;
  const film::Reynolds reynolds(grid, {to_field(along_x), to_field(along_y)}, lubricant, flow);
  return surface_array(
      reynolds.outflow({to_field(fields.at(0)), to_field(fields.at(1)), to_field(fields.at(2))}),
      grid);
}

}  // namespace

void bind_film(py::module_& m) {
  const film::FlowSettings defaults;
  py::class_<LubricantTable>(m, "LubricantTable")
      .def(py::init([](double scale, double step, const Array& reduced, const Array& fluidity,
                       const Array& density, const Array& density_slope) {
             return LubricantTable({scale, step, to_field(reduced), to_field(fluidity),
                                    to_field(density), to_field(density_slope)});
           }),
           py::arg("scale"), py::arg("step"), py::arg("reduced"), py::arg("fluidity"),
           py::arg("density"), py::arg("density_slope"))
      .def_property_readonly("largest_pressure", &LubricantTable::largest_pressure)
      .def(
          "at",
          [](const LubricantTable& table, double pressure) {
            const auto oil = table.at(pressure);
            return py::make_tuple(oil.reduced, oil.fluidity, oil.density, oil.density_slope);
          },
          py::arg("pressure"));

  py::class_<FilmSolver>(m, "FilmSolver")
      .def(py::init(
               [](const Grid& grid, const plasticity::Body& body1, const plasticity::Body& body2) {
                 operators::SurfaceInfluence influence;
                 influence.add(operators::medium_of(body1));
                 influence.add(operators::medium_of(body2));
                 return std::make_unique<FilmSolver>(grid, influence);
               }),
           py::arg("grid"), py::arg("body1"), py::arg("body2"))
      .def("solve", &solve_film, py::arg("lubricant"), py::arg("gap"), py::arg("is_load"),
           py::arg("target"), py::arg("along_x"), py::arg("along_y"), py::arg("order"),
           py::arg("supply"), py::arg("thinnest"), py::arg("layer"), py::arg("start"),
           py::arg("tol"), py::arg("max_iterations"), py::arg("time") = std::pair{0.0, 1.0},
           py::arg("content") = py::none(), py::arg("pressure_flow") = std::vector<Array>{},
           py::arg("order_change") =
               std::pair{defaults.first_order_below, defaults.higher_order_above});

  m.def("film_outflow", &film_outflow, py::arg("grid"), py::arg("lubricant"), py::arg("along_x"),
        py::arg("along_y"), py::arg("order"), py::arg("supply"), py::arg("layer"),
        py::arg("fields"), py::arg("pressure_flow") = std::vector<Array>{});
}

}  // namespace samcontact::bindings
