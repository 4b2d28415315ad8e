// SPDX-License-Identifier: GPL-3.0-or-later
// Operators of zones against those of the whole box.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/operators/zones/smooth_continuation.hpp"
#include "samcontact/operators/zones/zone_operators.hpp"
#include "stress_above.hpp"

using namespace samcontact;
using namespace samcontact::operators;

namespace {

const Grid grid(72, 64, 1e-6, 1.25e-6, 8, 0.9e-6);
const Elastic steel{210e9, 0.3};
/// Causes about as much stress in steel as the pressure does.
const Heating at_rest{0.5, {{}, {45.0, 12e-6, 1.2e-5}}},
    moving{5.0, {{}, {45.0, 12e-6, 1.2e-5}}, -20.0, 35.0, 1e-6};
/// Apart, within the margins of each other, and touching.
const std::vector<Box> zones{
    {4, 6, 14, 11, 5}, {22, 9, 9, 12, 8}, {31, 9, 7, 6, 3}, {40, 40, 20, 18, 6}, {64, 4, 8, 8, 2}};

double number(std::size_t n) { return std::sin(1.7 * static_cast<double>(n) + 0.3); }

/// [component][cell] of the zones: spots that end inside the zones.
Field zone_strain(Tensor tensor, std::size_t cells) {
  Field strain(count(tensor) * cells, 0.0);
  for (int c = 0; c < count(tensor); ++c) {
    std::size_t at = c * cells;
    for (const Box& zone : zones) {
      for (int k = 0; k < zone.nz; ++k) {
        for (int i = 0; i < zone.nx; ++i) {
          for (int j = 0; j < zone.ny; ++j, ++at) {
            const double x = std::sin(std::numbers::pi * i / (zone.nx - 1)),
                         y = std::sin(std::numbers::pi * j / (zone.ny - 1));
            strain[at] = 1e-3 * (1 + number(7 * c)) * x * y * (1 + 0.05 * number(at)) / (1 + k);
          }
        }
      }
    }
  }
  return strain;
}

/// The strain on the grid, [component][k][i][j].
Field on_grid(const Field& strain, int parts, std::size_t cells) {
  Field whole(parts * grid.volume_size(), 0.0);
  for (int c = 0; c < parts; ++c) {
    std::size_t at = c * cells;
    for (const Box& zone : zones) {
      insert(strain.data() + at, zone, whole.data() + c * grid.volume_size(), Box::whole(grid));
      at += zone.volume_size();
    }
  }
  return whole;
}

Field spots(double factor) {
  Field pressure(grid.surface_size(), 0.0);
  for (const Box& zone : zones) {
    for (int i = zone.i0 + 2; i < zone.i0 + zone.nx - 2; ++i) {
      for (int j = zone.j0 + 2; j < zone.j0 + zone.ny - 2; ++j) {
        const std::size_t at = static_cast<std::size_t>(i) * grid.ny + j;
        pressure[at] = factor * 1e9 * (1.5 + number(at));
      }
    }
  }
  return pressure;
}

struct Error {
  double squares = 0.0, of = 0.0, largest = 0.0, of_largest = 0.0;
  void add(double value, double reference) {
    squares += (value - reference) * (value - reference);
    of += reference * reference;
    largest = std::max(largest, std::fabs(value - reference));
    of_largest = std::max(of_largest, std::fabs(reference));
  }
  double rms() const { return std::sqrt(squares / of); }
  double max() const { return largest / of_largest; }
};

Field stress_in_zones(ZoneOperators& operators, const Field* strain, const Tractions& tractions,
                      int parts) {
  Field out(parts * operators.cells());
  std::vector<std::size_t> first;
  std::size_t cells = 0;
  for (const Box& zone : zones) {
    first.push_back(cells);
    cells += zone.volume_size();
  }
  operators.for_each_layer(strain, tractions, -1.0, [&](std::size_t z, int k, const double* layer) {
    const std::size_t plane = zones[z].surface_size();
    for (int c = 0; c < parts; ++c) {
      std::copy_n(layer + c * plane, plane, out.data() + c * cells + first[z] + k * plane);
    }
  });
  return out;
}

Error against(const Field& own, const Field& whole, int parts, std::size_t cells) {
  Error error;
  for (int c = 0; c < parts; ++c) {
    std::size_t at = c * cells;
    for (const Box& zone : zones) {
      Field part(zone.volume_size());
      extract(whole.data() + c * grid.volume_size(), Box::whole(grid), part.data(), zone);
      for (const double reference : part) error.add(own[at++], reference);
    }
  }
  return error;
}

/// Errors of zones relative to the whole box.
struct Errors {
  std::array<Error, 3> moved;  // by axis
  Error residual, elastic;     // stress due to strain, and due to tractions
};

/// Fields of the whole box for the strain and the tractions of the zones.
struct Whole {
  Whole(Tensor the_tensor, double tol) : tensor(the_tensor), image_tol(tol) {
    std::size_t cells = 0;
    for (const Box& zone : zones) cells += zone.volume_size();
    strain = zone_strain(tensor, cells);
    const Field everywhere = on_grid(strain, count(tensor), cells);
    const VolumeOperators whole(grid, medium,
                                {tensor, Symmetry::none, ResidualMethod::fast, image_tol, {}});
    VolumeSpectrum spectrum = whole.make_spectrum();
    forward(whole.transform(), everywhere.data(), spectrum);
    for (const Axis axis : all_axes) {
      Field& along = displacement[static_cast<int>(axis)];
      along.assign(grid.surface_size(), 0.0);
      whole.residual_displacement(axis).apply(spectrum, along.data());
    }
    residual = whole.stress(everywhere.data(), nullptr, -1.0);
    elastic = whole.stress(nullptr, &loads, -1.0);
  }

