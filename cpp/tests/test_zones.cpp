// SPDX-License-Identifier: GPL-3.0-or-later
// A body in an increment with changing zones: one box, two, one around all.
#include <doctest/doctest.h>

#include <map>
#include <tuple>

#include "samcontact/simulation/body/plastic_body.hpp"
#include "samcontact/simulation/simulation.hpp"
#include "samcontact/simulation/state/strain_fields.hpp"
#include "samcontact/simulation/state/stress_fields.hpp"
#include "samcontact/simulation/state/surface_fields.hpp"
#include "samcontact/simulation/strain/box_volume.hpp"
#include "samcontact/simulation/strain/outside_strain.hpp"

using namespace samcontact;
using namespace samcontact::simulation;
using fft::Symmetry;

namespace {

/// Ball after plastic flow, under load.
Simulation ball() {
  const Grid grid(33, 31, 60e-6, 60e-6, 12, 60e-6);
  Field gap(grid.surface_size());
  const auto x = grid.x(), y = grid.y();
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      gap[i * grid.ny + j] = (x[i] * x[i] + y[j] * y[j]) / (2 * 7.5e-3);
    }
  }
  const auto steel =
      plasticity::Material::with_law(210e9, 0.3, plasticity::LinearHardening{1.2e9, 10e9});
  Simulation simulation(grid, plasticity::Material::make_elastic(210e9, 0.3), steel, gap,
                        contact::FrictionLaw(contact::FullSliding{0.0}),
                        {.tol = 1e-6,
                         .increment_tol = 0.0,
                         .max_iterations = 60,
                         .on_border = contact::OnBorder::error,
                         .residual_stress = operators::ResidualMethod::fast,
                         .image_tol = 1e-3,
                         .reach = 0});
  simulation.step({.drive = contact::Drive::load(300.0)});
  return simulation;
}

using ByCell = std::map<std::tuple<int, int, int>, plasticity::Tensor>;

/// Stress of the active cells of a body, by cell.
ByCell stress(const PlasticBody& body, const ActiveCells& active) {
  ByCell out;
  for (std::size_t n = 0; n < active.size(); ++n) {
    const Cell c = body.zones().cell(active.cells[n].cell);
    out[{c.i, c.j, c.k}] = active.stress[n];
  }
  return out;
}

}  // namespace

TEST_CASE("a change of zones preserves strain, unknowns and history") {
  const Simulation simulation = ball();
  const State& state = simulation.state();
  REQUIRE(state.plastic[1]);
  for (const Symmetry symmetry : {Symmetry::none, Symmetry::y}) {
    const Grid& grid = state.setup().grid;
    const Box part = stored_part(grid, symmetry);
    const auto history = unfolded(state.plastic[1], grid, symmetry);
    const int j0 = symmetry == Symmetry::none ? 12 : part.j0;
    const Box a{12, j0, 8, 18 - j0, 5}, wider{10, j0, 10, 20 - j0, 6}, neighbour{26, 22, 4, 3, 2};
    PlasticBody body(state, 1, 0, 1, symmetry, {});
    ActiveCells active;
    const Sources sources = state.sources();
    body.set_tractions(state.tractions);
    const auto set = [&](const Zones& zones) {
      body.set_zones(zones, false, sources, active);
      CHECK(body.zones() == zones);
      body.transform(true);
      body.find_stress(active);
    };
    // Plastic flow of three cells in addition to the history.
    body.set_zones(Zones({a}), false, sources, active);
    const std::vector<Cell> cells{{13, 16, 0}, {15, 17, 3}, {19, 16, 4}};
    const plasticity::Tensor strain{1e-3, -2e-3, 1e-3, 3e-4, -2e-4, 1e-4};
    for (const Cell& cell : cells) {
      const auto number = static_cast<std::uint32_t>(body.zones().number(cell));
      body.activate(number, {}, active);
      body.set_strain(number, strain);
    }
    set(Zones({wider, neighbour}));
    const ByCell in_two = stress(body, active);
    const Box all = from_planes_on(Zones({wider, neighbour}).around(), grid, symmetry);
    set(Zones({all}));
    const ByCell in_one = stress(body, active);
    for (std::size_t n = 0; n < cells.size(); ++n) {
      CHECK(body.zones().cell(active.cells[n].cell) == cells[n]);
    }
    // Both are computed in the same box.
    for (const auto& [cell, s] : in_two) CHECK(in_one.at(cell) == s);
    Field gap(grid.surface_size(), 0.0), again = gap;
    body.transform(true);
    body.surface().add_displacement_to(gap);
    set(Zones({neighbour, wider}));
    body.transform(true);
    body.surface().add_displacement_to(again);
    CHECK(gap == again);

    const auto after = body.finish();
    CHECK(after->symmetry() == symmetry);
    const Zones of({all});
    PlasticFields expected = history->fields(of);
    for (const Cell& cell : cells) {
      int c = 0;
      for (const int place : operators::components(history->tensor())) {
        expected.strain[c++ * of.cells() + of.number(cell)] = strain[place];
      }
    }
    const PlasticFields found = after->fields(of);
    CHECK(found.strain == expected.strain);
    CHECK(found.equivalent == expected.equivalent);
  }
}

