// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

#include "arrays.hpp"
#include "rooms.hpp"
#include "samcontact/simulation/simulation.hpp"

namespace samcontact::bindings {

namespace {

using simulation::Counters;
using simulation::Settings;
using simulation::Simulation;
using simulation::State;
using simulation::Target;

/// A read-only view of a surface field that keeps its state alive; None when empty.
py::object surface_view(const py::object& self, const Field& field) {
  if (field.empty()) return py::none();
  const Grid& grid = self.cast<const State&>().scene().grid;
  py::array view({grid.nx, grid.ny}, {item * grid.ny, item}, field.data(), self);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

/// Plastic history as it is kept, for checkpoints: its box, how many directions are mirrored,
/// strain (components, nz, nx, ny), equivalent plastic strain (nz, nx, ny) and backstresses (terms,
/// 5, nz, nx, ny) of the box; None without plastic strain.
py::object history(const State& state, int body) {
  const auto& plastic = state.plastic[body];
  if (!plastic) return py::none();
  const Box& box = plastic->box();
  const py::ssize_t nx = box.nx, ny = box.ny, nz = box.nz;
  const py::ssize_t parts = operators::count(plastic->tensor());
  py::dict d;
  d["box"] = std::vector<int>{box.i0, box.j0, box.nx, box.ny, box.nz};
  const Box& flow = state.flow_box[body];
  d["flow_box"] = std::vector<int>{flow.i0, flow.j0, flow.nx, flow.ny, flow.nz};
  d["mirrored"] = static_cast<int>(plastic->symmetry());
  d["strain"] = py::array_t<double>({parts, nz, nx, ny}, plastic->strain(box).data());
  d["equivalent"] = py::array_t<double>({nz, nx, ny}, plastic->equivalent(box).data());
  const auto terms = static_cast<py::ssize_t>(state.scene().materials[body].backstresses.size());
  d["backstress"] =
      py::array_t<double>({terms, py::ssize_t{5}, nz, nx, ny}, plastic->backstress(box).data());
  return d;
}

Box to_box(const py::handle& numbers) {
  const auto extents = numbers.cast<std::vector<int>>();
  if (extents.size() != 5) throw std::invalid_argument("a box needs 5 numbers");
  return {extents[0], extents[1], extents[2], extents[3], extents[4]};
}

/// The reverse; throws std::invalid_argument for a history that does not fit the grid.
std::shared_ptr<const simulation::PlasticState> to_history(const py::dict& saved, const Grid& grid,
                                                           std::size_t terms) {
  const auto strain = saved["strain"].cast<Array>();
  const auto equivalent = saved["equivalent"].cast<Array>();
  const Box box = to_box(saved["box"]);
  // Along x it may go beyond the grid.
  bool inside = box.j0 >= 0 && box.nx > 0 && box.ny > 0 && box.nz > 0 &&
                box.j0 + box.ny <= grid.ny && box.nz <= grid.nz;
  const int mirrored = saved["mirrored"].cast<int>();
  if (mirrored < 0 || mirrored > 2) throw std::invalid_argument("mirrored must be 0, 1 or 2");
  const auto symmetry = static_cast<fft::Symmetry>(mirrored);
  const Box part = simulation::stored_part(grid, symmetry);
  inside = inside && (mirrored < 1 || box.j0 == part.j0) && (mirrored < 2 || box.i0 == part.i0);
  if (!inside) throw std::invalid_argument("the box of a plastic history is not in the grid");
  const auto cells = static_cast<py::ssize_t>(box.volume_size());
  const auto tensor =
      strain.size() == 5 * cells ? operators::Tensor::deviator : operators::Tensor::full;
  if (strain.size() != operators::count(tensor) * cells || equivalent.size() != cells) {
    throw std::invalid_argument("the arrays of a plastic history do not fit its box");
  }
  const auto backstress = saved["backstress"].cast<Array>();
  if (backstress.size() != 5 * static_cast<py::ssize_t>(terms) * cells) {
    throw std::invalid_argument("the backstress of a plastic history does not fit its box");
  }
  const simulation::PlasticFields fields{box, to_field(strain), to_field(equivalent),
                                         to_field(backstress)};
  const auto finite = [](const Field& f) {
    return std::all_of(f.begin(), f.end(), [](double v) { return std::isfinite(v); });
  };
  if (!finite(fields.strain) || !finite(fields.equivalent) || !finite(fields.backstress)) {
    throw std::invalid_argument("a plastic history must be finite everywhere");
  }
  return std::make_shared<const simulation::PlasticState>(nullptr, symmetry, tensor, fields);
}

/// Flow of the last increment of a moving contact; None without.
py::object last_flow(const State& state) {
  if (!state.last_flow) return py::none();
  py::dict d;
  d["mirrored"] = static_cast<int>(state.last_flow->symmetry);
  d["advance"] = state.last_flow->advance;
  for (int b = 0; b < 2; ++b) {
    const auto& body = state.last_flow->bodies[b];
    const std::string number = std::to_string(b + 1);
    d[("cells" + number).c_str()] =
        py::array_t<std::uint32_t>(static_cast<py::ssize_t>(body.cells.size()), body.cells.data());
    d[("strain" + number).c_str()] =
        py::array_t<double>(static_cast<py::ssize_t>(body.strain.size()), body.strain.data());
  }
  return d;
}

/// The reverse.
std::shared_ptr<const simulation::Flow> to_flow(const py::object& saved, const Grid& grid) {
  if (saved.is_none()) return nullptr;
  auto flow = std::make_shared<simulation::Flow>();
  flow->symmetry = static_cast<fft::Symmetry>(std::clamp(saved["mirrored"].cast<int>(), 0, 2));
  flow->advance = saved["advance"].cast<simulation::Travel>();
  for (int b = 0; b < 2; ++b) {
    auto& body = flow->bodies[b];
    const std::string number = std::to_string(b + 1);
    body.cells = saved[("cells" + number).c_str()].cast<std::vector<std::uint32_t>>();
    body.strain = to_field(saved[("strain" + number).c_str()].cast<Array>());
    const std::size_t n = body.cells.size();
    const bool inside = std::all_of(body.cells.begin(), body.cells.end(),
                                    [&](std::uint32_t cell) { return cell < grid.volume_size(); });
    if (!inside || (body.strain.size() != 5 * n && body.strain.size() != 6 * n)) {
      throw std::invalid_argument("the flow of the last increment does not fit the grid");
    }
  }
  return flow;
}

enum class Rank { surface, scalar, tensor, tensors };

template <Rank rank>
py::array to_array(Field field, const Grid& grid) {
  if constexpr (rank == Rank::surface) return surface_array(std::move(field), grid);
  if constexpr (rank == Rank::scalar) return volume_array(std::move(field), grid, grid.nz);
  if constexpr (rank == Rank::tensor) return tensor_array(std::move(field), grid, grid.nz);
  if constexpr (rank == Rank::tensors) return tensors_array(std::move(field), grid, grid.nz);
}

template <Rank rank>
auto field_method(Field (State::*method)(int) const) {
  return [method](const State& state, int body) {
    Field field;
    {
      const py::gil_scoped_release release;
      field = (state.*method)(body);
    }
    return to_array<rank>(std::move(field), state.scene().grid);
  };
}

/// A field over the cells first_row <= i < first_row + rows, which may lie beside the grid.
template <Rank rank>
auto track_method(Field (State::*method)(int, const Box&) const) {
  return [method](const State& state, int body, int first_row, int rows) {
    const Grid& grid = state.scene().grid;
    const Box region{first_row, 0, rows, grid.ny, grid.nz};
    Field field;
    {
      const py::gil_scoped_release release;
      field = (state.*method)(body, region);
    }
    return to_array<rank>(std::move(field), region.grid(grid));
  };
}

void bind_track(py::class_<State>& state) {
  const auto bind = [&](const char* name, auto method) {
    state.def(name, method, py::arg("body"), py::arg("first_row"), py::arg("rows"));
  };
  bind("track_residual_displacement", track_method<Rank::surface>(&State::residual_displacement));
  bind("track_residual_stress", track_method<Rank::tensor>(&State::residual_stress));
  bind("track_plastic_strain", track_method<Rank::tensor>(&State::plastic_strain));
  bind("track_equivalent_plastic_strain",
       track_method<Rank::scalar>(&State::equivalent_plastic_strain));
  bind("track_backstress", track_method<Rank::tensors>(&State::backstress));
  state.def_readonly("travel", &State::travel)
      .def("last_flow", &last_flow)
      .def_property_readonly("origin", [](const State& s) { return s.placement().origin; })
      .def_property_readonly("offset", [](const State& s) { return s.placement().offset; })
      .def_property_readonly("first_cell", [](const State& s) { return s.placement().first; })
      .def(
          "history_rows",
          [](const State& s, int body) -> py::object {
            if (!s.plastic[body]) return py::none();
            const auto& history = *s.plastic[body];
            const Box box =
                simulation::whole_box(history.box(), s.scene().grid, history.symmetry());
            return py::make_tuple(box.i0, box.nx);
          },
          py::arg("body"));
}

void bind_state(py::module_& m) {
  py::class_<State> bound(m, "State");
  bind_track(bound);
  bound
      .def_property_readonly("pressure",
                             [](const py::object& self) {
                               return surface_view(self,
                                                   self.cast<const State&>().tractions.pressure);
                             })
      .def_property_readonly("shear_x",
                             [](const py::object& self) {
                               return surface_view(self,
                                                   self.cast<const State&>().tractions.shear_x);
                             })
      .def_property_readonly("shear_y",
                             [](const py::object& self) {
                               return surface_view(self,
                                                   self.cast<const State&>().tractions.shear_y);
                             })
      .def("gap",
           [](const State& state) {
             Field gap;
             {
               const py::gil_scoped_release release;
               gap = state.gap();
             }
             return surface_array(std::move(gap), state.scene().grid);
           })
      .def(
          "relief",
          [](const State& s, int body) {
            return surface_array(s.scene().relief(body, s.travel), s.scene().grid);
          },
          py::arg("body"))
      .def_property_readonly("contact_gap",
                             [](const py::object& self) {
                               return surface_view(self, self.cast<const State&>().contact_gap);
                             })
      .def_property_readonly(
          "exact_residual_stress",
          [](const State& s) { return s.method == operators::ResidualMethod::exact; })
      .def("history", &history, py::arg("body"))
      .def("max_equivalent_plastic_strain", &State::max_equivalent_plastic_strain, py::arg("body"))
      .def("max_plastic_strain", &State::max_plastic_strain, py::arg("body"))
      .def_readonly("heating", &State::heating)
      .def_readonly("time", &State::time)
      .def_readonly("duration", &State::duration)
      .def_property_readonly("past_symmetry",
                             [](const State& s) { return static_cast<int>(s.past_symmetry); })
      .def(
          "past",
          [](const State& s, int body) -> py::object {
            if (!s.past[body]) return py::none();
            const auto kept = s.past[body]->state();
            return py::array_t<double>(static_cast<py::ssize_t>(kept.size()), kept.data());
          },
          py::arg("body"))
      .def_readonly("load", &State::load)
      .def_readonly("approach", &State::approach)
      .def_readonly("converged", &State::converged)
      .def_readonly("iterations", &State::plastic_iterations)
      .def_readonly("contact_iterations", &State::contact_iterations)
      .def_readonly("substeps", &State::substeps)
      .def_readonly("plastic_residual", &State::plastic_residual)
      .def_readonly("yield_excess", &State::yield_excess)
      .def_readonly("warnings", &State::warnings)
      .def("stress", field_method<Rank::tensor>(&State::stress), py::arg("body"))
      .def("residual_stress", field_method<Rank::tensor>(&State::residual_stress), py::arg("body"))
      .def("backstress", field_method<Rank::tensors>(&State::backstress), py::arg("body"))
      .def("plastic_strain", field_method<Rank::tensor>(&State::plastic_strain), py::arg("body"))
      .def(
          "softening",
          [](const State& state, int body) -> py::object {
            if (!state.softening[body]) return py::none();
            const Grid& grid = state.scene().grid;
            return volume_array(*state.softening[body], grid, grid.nz);
          },
          py::arg("body"))
      .def("temperature", field_method<Rank::scalar>(&State::temperature), py::arg("body"))
      .def("surface_temperature", field_method<Rank::surface>(&State::surface_temperature),
           py::arg("body"))
      .def("von_mises", field_method<Rank::scalar>(&State::von_mises), py::arg("body"))
      .def("hydrostatic", field_method<Rank::scalar>(&State::hydrostatic), py::arg("body"))
      .def("equivalent_plastic_strain",
           field_method<Rank::scalar>(&State::equivalent_plastic_strain), py::arg("body"))
      .def("residual_displacement", field_method<Rank::surface>(&State::residual_displacement),
           py::arg("body"))
      .def("surface_displacement", field_method<Rank::surface>(&State::surface_displacement),
           py::arg("body"));
}

/// A Python function of the rise of temperature (nx, ny, nz), called with the GIL.
simulation::Softening softening_law(const py::object& law, const Grid& grid) {
  // The last owner may let go of it on any thread.
  const std::shared_ptr<py::object> kept(new py::object(law), [](py::object* p) {
    const py::gil_scoped_acquire gil;
    std::default_delete<py::object>()(p);
  });
  return [kept, grid](const Field& rise) {
    const py::gil_scoped_acquire gil;
    const py::array factor = (*kept)(volume_array(rise, grid, grid.nz));
    return to_field(factor.cast<Array>());
  };
}

/// Each None or (heights (rows, ny), first row, whether periodic).
simulation::Reliefs to_reliefs(const std::array<py::object, 2>& given) {
  simulation::Reliefs reliefs;
  for (int b = 0; b < 2; ++b) {
    if (given[b].is_none()) continue;
    const auto parts = given[b].cast<py::tuple>();
    const auto heights = parts[0].cast<Array>();
    reliefs[b] = {to_field(heights), static_cast<int>(heights.shape(0)), parts[1].cast<int>(),
                  parts[2].cast<bool>()};
  }
  return reliefs;
}

Target make_target(const std::string& kind, double value, const py::object& pressure,
                   const py::object& shear_x, const py::object& shear_y) {
  using contact::Drive;
  return {kind == "approach" ? Drive::approach(value) : Drive::load(value),
          {to_field_or_empty(pressure), to_field_or_empty(shear_x), to_field_or_empty(shear_y)}};
}

State step(Simulation& simulation, const std::string& kind, double value,
           const py::object& pressure, const py::object& shear_x, const py::object& shear_y,
           const operators::HeatingPair& heating, double duration,
           const simulation::Travel& advance) {
  Target target = make_target(kind, value, pressure, shear_x, shear_y);
  target.heating = heating;
  target.duration = duration;
  target.advance = advance;
  const py::gil_scoped_release release;
  return simulation.step(target);
}

py::dict counters(const Simulation& simulation) {
  const Counters& c = simulation.counters();
  py::dict d;
  d["contact_solves"] = c.contact_solves;
  d["contact_iterations"] = c.contact_iterations;
  d["yield_checks"] = c.yield_checks;
  d["plastic_solves"] = c.plastic_solves;
  d["plastic_iterations"] = c.plastic_iterations;
  d["halvings"] = c.halvings;
  d["volume_bytes"] = simulation.volume_bytes();
  return d;
}

/// Sets the state from the entries of a checkpoint: surface fields, scalars, and per body the
/// depth-major plastic arrays or None.
void restore(Simulation& simulation, const py::dict& saved) {
  using operators::ResidualMethod;
  State state(simulation.shared_scene(), saved["exact_residual_stress"].cast<bool>()
                                             ? ResidualMethod::exact
                                             : ResidualMethod::fast);
  const auto field = [&](const char* name) { return to_field_or_empty(saved[name]); };
  state.tractions = {field("pressure"), field("shear_x"), field("shear_y")};
  state.contact_gap = field("contact_gap");
  state.heating = saved["heating"].cast<operators::HeatingPair>();
  state.time = saved["time"].cast<double>();
  state.duration = saved["duration"].cast<double>();
  if (state.duration > 0) {
    for (auto& heat : state.heating) heat.age = state.duration;
  }
  state.travel = saved["travel"].cast<simulation::Travel>();
  state.past_symmetry = static_cast<fft::Symmetry>(saved["past_symmetry"].cast<int>());
  state.load = saved["load"].cast<double>();
  state.approach = saved["approach"].cast<double>();
  state.plastic_iterations = saved["iterations"].cast<int>();
  state.contact_iterations = saved["contact_iterations"].cast<int>();
  state.substeps = saved["substeps"].cast<int>();
  state.plastic_residual = saved["plastic_residual"].cast<double>();
  state.yield_excess = saved["yield_excess"].cast<double>();
  Counters c;
  const py::dict d = saved["counters"];
  c.contact_solves = d["contact_solves"].cast<long>();
  c.contact_iterations = d["contact_iterations"].cast<long>();
  c.yield_checks = d["yield_checks"].cast<long>();
  c.plastic_solves = d["plastic_solves"].cast<long>();
  c.plastic_iterations = d["plastic_iterations"].cast<long>();
  c.halvings = d["halvings"].cast<long>();
  for (int body = 0; body < 2; ++body) {
    const std::string number = std::to_string(body + 1);
    const Field past = field(("past" + number).c_str());
    if (!past.empty()) {
      auto kept = simulation.scene().heat_history(body, state.heating[body]);
      kept.set_state(past);
      state.past[body] = std::make_shared<const operators::HeatHistory>(std::move(kept));
    }
    const Field softening = field(("softening" + number).c_str());
    if (!softening.empty()) {
      if (softening.size() != simulation.scene().grid.volume_size()) {
        throw std::invalid_argument("the softening of a body does not fit the grid");
      }
      state.softening[body] = std::make_shared<const Field>(softening);
    }
    const py::object history = saved[("history" + number).c_str()];
    if (!history.is_none()) {
      const auto& material = simulation.scene().materials[body];
      state.plastic[body] =
          to_history(history, simulation.scene().grid, material.backstresses.size());
      state.flow_box[body] = to_box(history["flow_box"]);
      if (!Box::whole(simulation.scene().grid).contains(state.flow_box[body])) {
        throw std::invalid_argument("the box of plastic flow is not in the grid");
      }
    }
  }
  state.last_flow = to_flow(saved["last_flow"], simulation.scene().grid);
  simulation.restore(state, c);
}

void bind_settings(py::module_& m) {
  py::class_<Settings>(m, "Settings")
      .def(py::init([](double tol, double increment_tol, int max_iterations,
                       const std::string& on_border, const std::string& residual_stress,
                       double image_tol, int reach) {
             using operators::ResidualMethod;
             return Settings{.tol = tol,
                             .increment_tol = increment_tol,
                             .max_iterations = max_iterations,
                             .on_border = on_border == "error" ? contact::OnBorder::error
                                                               : contact::OnBorder::warn,
                             .residual_stress = residual_stress == "exact" ? ResidualMethod::exact
                                                                           : ResidualMethod::fast,
                             .image_tol = image_tol,
                             .reach = reach};
           }),
           py::kw_only(), py::arg("tol"), py::arg("increment_tol"), py::arg("max_iterations"),
           py::arg("on_border"), py::arg("residual_stress"), py::arg("image_tol"),
           py::arg("reach"));
}

}  // namespace

void bind_simulation(py::module_& m) {
  bind_state(m);
  bind_settings(m);
  py::class_<Simulation>(m, "Simulation")
      .def(py::init([](const Grid& grid, const plasticity::Material& body1,
                       const plasticity::Material& body2, const Array& gap, double friction,
                       Settings settings, const std::array<double, 2>& march,
                       const std::array<py::object, 2>& softening,
                       const std::array<py::object, 2>& reliefs) {
             for (int b = 0; b < 2; ++b) {
               if (!softening[b].is_none())
                 settings.softening[b] = softening_law(softening[b], grid);
             }
             return std::make_unique<Simulation>(
                 grid, body1, body2, to_field(gap), friction, settings,
                 simulation::HeatMarch{march[0], march[1]}, to_reliefs(reliefs));
           }),
           py::kw_only(), py::arg("grid"), py::arg("body1"), py::arg("body2"), py::arg("gap"),
           py::arg("friction"), py::arg("settings"), py::arg("march"), py::arg("softening"),
           py::arg("reliefs"))
      .def("step", &step, py::arg("kind"), py::arg("value"), py::arg("pressure"),
           py::arg("shear_x"), py::arg("shear_y"), py::arg("heating"), py::arg("duration"),
           py::arg("advance"))
      .def(
          "set_plastic_state",
          [](Simulation& s, int body, int first_row, const Array& strain,
             const py::object& equivalent, const py::object& backstress) {
            s.set_plastic_state(body, first_row, static_cast<int>(strain.shape(2)),
                                to_field(strain), to_field_or_empty(equivalent),
                                to_field_or_empty(backstress));
          },
          py::arg("body"), py::arg("first_row"), py::arg("strain"), py::arg("equivalent"),
          py::arg("backstress"))
      .def_property_readonly("state", [](const Simulation& s) { return s.state(); })
      .def_property_readonly("counters", &counters)
      .def("restore", &restore, py::arg("saved"));
}

}  // namespace samcontact::bindings
