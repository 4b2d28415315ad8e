// SPDX-License-Identifier: GPL-3.0-or-later
// Coverage-guided fuzzing of the entry points of the core: any problem is solved, or rejected with
// one of the documented errors. Otherwise libFuzzer, the sanitizers and the checks below end the
// process.
#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "samcontact/base/memory.hpp"
#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/operators/medium/half_space.hpp"
#include "samcontact/simulation/simulation.hpp"
#include "samcontact/simulation/state/strain_fields.hpp"

using namespace samcontact;

namespace {

void check(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

bool is_finite(const Field& field) {
  return std::all_of(field.begin(), field.end(), [](double v) { return std::isfinite(v); });
}

/// Bytes as numbers, counts and choices.
class Draw {
 public:
  Draw(const std::uint8_t* bytes, std::size_t count) : bytes_(bytes, count) {}

  int count(int lowest, int highest) { return bytes_.ConsumeIntegralInRange(lowest, highest); }
  bool coin() { return bytes_.ConsumeBool(); }

  /// Mostly within `decades` of a usual value; occasionally any double, including NaN and
  /// infinities.
  double number(double usual, double decades) {
    if (count(0, 31) == 0) return any();
    const double exponent = bytes_.ConsumeFloatingPointInRange(-decades, decades);
    return usual * std::pow(10.0, exponent);
  }
  double between(double low, double high) {
    if (count(0, 31) == 0) return any();
    return bytes_.ConsumeFloatingPointInRange(low, high);
  }

 private:
  double any() {
    const auto bits = bytes_.ConsumeIntegral<std::uint64_t>();
    double value = 0.0;
    static_assert(sizeof value == sizeof bits);
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  FuzzedDataProvider bytes_;
};

plasticity::Material material(Draw& draw) {
  const double E = draw.number(2e11, 3), nu = draw.between(0.0, 0.49);
  switch (draw.count(0, 4)) {
    case 0:
      return plasticity::Material::make_rigid();
    case 1:
      return plasticity::Material::make_elastic(E, nu);
    case 2:
      return plasticity::Material::with_law(E, nu, plasticity::PerfectPlastic{draw.number(1e9, 1)});
    case 3: {
      const double yield_stress = draw.number(1e9, 1), tangent_modulus = draw.number(2e10, 2);
      return plasticity::Material::with_law(
          E, nu, plasticity::LinearHardening{yield_stress, tangent_modulus});
    }
    default: {
      const double B = draw.number(1e9, 1), C = draw.number(20.0, 1);
      return plasticity::Material::with_law(E, nu,
                                            plasticity::Swift{B, C, draw.between(0.01, 0.5)});
    }
  }
}

Field heights(Draw& draw, std::size_t count) {
  const double scale = draw.number(1e-6, 3);
  Field gap(count);
  for (double& g : gap) g = scale * draw.between(0.0, 1.0);
  return gap;
}

void contact_of(Draw& draw) {
  const double dx = draw.number(1e-5, 3), dy = dx * draw.number(1.0, 1);
  const Grid grid(draw.count(0, 9), draw.count(1, 9), dx, dy);
  const auto body1 = operators::half_space(material(draw).elastic);
  const auto body2 = operators::half_space(material(draw).elastic);
  const double friction = draw.coin() ? 0.0 : draw.between(0.0, 1.0);
  const contact::ContactSolver solver(grid, body1, body2,
                                      contact::FrictionLaw(contact::FullSliding{friction}));
  const contact::ContactSettings settings{.tol = draw.number(1e-6, 5),
                                          .max_iterations = draw.count(0, 200),
                                          .on_border = contact::OnBorder::warn};
  const bool by_load = draw.coin();
  const double value = by_load ? draw.number(1.0, 6) : draw.number(1e-6, 4);
  const Field gap = heights(draw, grid.surface_size());
  const auto found = solver.solve(
      gap, by_load ? contact::Drive::load(value) : contact::Drive::approach(value), {}, settings);
  check(found.converged, "what is returned has converged");
  check(is_finite(found.tractions.pressure) && is_finite(found.gap), "fields are finite");
  double sum = 0.0;
  for (const double p : found.tractions.pressure) {
    check(p >= 0, "no tension");
    sum += p;
  }
  if (by_load) check(std::fabs(sum * grid.cell_area() - value) <= 1e-9 * value, "the load");
}

/// Refuses problems that need much memory, e.g. a plastic zone of very many thin layers.
void limit_memory(double bytes, const std::string& what) {
  constexpr double limit = 1e8;
  if (bytes > limit) throw std::invalid_argument("not enough memory for " + what);
}

void steps_of(Draw& draw) {
  const double dx = draw.number(1e-5, 1);
  const Grid grid(draw.count(1, 6), draw.count(1, 6), dx, dx * draw.number(1.0, 0.5),
                  draw.count(0, 4), dx * draw.number(1.0, 0.5));
  const auto body1 = material(draw), body2 = material(draw);
  const double coefficient = draw.coin() ? 0.0 : draw.between(0.0, 0.5);
  const auto friction = draw.coin() ? contact::FrictionLaw(contact::Coulomb{coefficient})
                                    : contact::FrictionLaw(contact::FullSliding{coefficient});
  const simulation::Settings settings{
      .tol = draw.number(1e-4, 2),
      .increment_tol = 0.0,
      .max_iterations = draw.count(0, 10),
      .on_border = contact::OnBorder::warn,
      .residual_stress =
          draw.coin() ? operators::ResidualMethod::exact : operators::ResidualMethod::fast,
      // The images of a long or deep box are summed cell by cell: few and coarse cells here.
      .image_tol = 0.1,
      .reach = 0,
      .max_halvings = draw.count(0, 1)};
  simulation::Simulation simulation(grid, body1, body2, heights(draw, grid.surface_size()),
                                    friction, settings);
  for (int increments = draw.count(1, 2); increments > 0; --increments) {
    simulation::Target target;
    target.drive = draw.coin() ? contact::Drive::load(draw.number(1.0, 3))
                               : contact::Drive::approach(draw.number(1e-6, 2));
    for (auto& given : target.tangential) {
      given = draw.coin() ? contact::Given::force(draw.between(-1.0, 1.0))
                          : contact::Given::motion(draw.between(-1e-5, 1e-5));
    }
    const auto& state = simulation.step(target);
    check(is_finite(state.tractions.pressure), "pressure is finite");
    check(is_finite(state.tractions.shear_x) && is_finite(state.slip), "shear and slip are finite");
    for (int body = 0; body < 2; ++body) {
      if (!state.plastic[body]) continue;
      check(is_finite(simulation::plastic_strain(state, body)), "plastic strain is finite");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  set_memory_check(limit_memory);
  Draw draw(bytes, count);
  try {
    draw.coin() ? contact_of(draw) : steps_of(draw);
  } catch (const std::invalid_argument&) {
  } catch (const ConvergenceError&) {
  }
  return 0;
}