  Tensor tensor;
  double image_tol;
  SharedMedium medium = half_space(steel);
  Tractions loads{spots(1.0), spots(0.3), spots(-0.2)};
  Field strain, residual, elastic;
  std::array<Field, 3> displacement;
};

Errors errors_of(const BandSplit& split, const Whole& whole) {
  const int parts = count(whole.tensor);
  ZoneOperators operators(
      std::make_shared<const ZoneTables>(grid, whole.medium, whole.tensor, whole.image_tol, split),
      zones);
  Errors errors;
  operators.transform(whole.strain, all_axes);
  Field displacement(grid.surface_size());
  for (const Axis axis : all_axes) {
    std::fill(displacement.begin(), displacement.end(), 0.0);
    operators.displacement(axis, displacement.data());
    const Field& reference = whole.displacement[static_cast<int>(axis)];
    for (std::size_t n = 0; n < reference.size(); ++n) {
      errors.moved[static_cast<int>(axis)].add(displacement[n], reference[n]);
    }
  }
  const Tractions none{Field(grid.surface_size(), 0.0), {}, {}};
  errors.residual = against(stress_in_zones(operators, &whole.strain, none, parts), whole.residual,
                            parts, operators.cells());
  errors.elastic = against(stress_in_zones(operators, nullptr, whole.loads, parts), whole.elastic,
                           parts, operators.cells());
  return errors;
}

}  // namespace

TEST_CASE("strain and tractions in zones agree with the whole box") {
  for (const Tensor tensor : {Tensor::full, Tensor::deviator}) {
    const Errors errors = errors_of({}, Whole(tensor, 1e-5));
    for (const Axis axis : all_axes) {
      const Error& moved = errors.moved[static_cast<int>(axis)];
      // The strains xx and yy, whose tables decay most slowly, have the largest effect along the
      // surface.
      CHECK(moved.rms() < (axis == Axis::z ? 3e-4 : 1e-3));
      CHECK(moved.max() < (axis == Axis::z ? 3e-4 : 1e-3));
    }
    CHECK(errors.residual.rms() < 1.5e-3);
    CHECK(errors.residual.max() < 3e-3);
    CHECK(errors.elastic.rms() < 6e-4);
    CHECK(errors.elastic.max() < 6e-4);
  }
}

