// SPDX-License-Identifier: GPL-3.0-or-later
// Steel ball on an aluminium half-space: the contact solver compared with Hertz's closed form.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <numbers>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/operators/medium/half_space.hpp"

namespace sam = samcontact;

namespace {

/// Contact radius [m], maximum pressure [Pa] and approach [m].
struct Contact {
  double radius, pressure, approach;
};

/// 1 / E* is the sum of (1 - nu^2) / E of the two bodies (Johnson 1985, section 4.2).
Contact hertz(const sam::Elastic& one, const sam::Elastic& two, double radius, double load) {
  const auto compliance = [](const sam::Elastic& e) { return (1 - e.nu * e.nu) / e.E; };
  const double modulus = 1 / (compliance(one) + compliance(two));
  const double a = std::cbrt(3 * load * radius / (4 * modulus));
  return {a, 3 * load / (2 * std::numbers::pi * a * a), a * a / radius};
}

/// Numerical solution with 128 x 128 cells over 1.5 times the contact diameter.
Contact solved(const sam::Elastic& one, const sam::Elastic& two, double radius, double load) {
  constexpr int cells = 128;
  const double size = 3 * hertz(one, two, radius, load).radius / cells;
  const sam::Grid grid(cells, cells, size, size);
  sam::Field gap;  // [i][j]: y is fastest
  for (const double x : grid.x()) {
    for (const double y : grid.y()) gap.push_back((x * x + y * y) / (2 * radius));
  }
  const sam::contact::ContactSolver solver(
      grid, sam::operators::half_space(one), sam::operators::half_space(two),
      sam::contact::FrictionLaw(sam::contact::FullSliding{0.0}));
  const sam::contact::Solution found =
      solver.solve(gap, sam::contact::Drive::load(load), {}, sam::contact::ContactSettings{});
  const sam::Field& pressure = found.tractions.pressure;
  const auto loaded =
      std::count_if(pressure.begin(), pressure.end(), [](double p) { return p > 0; });
  return {std::sqrt(static_cast<double>(loaded) * grid.cell_area() / std::numbers::pi),
          *std::max_element(pressure.begin(), pressure.end()), found.motion.approach};
}

/// Prints both values; true if they differ by less than 1 %.
bool agree(const char* name, const char* unit, double found, double exact) {
  std::printf("%-16s %.6e %s, Hertz %.6e %s\n", name, found, unit, exact, unit);
  return std::fabs(found / exact - 1) < 0.01;
}

}  // namespace

int main() {
  try {
    const auto steel = sam::Elastic::isotropic(210e9, 0.3);
    const auto aluminium = sam::Elastic::isotropic(70e9, 0.33);
    const double radius = 10e-3, load = 50.0;  // [m], [N]
    const Contact exact = hertz(steel, aluminium, radius, load);
    const Contact found = solved(steel, aluminium, radius, load);
    const bool radius_agrees = agree("contact radius", "m", found.radius, exact.radius);
    const bool pressure_agrees = agree("largest pressure", "Pa", found.pressure, exact.pressure);
    const bool approach_agrees = agree("approach", "m", found.approach, exact.approach);
    return radius_agrees && pressure_agrees && approach_agrees ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
