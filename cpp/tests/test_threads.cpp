// SPDX-License-Identifier: GPL-3.0-or-later
// Threads of the caller, each with OpenMP threads of its own: the digits are those of serial runs.
// Fields are large enough for every parallel loop to have several threads.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <thread>
#include <vector>

#include "samcontact/base/threads.hpp"
#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/fft/padded_transform.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/operators/heat/heat_medium.hpp"
#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/simulation/simulation.hpp"
#include "samcontact/simulation/state/strain_fields.hpp"
#include "samcontact/simulation/state/stress_fields.hpp"
#include "samcontact/simulation/state/surface_fields.hpp"
#include "samcontact/simulation/state/temperature_fields.hpp"

using namespace samcontact;
using namespace samcontact::simulation;

namespace {

constexpr double size = 60e-6, fine = 50e-6;
const Settings usual{.tol = 1e-6,
                     .increment_tol = 0.0,
                     .max_iterations = 60,
                     .on_border = contact::OnBorder::error,
                     .residual_stress = operators::ResidualMethod::fast,
                     .image_tol = 1e-3,
                     .reach = 0};
const Thermal warm = Thermal::of(50.2, 11.7e-6, 1.367e-5);
const auto elastic = plasticity::Material::make_elastic(210e9, 0.3);
const auto steel =
    plasticity::Material::with_law(210e9, 0.3, plasticity::LinearHardening{1e9, 21e9});

using Work = std::function<std::vector<Field>()>;

/// Results of two tasks that run at the same time.
std::vector<Field> at_once(const Work& one, const Work& two) {
  std::vector<Field> first, second;
  {
    const std::jthread other([&] { second = two(); });
    first = one();
  }
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<Field> one_by_one(const Work& one, const Work& two) {
  std::vector<Field> first = one();
  const std::vector<Field> second = two();
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Ball without mirror planes, so that whole boxes are solved for.
Field ball(const Grid& grid, double radius) {
  Field gap;
  for (const double x : grid.x()) {
    for (const double y : grid.y()) gap.push_back((x * x + y * y + 0.2 * x * y) / (2 * radius));
  }
  return gap;
}

Target load(double newton) { return {.drive = contact::Drive::load(newton)}; }

/// Loaded with transient heat, in steps too short for heat to reach the next cell.
Simulation heated_setup(double heat_factor) {
  const Grid grid(13, 11, size, size, 6, size);
  Simulation simulation(grid, elastic, steel.with_thermal(warm), ball(grid, 7.5e-3),
                        contact::FrictionLaw(contact::FullSliding{0.1}), usual,
                        {.shortest = 2e-5, .longest = 1e-2});
  for (const double newton : {120.0, 150.0}) {
    Target target = load(newton);
    target.heating[1] = {.factor = heat_factor, .thermal = {{}, warm}};
    target.duration = 5e-5;
    simulation.step(target);
  }
  return simulation;
}

}  // namespace

TEST_CASE("plans can be made in several threads") {
  const auto spectra = [](int first) {
    return [first] {
      std::vector<Field> found;
      for (int n = first; n < first + 12; ++n) {
        const fft::PaddedTransform transform(n, n + 1);
        const fft::ParitySpectrum parity(transform);
        Field quarter(parity.size(), 0.0);
        quarter[0] = n;
        parity.transform(quarter.data(), false, false);
        found.push_back(quarter);
      }
      return found;
    };
  };
  CHECK(at_once(spectra(3), spectra(5)) == one_by_one(spectra(3), spectra(5)));
}

TEST_CASE("threads share a contact solver") {
  const Grid grid(190, 180, size, size);
  REQUIRE(grid.surface_size() >= min_parallel_cells);
  const Field gap = ball(grid, 7.5e-3);
  const auto solve = [&](const contact::ContactSolver& solver, double newton) {
    return [&, newton] {
      const auto solution = solver.solve(gap, contact::Drive::load(newton), {}, {.tol = 1e-4});
      return std::vector<Field>{
          solution.tractions.pressure, solution.gap, {solution.motion.approach}};
    };
  };
  // Each with its own boxes, so that one thread releases operators that the other may still use.
  const auto medium = operators::half_space(elastic.elastic);
  const contact::ContactSolver alone(grid, medium, medium,
                                     contact::FrictionLaw(contact::FullSliding{0.0}));
  const contact::ContactSolver shared(grid, medium, medium,
                                      contact::FrictionLaw(contact::FullSliding{0.0}));
  const double wide = 1.5e6, narrow = 1e4;
  CHECK(at_once(solve(shared, wide), solve(shared, narrow)) ==
        one_by_one(solve(alone, wide), solve(alone, narrow)));
}

TEST_CASE("threads sum the modes of a wake in layers") {
  const Stack coated{{{{400e9, 0.25}, 2 * size}}, {210e9, 0.3}};
  const operators::Heating heating{
      .factor = 1.0, .thermal = {{{{5.0, 8e-6, 2e-6}, 2 * size}}, warm}, .speed_x = 0.5};
  const auto body = operators::heated_body(coated);
  const auto table = [&](int nx) {
    return [&, nx] {
      const auto offsets = operators::Offsets::lattice(size, size, nx, 3);
      const auto parts = body->displacement(heating, size, size, offsets);
      return std::vector<Field>{parts[0], parts[1]};
    };
  };
  CHECK(at_once(table(4), table(5)) == one_by_one(table(4), table(5)));
}

TEST_CASE("simulations run in separate threads") {
  const auto flow = [](double newton) {
    return [newton] {
      const Grid grid(30, 28, fine, fine, 26, fine);
      Settings settings = usual;
      settings.tol = 1e-3;
      Simulation simulation(grid, elastic, steel, ball(grid, 7.5e-3),
                            contact::FrictionLaw(contact::FullSliding{0.0}), settings);
      const State& state = simulation.step(load(newton));
      return std::vector<Field>{state.tractions.pressure, plastic_strain(state, 1),
                                residual_displacement(state, 1, operators::Axis::z)};
    };
  };
  CHECK(at_once(flow(1900.0), flow(1700.0)) == one_by_one(flow(1900.0), flow(1700.0)));
}

TEST_CASE("threads compute fields of one state") {
  const auto alone = heated_setup(0.05), shared = heated_setup(0.05);
  const auto stresses = [](const Simulation& simulation) {
    return [&simulation] {
      const State& state = simulation.state();
      return std::vector<Field>{stress(state, 1), temperature(state, 1)};
    };
  };
  const auto others = [](const Simulation& simulation) {
    return [&simulation] {
      const State& state = simulation.state();
      return std::vector<Field>{temperature(state, 1), residual_stress(state, 1),
                                surface_displacement(state, 1), stress(state, 1)};
    };
  };
  CHECK(at_once(stresses(shared), others(shared)) == one_by_one(stresses(alone), others(alone)));
}
