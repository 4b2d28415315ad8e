// SPDX-License-Identifier: GPL-3.0-or-later
// A rough contact solved with plastic strain in zones, and in one box.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "samcontact/simulation/simulation.hpp"
#include "samcontact/simulation/state/surface_fields.hpp"

using namespace samcontact;
using namespace samcontact::simulation;

namespace {

const Grid grid(96, 96, 1e-6, 1e-6, 0, 1e-6);

/// Sixteen bumps of different heights and radii, in rows and columns that are not straight.
Field bumps() {
  Field gap(grid.surface_size(), std::numeric_limits<double>::infinity());
  const auto x = grid.x(), y = grid.y();
  for (int n = 0; n < 16; ++n) {
    const auto part = [n](double factor) { return std::sin(factor * n + 0.5); };
    const int row = n / 4, column = n % 4;
    const double x0 = (column - 1.5) * 20e-6 + 4e-6 * part(2.3);
    const double y0 = (row - 1.5) * 20e-6 + 4e-6 * part(3.1);
    const double radius = 60e-6 * (1 + 0.3 * part(1.7)), low = 0.15e-6 * (1 + part(4.1));
    for (int i = 0; i < grid.nx; ++i) {
      for (int j = 0; j < grid.ny; ++j) {
        double& here = gap[static_cast<std::size_t>(i) * grid.ny + j];
        const double r = std::hypot(x[i] - x0, y[j] - y0);
        here = std::min(here, low + r * r / (2 * radius));
      }
    }
  }
  return gap;
}

Simulation pressed(bool one_zone, const operators::BandSplit& split) {
  const auto steel =
      plasticity::Material::with_law(210e9, 0.3, plasticity::LinearHardening{1.2e9, 10e9});
  Simulation simulation(grid, plasticity::Material::make_rigid(), steel, bumps(),
                        contact::FrictionLaw(contact::FullSliding{0.0}),
                        {.tol = 1e-6,
                         .increment_tol = 0.0,
                         .max_iterations = 60,
                         .on_border = contact::OnBorder::error,
                         .residual_stress = operators::ResidualMethod::fast,
                         .image_tol = 1e-6,
                         .reach = 0,
                         .one_zone = one_zone,
                         .split = split});
  simulation.step({.drive = contact::Drive::load(2.0)});
  return simulation;
}

double rms(const Field& values, const Field& reference) {
  double squares = 0.0, of = 0.0;
  for (std::size_t n = 0; n < reference.size(); ++n) {
    squares += (values[n] - reference[n]) * (values[n] - reference[n]);
    of += reference[n] * reference[n];
  }
  return std::sqrt(squares / of);
}

}  // namespace

TEST_CASE("a finer band decomposition brings a solution in zones closer to that in one box" *
          doctest::test_suite("accuracy")) {
  const operators::BandSplit finer{.near_range = 12,
                                   .middle_range = 32,
                                   .middle_sharpness = 2.2,
                                   .far_sharpness = 2.1,
                                   .window_width = 10,
                                   .middle_gap = 20};
  const Box volume{0, 0, grid.nx, grid.ny, 30};
  const Simulation whole = pressed(true, {});
  const auto errors = [&](const operators::BandSplit& split) {
    const Simulation simulation = pressed(false, split);
    CHECK(simulation.state().flow_boxes[1].size() > 2);
    const auto &own = simulation.state(), &of_box = whole.state();
    return std::array{rms(own.tractions.pressure, of_box.tractions.pressure),
                      rms(own.plastic[1]->strain(volume), of_box.plastic[1]->strain(volume)),
                      rms(residual_displacement(own, 1, operators::Axis::z),
                          residual_displacement(of_box, 1, operators::Axis::z))};
  };
  const auto usual = errors({}), fine = errors(finer);
  for (std::size_t n = 0; n < usual.size(); ++n) {
    CHECK(usual[n] < 1e-3);
    CHECK(fine[n] < 0.2 * usual[n]);
  }
}
