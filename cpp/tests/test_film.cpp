// SPDX-License-Identifier: GPL-3.0-or-later
// Flow of a film: derivatives, conservation of mass, symmetry of the schemes.
#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <random>

#include "samcontact/film/reynolds.hpp"

namespace samcontact::film {
namespace {

/// Barus: Q = (1 - exp(-alpha p))/(alpha eta0), constant density slope.
LubricantTable oil() {
  LubricantTable::Nodes nodes{1e6, 0.01, {}, {}, {}, {}};
  const double eta = 0.04, alpha = 2e-8, slope = 1e-10;
  for (int n = 0; n < 1000; ++n) {
    const double p = nodes.scale * std::expm1(n * nodes.step);
    nodes.reduced.push_back((1 - std::exp(-alpha * p)) / (alpha * eta));
    nodes.fluidity.push_back(std::exp(-alpha * p) / eta);
    nodes.density.push_back(1 + slope * p);
    nodes.density_slope.push_back(slope);
  }
  return LubricantTable(nodes);
}

FilmFields random_fields(const Grid& grid, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  FilmFields fields;
  for (std::size_t i = 0; i < grid.surface_size(); ++i) {
    const bool cavitated = unit(random) < 0.2;
    fields.pressure.push_back(cavitated ? 0.0 : 1e7 * unit(random));
    fields.film.push_back(1e-7 * (1 + unit(random)));
    fields.void_fraction.push_back(cavitated ? unit(random) : 0.0);
  }
  return fields;
}

FaceVelocities turning(const Grid& grid, double u, double v, double spin) {
  FaceVelocities velocities;
  for (int i = 0; i <= grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) velocities.along_x.push_back(u - spin * (j - 3));
  }
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j <= grid.ny; ++j) velocities.along_y.push_back(v + spin * (i - 4));
  }
  return velocities;
}

PressureFlow random_flow(const FaceVelocities& faces) {
  std::mt19937 random(5);  // NOLINT(bugprone-random-generator-seed): the same in every run
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto fields = [&](std::size_t count) {
    PressureFlow::Faces given;
    for (std::size_t i = 0; i < count; ++i) {
      given.factor.push_back(1 + unit(random));
      given.fluidity.push_back(20 * unit(random));
      given.slope.push_back(5e-15 * unit(random));
      given.added.push_back(1e-8 * unit(random));
    }
    return given;
  };
  return {fields(faces.along_x.size()), fields(faces.along_y.size())};
}

}  // namespace

TEST_CASE("the slopes of the outflow are its derivatives") {
  const LubricantTable table = oil();
  for (const bool wraps : {false, true}) {
    Grid grid(9, 8, 1e-5, 2e-5);
    if (wraps) grid = grid.made_periodic(false, true);
    for (int order = 1; order <= 3; ++order) {
      for (const double layer : {0.0, 8e-9, -1.0}) {
        const FaceVelocities velocities = turning(grid, 0.8, -0.3, 0.1);
        FlowSettings settings;
        settings.order = order;
        settings.boundary_thickness = std::max(layer, 0.0);
        if (layer < 0) settings.pressure_flow = random_flow(velocities);
        const Reynolds reynolds(grid, velocities, table, settings);
        const FilmFields at = random_fields(grid, 7);
        const FilmFields by = random_fields(grid, 8);
        Reynolds::Slopes slopes{Star(reynolds.lattice()), Star(reynolds.lattice()),
                                Star(reynolds.lattice())};
        reynolds.outflow(at, slopes);
        Field expected(grid.surface_size(), 0.0);
        slopes.pressure.add_product(by.pressure, expected);
        slopes.film.add_product(by.film, expected);
        slopes.void_fraction.add_product(by.void_fraction, expected);
        const double step = 1e-6;
        const auto moved = [&](double h) {
          FilmFields fields = at;
          for (std::size_t i = 0; i < fields.film.size(); ++i) {
            fields.pressure[i] += h * by.pressure[i];
            fields.film[i] += h * by.film[i];
            fields.void_fraction[i] += h * by.void_fraction[i];
          }
          return reynolds.outflow(fields);
        };
        const Field up = moved(step), down = moved(-step);
        double largest = 0.0, error = 0.0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
          const double found = (up[i] - down[i]) / (2 * step);
          // Pressures below zero are not in the table.
          if (at.pressure[i] == 0) continue;
          largest = std::max(largest, std::fabs(expected[i]));
          error = std::max(error, std::fabs(found - expected[i]));
        }
        CAPTURE(order);
        CAPTURE(layer);
        CHECK(largest > 0);
        CHECK(error < 2e-2 * largest);
      }
    }
  }
}

TEST_CASE("what leaves a cell enters its neighbour") {
  const LubricantTable table = oil();
  const Grid grid = Grid(10, 6, 1e-5, 1e-5).made_periodic(false, true);
  const FaceVelocities velocities = turning(grid, 0.0, 0.7, 0.0);
  const Reynolds reynolds(grid, velocities, table, {});
  FilmFields fields = random_fields(grid, 3);
  // No flow through the edges along x.
  for (int j = 0; j < grid.ny; ++j) {
    fields.pressure[j] = fields.pressure[(grid.nx - 1) * grid.ny + j] = 0.0;
  }
  const Field outflow = reynolds.outflow(fields);
  double sum = 0.0, largest = 0.0;
  for (const double value : outflow) {
    sum += value;
    largest = std::max(largest, std::fabs(value));
  }
  CHECK(std::fabs(sum) < 1e-13 * largest * static_cast<double>(outflow.size()));
}

}  // namespace samcontact::film
