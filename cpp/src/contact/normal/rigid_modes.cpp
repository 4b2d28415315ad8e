// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/rigid_modes.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/normal/complementarity.hpp"

namespace samcontact::contact {
namespace {

/// Mean square distance of cells from their mean line, relative to the area of a cell, below which
/// the rotation about this line is undetermined.
constexpr double no_extent = 1e-9;
/// Distance between the centre of a pressure and the line of action that counts as zero, relative
/// to the largest arm.
constexpr double arm_rounding = 1e-15;
/// Newton's method for the exponents: maximum number of steps, and change of the exponent of any
/// cell in one step.
constexpr int max_exponent_steps = 120;
constexpr double max_exponent_change = 2.0;
/// Change of the exponent after which the method ends.
constexpr double last_exponent_change = 1e-9;

double longest_arm(const std::vector<double>& arms) {
  return std::max(std::fabs(arms.front()), std::fabs(arms.back()));
}

double shorter_arm(const std::vector<double>& arms) {
  return std::min(std::fabs(arms.front()), std::fabs(arms.back()));
}

}  // namespace

RigidModes::RigidModes(const Drive& drive, const Grid& grid)
    : normal_(drive.normal), cell_area_(grid.cell_area()), size_{grid.dy, grid.dx} {
  arms_ = {grid.y(), grid.x()};
  for (double& x : arms_[1]) x = -x;
  for (int k = 0; k < 2; ++k) {
    free_[k] = drive.tilt[k].is_force() && normal_.is_force() && normal_.value > 0;
    if (!free_[k]) continue;
    centre_[k] = drive.tilt[k].value / normal_.value;
    for (double& arm : arms_[k]) arm -= centre_[k];
  }
}

RigidModes RigidModes::coarsened() const {
  RigidModes coarse = *this;
  coarse.cell_area_ *= 4;
  for (int k = 0; k < 2; ++k) {
    coarse.size_[k] *= 2;
    const std::vector<double>& fine = arms_[k];
    coarse.arms_[k].clear();
    // A last coarse cell that extends beyond the grid has its centre at the edge of the fine cell.
    const double half = 0.5 * (k == 0 ? size_[k] : -size_[k]);
    for (std::size_t i = 0; i < fine.size(); i += 2) coarse.arms_[k].push_back(fine[i] + half);
  }
  return coarse;
}

RigidModes RigidModes::over(const Box& box) const {
  RigidModes part = *this;
  part.arms_[0].assign(arms_[0].begin() + box.j0, arms_[0].begin() + box.j0 + box.ny);
  part.arms_[1].assign(arms_[1].begin() + box.i0, arms_[1].begin() + box.i0 + box.nx);
  return part;
}

Box RigidModes::united(Box box) const {
  if (!tilts()) return box;
  const auto around = [](const std::vector<double>& arms, bool free, int& first, int& count) {
    if (!free) return;
    const auto nearest =
        std::min_element(arms.begin(), arms.end(),
                         [](double a, double b) { return std::fabs(a) < std::fabs(b); }) -
        arms.begin();
    const int last = std::min(static_cast<int>(nearest) + 2, static_cast<int>(arms.size()));
    const int start = std::max(static_cast<int>(nearest) - 1, 0);
    const int end = std::max(first + count, last);
    first = std::min(first, start);
    count = end - first;
  };
  around(arms_[0], free_[0], box.j0, box.ny);
  around(arms_[1], free_[1], box.i0, box.nx);
  return box;
}

AboutAxes RigidModes::solve(const Sums& s) const {
  if (!tilts() || !(s.weight > 0)) return {};
  const auto spread = [&](double product, double a, double b) {
    return product - a * b / s.weight;
  };
  const double xx = spread(s.xx, s.arm[0], s.arm[0]), yy = spread(s.yy, s.arm[1], s.arm[1]);
  const double xy = free_[0] && free_[1] ? spread(s.xy, s.arm[0], s.arm[1]) : 0.0;
  const double a = free_[0] ? spread(s.moment[0], s.arm[0], s.field) : 0.0;
  const double b = free_[1] ? spread(s.moment[1], s.arm[1], s.field) : 0.0;
  const double least = no_extent * s.weight * size_[0] * size_[1];
  // Principal directions of the cells, so that a line of cells determines one rotation.
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy), c = std::cos(angle), d = std::sin(angle);
  const std::array<double, 2> stiff{c * c * xx + 2 * c * d * xy + d * d * yy,
                                    d * d * xx - 2 * c * d * xy + c * c * yy};
  const double first = stiff[0] > least ? (c * a + d * b) / stiff[0] : 0.0;
  const double second = stiff[1] > least ? (c * b - d * a) / stiff[1] : 0.0;
  return {free_[0] ? c * first - d * second : 0.0, free_[1] ? d * first + c * second : 0.0};
}

double RigidModes::factor(const AboutAxes& exponents, std::size_t cell) const {
  const std::size_t ny = arms_[0].size();
  return std::exp(exponents[0] * arms_[0][cell % ny] + exponents[1] * arms_[1][cell / ny]);
}

