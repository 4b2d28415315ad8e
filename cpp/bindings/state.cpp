// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "long_work.hpp"
#include "parts.hpp"
#include "rooms.hpp"
#include "samcontact/simulation/state/contact_fields.hpp"
#include "samcontact/simulation/state/description.hpp"
#include "samcontact/simulation/state/flow_zones.hpp"
#include "samcontact/simulation/state/strain_fields.hpp"
#include "samcontact/simulation/state/stress_fields.hpp"
#include "samcontact/simulation/state/surface_fields.hpp"
#include "samcontact/simulation/state/temperature_fields.hpp"
#include "typed.hpp"

namespace samcontact::bindings {

namespace {

using simulation::State;

enum class Rank { surface, scalar, tensor, tensors };

/// Field whose computation takes long.
template <class Make>
Field worked(const Make& make) {
  const LongWork work;
  return make();
}

template <Rank rank>
Values to_array(Field field, const Grid& grid, py::ssize_t layers) {
  if constexpr (rank == Rank::surface) return surface_array(std::move(field), grid);
  if constexpr (rank == Rank::scalar) return volume_array(std::move(field), grid, layers);
  if constexpr (rank == Rank::tensor) return tensor_array(std::move(field), grid, layers);
  if constexpr (rank == Rank::tensors) return tensors_array(std::move(field), grid, layers);
}

auto surface_method(Field (*method)(const State&, int)) {
  return [method](const State& state, int body) {
    Field field = worked([&] { return (*method)(state, body); });
    return surface_array(std::move(field), state.setup().grid);
  };
}

/// Volume field down to a number of layers.
template <Rank rank>
auto volume_method(Field (*method)(const State&, int, simulation::Layers)) {
  return [method](const State& state, int body, int layers) {
    Field field = worked([&] { return (*method)(state, body, layers); });
    return to_array<rank>(std::move(field), state.setup().grid, layers);
  };
}

/// First cell and sizes (i0, j0, nx, ny, nz): the form of a box in Python.
using BoxTuple = std::array<int, 5>;
BoxTuple to_tuple(const Box& box) { return {box.i0, box.j0, box.nx, box.ny, box.nz}; }
std::optional<BoxTuple> to_tuple_or_none(const Box& box) {
  if (box.empty()) return {};
  return to_tuple(box);
}
Box to_box(const BoxTuple& cells) {
  const auto& [i0, j0, nx, ny, nz] = cells;
  return {i0, j0, nx, ny, nz};
}

/// Field over the cells of a box, which may lie outside the grid.
template <Rank rank>
auto box_method(Field (*method)(const State&, int, const Box&)) {
  return [method](const State& state, int body, const BoxTuple& cells) {
    const Box box = to_box(cells);
    Field field = worked([&] { return (*method)(state, body, box); });
    return to_array<rank>(std::move(field), box.grid(state.setup().grid), box.nz);
  };
}

void bind_zones(py::class_<State>& state) {
  state
      .def(
          "zones",
          [](const State& s, int body) {
            std::vector<BoxTuple> zones;
            for (const Box& zone : simulation::zones(s, body)) zones.push_back(to_tuple(zone));
            return zones;
          },
          py::arg("body"))
      .def(
          "own_box",
          [](const State& s, int body) { return to_tuple_or_none(simulation::own_box(s, body)); },
          py::arg("body"))
      .def(
          "deviator_in_own_box",
          [](const State& s, int body, bool loaded) {
            Field field = worked([&] { return simulation::deviator_in_own_box(s, body, loaded); });
            const Box box = simulation::own_box(s, body);
            return tensor_array(std::move(field), box.grid(s.setup().grid), box.nz);
          },
          py::arg("body"), py::arg("loaded"))
      .def(
          "stress_in_zones",
          [](const State& s, int body, bool loaded) {
            Field field = worked([&] { return simulation::stress_in_zones(s, body, loaded); });
            const auto size = static_cast<py::ssize_t>(field.size());
            return own(std::move(field), {size}, {item});
          },
          py::arg("body"), py::arg("loaded"));
}

void bind_boxes(py::class_<State>& state) {
  const auto bind = [&](const char* name, auto method) {
    state.def(name, method, py::arg("body"), py::arg("box"));
  };
  bind("residual_stress_in", box_method<Rank::tensor>(&simulation::residual_stress));
  bind("initial_stress_in", box_method<Rank::tensor>(&simulation::initial_stress));
  bind("eigenstress_in", box_method<Rank::tensor>(&simulation::eigenstress));
  bind("eigenstrain_in", box_method<Rank::tensor>(&simulation::eigenstrain));
  bind("yield_factor_in", box_method<Rank::scalar>(&simulation::yield_factor));
  bind("plastic_strain_in", box_method<Rank::tensor>(&simulation::plastic_strain));
  bind("equivalent_plastic_strain_in",
       box_method<Rank::scalar>(&simulation::equivalent_plastic_strain));
  bind("backstress_in", box_method<Rank::tensors>(&simulation::backstress));
  state.def(
      "residual_displacement_in",
      [](const State& s, int body, const BoxTuple& cells, int axis) {
        const Box box = to_box(cells);
        Field field;
        {
          const LongWork work;
          field =
              simulation::residual_displacement(s, body, static_cast<operators::Axis>(axis), box);
        }
        return surface_array(std::move(field), box.grid(s.setup().grid));
      },
      py::arg("body"), py::arg("box"), py::arg("axis"));
  bind_zones(state);
}

void bind_track(py::class_<State>& state) {
  state
      .def(
          "widened",
          [](const State& s, const State& like) { return s.widened(like.shared_setup()); },
          py::arg("like"))
      .def(
          "relief",
          [](const State& s, int body) {
            return surface_array(s.setup().relief(body, s.travel), s.setup().grid);
          },
          py::arg("body"))
      .def_property_readonly("origin", [](const State& s) { return s.placement().origin; })
      .def_property_readonly("offset", [](const State& s) { return s.placement().offset; })
      .def_property_readonly("first_cell", [](const State& s) { return s.placement().first; })
      .def(
          "history_rows",
          [](const State& s, int body) -> std::optional<std::pair<int, int>> {
            Box box;
            for (const auto& strain : {s.plastic[body], s.eigenstrain[body]}) {
              if (!strain) continue;
              box = box.united(
                  simulation::whole_box(strain->box(), s.setup().grid, strain->symmetry()));
            }
            if (box.empty()) return {};
            return std::pair{box.i0, box.nx};
          },
          py::arg("body"));
}

void bind_fields(py::class_<State>& bound) {
  const auto bind = [&](const char* name, auto method) {
    bound.def(name, method, py::arg("body"), py::arg("layers"));
  };
  bind("stress", volume_method<Rank::tensor>(&simulation::stress));
  bind("residual_stress", volume_method<Rank::tensor>(&simulation::residual_stress));
  bind("initial_stress", volume_method<Rank::tensor>(&simulation::initial_stress));
  bind("backstress", volume_method<Rank::tensors>(&simulation::backstress));
  bind("disturbance", volume_method<Rank::tensor>(&simulation::disturbance));
  bind("eigenstress", volume_method<Rank::tensor>(&simulation::eigenstress));
  bind("eigenstrain", volume_method<Rank::tensor>(&simulation::eigenstrain));
  bind("plastic_strain", volume_method<Rank::tensor>(&simulation::plastic_strain));
  bind("temperature", volume_method<Rank::scalar>(&simulation::temperature));
  bind("matrix_plastic_strain", volume_method<Rank::tensor>(&simulation::matrix_plastic_strain));
  bind("inclusion_plastic_strain",
       volume_method<Rank::tensor>(&simulation::inclusion_plastic_strain));
  bind("inclusion_equivalent_strain",
       volume_method<Rank::scalar>(&simulation::inclusion_equivalent_strain));
  bind("equivalent_plastic_strain",
       volume_method<Rank::scalar>(&simulation::equivalent_plastic_strain));
  const auto bind_surface = [&](const char* name, Field (*method)(const State&, int)) {
    bound.def(name, surface_method(method), py::arg("body"));
  };
  bind_surface("surface_temperature", &simulation::surface_temperature);
  bound.def(
      "residual_displacement",
      [](const State& s, int body, int axis) {
        Field field = worked([&] {
          return simulation::residual_displacement(s, body, static_cast<operators::Axis>(axis));
        });
        return surface_array(std::move(field), s.setup().grid);
      },
      py::arg("body"), py::arg("axis"));
  bind_surface("surface_displacement", &simulation::surface_displacement);
  bound.def(
      "equivalent_pressure",
      [](const State& s, int body) {
        Field pressure = s.equivalent_tractions(body).pressure;
        pressure.resize(s.setup().grid.surface_size(), 0.0);
        return surface_array(std::move(pressure), s.setup().grid);
      },
      py::arg("body"));
  bound.def(
      "viscous_work",
      [](const State& s, int body) {
        const LongWork work;
        return s.viscous_work(body);
      },
      py::arg("body"));
}

/// Binds a property for each visited part; its value is None if the state has no such part.
class PartProperties {
 public:
  explicit PartProperties(py::class_<State>& bound) : bound_(bound) {}