TEST_CASE("heat proportional to the pressure agrees in zones and in the whole box" *
          doctest::test_suite("accuracy")) {
  const auto medium = half_space(steel);
  for (const auto& [heating, tensor] :
       {std::pair{at_rest, Tensor::full}, {moving, Tensor::deviator}}) {
    const int parts = count(tensor);
    const auto tables =
        std::make_shared<const ZoneTables>(grid, medium, tensor, 1e-5, BandSplit{}, heating);
    ZoneOperators operators(tables, zones);
    const auto heat = std::make_shared<const HeatStress>(grid, heat_of(*medium), heating);
    const VolumeOperators whole(grid, medium,
                                {tensor, Symmetry::none, ResidualMethod::fast, 1e-5, heat});
    const VolumeOperators cold(grid, medium,
                               {tensor, Symmetry::none, ResidualMethod::fast, 1e-5, {}});
    const Tractions loads{spots(1.0), spots(0.3), spots(-0.2)};
    const Field hot = whole.stress(nullptr, &loads, -1.0);
    const Error error =
        against(stress_in_zones(operators, nullptr, loads, parts), hot, parts, operators.cells());
    // At rest it decreases as 1/r.
    CHECK(error.rms() < 1e-3);
    CHECK(error.max() < 1.5e-3);
    const Field without = cold.stress(nullptr, &loads, -1.0);
    Error heated;
    for (std::size_t n = 0; n < hot.size(); ++n) heated.add(hot[n], without[n]);
    CHECK(heated.rms() > 0.1);
  }
}

TEST_CASE("a finer band decomposition reduces the error of each operator down to known limits" *
          doctest::test_suite("accuracy")) {
  const Whole whole(Tensor::deviator, 1e-7);
  const auto errors = [&](const BandSplit& split) {
    const Errors found = errors_of(split, whole);
    return std::array{found.residual.rms(), found.residual.max(), found.elastic.rms(),
                      found.moved[0].rms(), found.moved[1].rms(), found.moved[2].rms()};
  };
  const auto usual = errors({});
  const auto all = errors({.near_range = 12,
                           .middle_range = 32,
                           .middle_sharpness = 2.2,
                           .far_sharpness = 2.1,
                           .window_width = 10,
                           .wide_margin = 20,
                           .middle_gap = 20});
  for (std::size_t n = 0; n < usual.size(); ++n) CHECK(all[n] < 0.2 * usual[n]);
  // That of tractions by the end of the near band, displacement by that of the middle one.
  const auto near = errors({.near_range = 12, .wide_margin = 20});
  for (std::size_t n = 0; n < 2; ++n) CHECK(near[n] < 0.7 * usual[n]);
  CHECK(near[2] < 0.5 * usual[2]);
  const auto middle = errors({.middle_range = 32, .middle_gap = 20});
  for (std::size_t n = 3; n < usual.size(); ++n) CHECK(middle[n] < 0.15 * usual[n]);
}

TEST_CASE("invalid band decompositions are rejected") {
  const auto medium = half_space(steel);
  const std::vector<BandSplit> wrong{{.middle_spacing = 3},   {.far_spacing = 6},
                                     {.near_range = 2},       {.middle_range = 6},
                                     {.middle_sharpness = 0}, {.passband_fraction = 1.0},
                                     {.window_width = 5},     {.middle_gap = 8},
                                     {.fading_nodes = 0},     {.near_displacement_depth = -1.0}};
  for (const BandSplit& split : wrong) {
    CHECK_THROWS_AS(ZoneTables(grid, medium, Tensor::full, 1e-5, split), std::invalid_argument);
  }
}

