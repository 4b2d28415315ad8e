// SPDX-License-Identifier: GPL-3.0-or-later
// Operators of zones on a periodic surface, against those of the whole box.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/operators/zones/zone_operators.hpp"
#include "stress_above.hpp"

using namespace samcontact;
using namespace samcontact::operators;

namespace {

const Elastic steel{210e9, 0.3};
/// At a corner, with the images of others in its margin, across most of a period, and in the
/// middle.
const std::vector<Box> zones{
    {0, 0, 14, 11, 5}, {114, 4, 14, 12, 6}, {2, 82, 9, 14, 3}, {40, 2, 20, 60, 8}};

Grid periodic_grid() {
  Grid grid(128, 96, 1e-6, 1.25e-6, 8, 0.9e-6);
  grid.period = {128, 96, 0.0};
  return grid;
}

double number(std::size_t n) { return std::sin(1.7 * static_cast<double>(n) + 0.3); }

/// [component][cell] of the zones; at the ends of the surface the strain continues in the next
/// zone.
Field zone_strain(int parts, std::size_t cells) {
  Field strain(parts * cells, 0.0);
  for (int c = 0; c < parts; ++c) {
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

/// Spots over the zones and a uniform mean.
Field load(const Grid& grid, double factor) {
  Field field(grid.surface_size(), factor * 2e8);
  for (const Box& zone : zones) {
    for (int i = zone.i0; i < zone.i0 + zone.nx; ++i) {
      for (int j = zone.j0; j < zone.j0 + zone.ny; ++j) {
        const std::size_t at = static_cast<std::size_t>(i) * grid.ny + j;
        field[at] = factor * 1e9 * (1.5 + number(at));
      }
    }
  }
  return field;
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

/// Stress of zones against that of all cells.
Error of_stress(ZoneOperators& operators, const Field* strain, const Tractions& tractions,
                const Field& whole, const Grid& grid, int parts) {
  Error error;
  operators.for_each_layer(strain, tractions, -1.0, [&](std::size_t z, int k, const double* layer) {
    const Box& zone = zones[z];
    const Box at{zone.i0, zone.j0, zone.nx, zone.ny, 1};
    Field part(zone.surface_size());
#pragma omp critical
    for (int c = 0; c < parts; ++c) {
      extract(whole.data() + (static_cast<std::size_t>(c) * grid.nz + k) * grid.surface_size(),
              Box::surface(grid), part.data(), at);
      for (const double reference : part) error.add(*layer++, reference);
    }
  });
  return error;
}

}  // namespace

TEST_CASE("zones on a periodic surface agree with the whole box") {
  const Grid grid = periodic_grid();
  const auto medium = half_space(steel);
  for (const Tensor tensor : {Tensor::full, Tensor::deviator}) {
    const int parts = count(tensor);
    ZoneOperators operators(std::make_shared<const ZoneTables>(grid, medium, tensor, 1e-5), zones);
    const VolumeOperators whole(grid, medium,
                                {tensor, Symmetry::none, ResidualMethod::fast, 1e-5, {}});
    const Field strain = zone_strain(parts, operators.cells());
    Field everywhere(parts * grid.volume_size(), 0.0);
    for (int c = 0; c < parts; ++c) {
      std::size_t at = c * operators.cells();
      for (const Box& zone : zones) {
        insert(strain.data() + at, zone, everywhere.data() + c * grid.volume_size(),
               Box::whole(grid));
        at += zone.volume_size();
      }
    }
    operators.transform(strain, all_axes);
    VolumeSpectrum spectrum = whole.make_spectrum();
    forward(whole.transform(), everywhere.data(), spectrum);
    Field displacement(grid.surface_size()), reference(grid.surface_size());
    for (const Axis axis : all_axes) {
      operators.displacement(axis, displacement.data());
      whole.residual_displacement(axis).apply(spectrum, reference.data());
      Error moved;
      for (std::size_t n = 0; n < reference.size(); ++n) moved.add(displacement[n], reference[n]);
      CHECK(moved.rms() < 1e-3);
      CHECK(moved.max() < 1e-3);
    }
    const Tractions none{Field(grid.surface_size(), 0.0), {}, {}};
    const Error residual = of_stress(operators, &strain, none,
                                     whole.stress(everywhere.data(), nullptr, -1.0), grid, parts);
    CHECK(residual.rms() < 1.5e-3);
    CHECK(residual.max() < 3e-3);
    const Tractions loads{load(grid, 1.0), load(grid, 0.3), load(grid, -0.2)};
    const Error elastic =
        of_stress(operators, nullptr, loads, whole.stress(nullptr, &loads, -1.0), grid, parts);
    CHECK(elastic.rms() < 6e-4);
    CHECK(elastic.max() < 6e-4);
  }
}

TEST_CASE("stress is within its bound on a periodic surface") {
  const Grid grid = periodic_grid();
  const auto medium = half_space(steel);
  const VolumeOperators whole(grid, medium,
                              {Tensor::deviator, Symmetry::none, ResidualMethod::fast, 1e-5, {}});
  const StressBound bound(std::make_shared<const ZoneTables>(grid, medium, Tensor::deviator, 1e-5),
                          middles(grid));
  const Above above = stress_above(grid, whole, bound, {load(grid, 1.0), load(grid, 0.3), {}});
  CHECK(above.lowest > -0.02);
  CHECK(above.mean < 2.5);
}