  template <class T>
  void operator()(const std::string& name, const T& /*part*/) {
    bind<std::conditional_t<Sequence<T>, std::optional<Made<T>>, Made<T>>>(name);
  }
  void maybe_nan(const std::string& name, double part) { (*this)(name, part); }

  template <class T, class Plain, class Make>
  void made(const std::string& name, const std::shared_ptr<const T>& /*part*/,
            const Plain& /*plain*/, const Make& /*make*/) {
    bind<std::optional<Made<std::invoke_result_t<const Plain&, const T&>>>>(name);
  }

 private:
  /// Python type of a part.
  template <class T>
  using Made = decltype(PartWriter::to_python(std::declval<T>(), py::object()));

  template <class Made>
  void bind(const std::string& name) {
    bound_.def_property_readonly(name.c_str(), [name](const py::object& self) {
      PartWriter visit(name, self);
      describe(self.cast<const State&>(), visit);
      return Typed<Made>(visit.content.attr("get")(name));
    });
  }

  py::class_<State>& bound_;
};

void bind_content(py::class_<State>& bound) {
  PartProperties properties(bound);
  const State blank = State::without_setup();
  describe(blank, properties);
  bound.def("content", [](const State& state) {
    PartWriter visit;
    describe(state, visit);
    return visit.content;
  });
}

void bind_contact_of(py::class_<State>& bound) {
  bound
      .def("gap",
           [](const State& state) {
             Field gap = worked([&] { return simulation::gap(state); });
             return surface_array(std::move(gap), state.setup().grid);
           })
      .def("repulsion",
           [](const State& state) {
             Field repulsion = worked([&] { return simulation::repulsion(state); });
             return surface_array(std::move(repulsion), state.setup().grid);
           })
      .def("attraction_energy", &simulation::attraction_energy)
      .def("moment", &State::moment)
      .def("tangential_force", &State::tangential_force);
}

}  // namespace

void bind_state(py::module_& m) {
  py::class_<State> bound(m, "State");
  bind_boxes(bound);
  bind_track(bound);
  bind_content(bound);
  bind_contact_of(bound);
  bound
      .def("max_equivalent_plastic_strain", &simulation::max_equivalent_plastic_strain,
           py::arg("body"))
      .def("max_plastic_strain_magnitude", &simulation::max_plastic_strain_magnitude,
           py::arg("body"))
      .def(
          "has_eigenstrain",
          [](const State& state, int body) { return state.eigenstrain[body] != nullptr; },
          py::arg("body"))
      .def("plastic_cells", &simulation::plastic_cells, py::arg("body"))
      .def_readonly("warnings", &State::warnings)
      .def_readonly("stall_warning", &State::stall_warning)
      .def("layers", &State::layers)
      .def(
          "strain_beyond",
          [](const State& state, int body) {
            return to_tuple_or_none(simulation::strain_beyond(state, body));
          },
          py::arg("body"))
      .def(
          "softening",
          [](const State& state, int body) -> std::optional<Values> {
            if (!state.softening[body]) return {};
            const auto& [box, values] = *state.softening[body];
            const Grid& grid = state.setup().grid;
            const Box here{0, 0, grid.nx, grid.ny, box.nz};
            Field factor(here.volume_size());
            extract(values.data(), box, factor.data(), here);
            return volume_array(std::move(factor), grid, box.nz);
          },
          py::arg("body"));
  bind_fields(bound);
}

}  // namespace samcontact::bindings