TEST_CASE("the von Mises stress due to tractions is within its bound") {
  const auto medium = half_space(steel);
  for (const auto& [friction, heating] :
       {std::pair{0.3, Heating{}}, {0.0, at_rest}, {0.3, moving}}) {
    const auto heat = heating.is_on()
                          ? std::make_shared<const HeatStress>(grid, heat_of(*medium), heating)
                          : nullptr;
    const VolumeOperators whole(
        grid, medium, {Tensor::deviator, Symmetry::none, ResidualMethod::fast, 1e-5, heat});
    const StressBound bound(std::make_shared<const ZoneTables>(grid, medium, Tensor::deviator, 1e-5,
                                                               BandSplit{}, heating),
                            middles(grid));
    const Tractions loads{spots(1.0), friction > 0 ? spots(friction) : Field{},
                          friction > 0 ? spots(-0.5 * friction) : Field{}};
    const Above above = stress_above(grid, whole, bound, loads);
    // Smooth bands are evaluated at the corners of blocks.
    CHECK(above.lowest > -0.02);
    CHECK(above.mean < 2);
  }
}

TEST_CASE("zones outside the grid act on it") {
  const auto medium = half_space(steel);
  const std::vector<Box> outer{{-9, 20, 8, 10, 4}};
  const Grid wide(grid.nx + 24, grid.ny, grid.dx, grid.dy, 8, grid.dz);
  const auto tables = [&](const Grid& of) {
    return std::make_shared<const ZoneTables>(of, medium, Tensor::full, 1e-5);
  };
  ZoneOperators outside(tables(grid), outer), inside(tables(wide), {{15, 20, 8, 10, 4}});
  Field strain(6 * outside.cells());
  for (std::size_t n = 0; n < strain.size(); ++n) strain[n] = 1e-3 * number(n);
  Field here(grid.surface_size(), 0.0), there(wide.surface_size(), 0.0);
  outside.transform(strain, all_axes);
  inside.transform(strain, all_axes);
  for (const Axis axis : all_axes) {
    outside.displacement(axis, here.data());
    inside.displacement(axis, there.data());
    Error error;
    for (std::size_t n = 0; n < here.size(); ++n) {
      error.add(here[n], there[n + static_cast<std::size_t>(24) * grid.ny]);
    }
    CHECK(error.max() < (axis == Axis::z ? 1e-4 : 3e-4));
  }
}

TEST_CASE("a coarse lattice represents the remainder of the smooth continuation") {
  const SmoothContinuation split(4, 8, 0.8, 2);
  const int reach = split.reach();
  for (const auto& parity : {kernels::Parity{}, kernels::Parity{true, false, false},
                             kernels::Parity{true, true, false}}) {
    Field table(static_cast<std::size_t>(reach) * reach);
    double largest = 0.0;
    for (int j = 0; j < reach; ++j) {
      for (int i = 0; i < reach; ++i) {
        const double r = std::hypot(i, j, 1.0);
        double& value = table[static_cast<std::size_t>(j) * reach + i];
        value = (parity.odd_x ? i / r : 1.0) * (parity.odd_y ? j / r : 1.0) / (r * r);
        largest = std::max(largest, std::fabs(value));
      }
    }
    const auto max_abs = [](const Field& values) {
      double found = 0.0;
      for (const double v : values) found = std::max(found, std::fabs(v));
      return found;
    };
    const double before = max_abs(split.rest(table.data(), parity));
    const Field inside = split.inside(table.data(), parity);
    for (int j = 0; j < split.cells(); ++j) {
      std::copy_n(inside.data() + static_cast<std::size_t>(j) * split.cells(), split.cells(),
                  table.data() + static_cast<std::size_t>(j) * reach);
    }
    CHECK(before > 0.2 * largest);
    CHECK(max_abs(split.rest(table.data(), parity)) < 5e-3 * largest);
  }
}