bool RigidModes::find_exponents(const Field& pressure, AboutAxes& exponents) const {
  const AboutAxes longest{longest_arm(arms_[0]), longest_arm(arms_[1])};
  const auto none = [](std::size_t) { return 0.0; };
  exponents = {};
  for (int n = 0; n < max_exponent_steps; ++n) {
    const bool plain = exponents == AboutAxes{};
    Sums s = sums(
        [&](std::size_t i) {
          return plain || pressure[i] == 0 ? pressure[i] : pressure[i] * factor(exponents, i);
        },
        none);
    if (!(s.weight > 0) || !std::isfinite(s.weight)) return false;
    bool met = true;
    for (int k = 0; k < 2; ++k) {
      met = met && (!free_[k] || std::fabs(s.arm[k]) <= arm_rounding * longest[k] * s.weight);
      s.moment[k] = -s.arm[k];  // of the wanted change
    }
    if (met) return true;
    // The change of the centre per exponent is the spread of the pressure.
    AboutAxes change = solve(s);
    const double most = std::fabs(change[0]) * longest[0] + std::fabs(change[1]) * longest[1];
    if (!(most > 0)) return false;
    const double share = std::min(1.0, max_exponent_change / most);
    for (int k = 0; k < 2; ++k) exponents[k] += change[k] * share;
    // Newton's method squares this change: only the last digits of the centre remain.
    if (most < last_exponent_change) return true;
  }
  return false;
}

bool RigidModes::meet(Field& pressure) const {
  AboutAxes exponents{};
  if (tilts()) {
    if (!find_exponents(pressure, exponents)) return false;
    if (exponents != AboutAxes{}) {
      for_each_cell(std::ssize(pressure), [&](std::ptrdiff_t i) {
        if (in_contact(pressure[i])) pressure[i] *= factor(exponents, i);
      });
    }
  }
  scale(pressure);
  return true;
}

double RigidModes::scale(Field& pressure) const {
  return normal_.is_force() ? scale_to_sum(pressure, normal_.value / cell_area_) : 1.0;
}

RigidModes RigidModes::within(double largest_gap) const {
  RigidModes part = *this;
  part.largest_gap_ = largest_gap;
  return part;
}

bool RigidModes::meet_anywhere(const Field& gap, Field& pressure) const {
  const auto is_zero = [](double p) { return p == 0; };
  if (tilts() && std::all_of(pressure.begin(), pressure.end(), is_zero)) {
    // The largest rectangle of cells around the line of action, without cells that have no body:
    // their gaps would dominate the tilt.
    const double along_y = free_[0] ? shorter_arm(arms_[0]) : INFINITY;
    const double along_x = free_[1] ? shorter_arm(arms_[1]) : INFINITY;
    const std::size_t ny = arms_[0].size();
    for_each_cell(std::ssize(pressure), [&](std::ptrdiff_t i) {
      const bool inside = std::fabs(arms_[0][i % ny]) <= along_y + 0.5 * size_[0] &&
                          std::fabs(arms_[1][i / ny]) <= along_x + 0.5 * size_[1];
      pressure[i] = inside && gap[i] <= largest_gap_ ? 1.0 : 0.0;
    });
  }
  if (meet(pressure)) return true;
  std::fill(pressure.begin(), pressure.end(), 1.0);
  return meet(pressure);
}

bool RigidModes::is_met(const Field& pressure, double tol) const {
  if (!normal_.is_force()) return true;
  const double sum = normal_.value / cell_area_;
  const double present = ordered_sum(pressure.size(), [&](std::size_t i) { return pressure[i]; });
  if (std::fabs(present - sum) > tol * sum) return false;
  if (!tilts()) return true;
  const Sums s = sums([&](std::size_t i) { return pressure[i]; }, [](std::size_t) { return 0.0; });
  bool met = true;
  for (int k = 0; k < 2; ++k) {
    met = met && (!free_[k] || std::fabs(s.arm[k]) <= tol * longest_arm(arms_[k]) * sum);
  }
  return met;
}

void RigidModes::lower(const AboutAxes& tilt, Field& field) const {
  if (tilt == AboutAxes{}) return;
  const std::size_t ny = arms_[0].size();
  for_each_cell(std::ssize(field), [&](std::ptrdiff_t i) {
    field[i] -= tilt[0] * arms_[0][i % ny] + tilt[1] * arms_[1][i / ny];
  });
}

AboutAxes RigidModes::level(const Field& pressure, Field& field) const {
  if (!tilts()) return {};
  const AboutAxes tilt =
      slope(field, [&](std::size_t i) { return in_contact(pressure[i]) ? pressure[i] : 0.0; });
  lower(tilt, field);
  return tilt;
}

RigidMotion RigidModes::close(const Field& pressure, Field& field) const {
  const AboutAxes tilt = level(pressure, field);
  const double approach = normal_.is_force() ? contact_mean(pressure, field) : normal_.value;
  for_each_cell(std::ssize(field), [&](std::ptrdiff_t i) { field[i] -= approach; });
  if (!tilts()) return {approach};
  return {approach - tilt[0] * centre_[0] - tilt[1] * centre_[1], tilt};
}

}  // namespace samcontact::contact