TEST_CASE("an increment continues from several zones, and fields include their strain") {
  Simulation one = ball(), several = ball();
  State parted = several.state();
  const Box whole = around(parted.flow_boxes[1]);
  Box left = whole, right = whole;
  left.nx = whole.nx / 2;
  right.i0 += left.nx;
  right.nx -= left.nx;
  parted.flow_boxes[1] = {left, right};
  several.restore(parted, several.counters());
  const auto same_to = [](const Field& a, const Field& b, double tol) {
    double largest = 0.0, off = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) {
      largest = std::max(largest, std::fabs(a[n]));
      off = std::max(off, std::fabs(a[n] - b[n]));
    }
    CHECK(off <= tol * largest);
  };
  same_to(residual_stress(one.state(), 1), residual_stress(several.state(), 1), 2e-3);
  same_to(stress(one.state(), 1), stress(several.state(), 1), 2e-3);
  const auto& a = one.step({.drive = contact::Drive::load(350.0)});
  const auto& b = several.step({.drive = contact::Drive::load(350.0)});
  REQUIRE(b.flowed[1]);
  same_to(equivalent_plastic_strain(a, 1), equivalent_plastic_strain(b, 1), 1e-6);
  same_to(a.tractions.pressure, b.tractions.pressure, 1e-6);
}

TEST_CASE("strain inside and outside a box displaces the surface along all axes") {
  const Simulation simulation = ball();
  const State& state = simulation.state();
  const Setup& setup = state.setup();
  for (const Symmetry symmetry : {Symmetry::none, Symmetry::y}) {
    const auto history = unfolded(state.plastic[1], setup.grid, symmetry);
    Box left = history->box();
    left.nx /= 2;
    const Zones zones({left});
    const auto method = operators::ResidualMethod::fast;
    BoxVolume inside(setup, 1, zones, history->tensor(), method, symmetry, {}, zones.around());
    inside.transform(history->strain(zones), operators::all_axes);
    const OutsideStrain outside =
        outside_strain(setup, 1, *history, zones, method, operators::all_axes);
    const Box common = inside.surface().intersected(outside.surface);
    const Box stored = stored_part(setup.grid, symmetry), whole = Box::surface(setup.grid);
    CHECK(common.i0 == left.i0);
    for (const operators::Axis axis : operators::all_axes) {
      const auto cut = [&](const Field& from, const Box& of) {
        Field part(common.surface_size());
        extract(from.data(), of, part.data(), common);
        return part;
      };
      Field own(inside.surface().surface_size());
      inside.displacement(axis, own.data());
      const Field a = cut(own, inside.surface());
      const Field b = cut(outside.displacement[static_cast<int>(axis)], outside.surface);
      const Field all = cut(residual_displacement(state, 1, axis), whole);
      CHECK(common.j0 >= stored.j0);
      double largest = 0.0, off = 0.0;
      for (std::size_t n = 0; n < all.size(); ++n) {
        largest = std::max(largest, std::fabs(all[n]));
        off = std::max(off, std::fabs(a[n] + b[n] - all[n]));
      }
      CHECK(largest > 1e-8);
      CHECK(off < 1e-10 * largest);
    }
  }
}

TEST_CASE("zones off a mirror plane have mirror images") {
  const Grid grid(20, 21, 1.0, 1.0, 8, 1.0);
  const std::vector<Box> stored{
      {10, 10, 3, 2, 2}, {15, 10, 1, 1, 1}, {10, 14, 2, 3, 3}, {16, 15, 2, 2, 4}};
  const auto whole = whole_boxes(stored, grid, Symmetry::xy);
  CHECK(whole.size() == 1 + 2 + 2 + 4);
  CHECK(are_disjoint(whole));
  CHECK(whole[0] == whole_box(stored[0], grid, Symmetry::xy));
  CHECK(around(whole) ==
        whole_box(from_planes_on(around(stored), grid, Symmetry::xy), grid, Symmetry::xy));
  const auto parts = parts_of(whole, grid, Symmetry::xy);
  CHECK(parts == stored);
}
