// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/tangential/shear_problem.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::contact {
namespace {

/// Relative to the displacement of one cell due to its own shear: smaller displacements count as
/// zero.
constexpr double zero_displacement = 1e-8;

}  // namespace

void ShearApplier::scatter(const Field& v, const Stretch& stretch) {
  const std::size_t m = problem_.size(), n = problem_.box_size;
  for_each_cell(2 * n, [&](std::size_t i) { box_[i] = 0.0; });
  for_each_cell(m, [&](std::size_t c) {
    box_[problem_.cells[c]] = v[c];
    box_[n + problem_.cells[c]] = v[m + c];
  });
  stretch.apply(box_);
}

void ShearApplier::gather(const Field& box, Field& v, const Stretch& stretch,
                          std::size_t carried) const {
  const std::size_t m = problem_.size(), n = problem_.box_size;
  for_each_cell(m, [&](std::size_t c) {
    v[c] = box[problem_.cells[c]];
    v[m + c] = box[n + problem_.cells[c]];
    if (carried == 0) return;
    v[c] -= box[problem_.cells[c] + carried];
    v[m + c] -= box[n + problem_.cells[c] + carried];
  });
  stretch.apply(v);
}

void ShearApplier::displacement(const Field& v, Field& u) {
  const auto& exact = problem_.operators->displacement;
  scatter(v, problem_.stretch);
  exact.apply(box_.data(), box_.data(), work_);
  gather(box_, u, problem_.stretch, problem_.carried);
  ++applications_;
  operations_ += exact.cost();
}

void ShearApplier::near(const Field& v, Field& u) {
  const auto& cheap = problem_.operators->near;
  scatter(v, problem_.stretch);
  cheap.apply(box_.data(), near_.data(), work_);
  gather(near_, u, problem_.stretch, problem_.carried);
  operations_ += cheap.cost();
}

void ShearApplier::precondition(const Field& r, Field& z) {
  const auto& preconditioner = problem_.operators->preconditioner;
  scatter(r, inverse_);
  preconditioner.apply(box_.data(), box_.data(), work_);
  gather(box_, z, inverse_);
  operations_ += preconditioner.cost();
}

bool gives_way_to_uniform_shear(const Grid& box,
                                const operators::TangentialDisplacement& displacement) {
  if (box.period.x != box.nx || box.period.y != box.ny) return false;
  Field shear(2 * box.surface_size(), 1.0);
  ComplexField work;
  displacement.apply(shear.data(), shear.data(), work);
  return longest(shear) < zero_displacement * displacement.self_influence();
}

void stretch_to_circle(ShearProblem& problem, const Stretch& stretch) {
  problem.stretch = stretch;
  stretch.apply(problem.free_slip);
  for (ShearProblem::Mode& mode : problem.modes) {
    stretch.apply(mode.direction);
    stretch.apply(mode.own_arms);
  }
}

double ShearProblem::Mode::missing(const Field& shear) const { return target - dot(arms(), shear); }

double dot(const Field& a, const Field& b) { return ordered_dot(a.data(), b.data(), a.size()); }

double longest(const Field& v) {
  const std::size_t m = v.size() / 2;
  return std::sqrt(largest_of(m, [&](std::size_t i) { return v[i] * v[i] + v[m + i] * v[m + i]; }));
}

void add_scaled(double factor, const Field& x, Field& y) {
  for_each_cell(std::ssize(y), [&](std::size_t i) { y[i] += factor * x[i]; });
}

void apply_slip_part(const ShearProblem& problem, Field& slip) {
  const Field& share = problem.slip_part;
  const std::size_t m = share.size() / 3;
  if (m == 0) return;
  problem.stretch.inverse().apply(slip);
  for_each_cell(m, [&](std::size_t i) {
    const double x = slip[i], y = slip[m + i];
    slip[i] = share[i] * x + share[m + i] * y;
    slip[m + i] = share[m + i] * x + share[2 * m + i] * y;
  });
  problem.stretch.apply(slip);
}

void add_motion(const ShearProblem& problem, std::size_t mode, double motion, Field& slip) {
  if (problem.slip_part.empty()) return add_scaled(motion, problem.modes[mode].direction, slip);
  Field moved = problem.modes[mode].direction;
  apply_slip_part(problem, moved);
  add_scaled(motion, moved, slip);
}

void cut_to_bound(const Field& bound, Field& v) {
  const std::size_t m = bound.size();
  for_each_cell(m, [&](std::size_t i) {
    const double length = length_of(v[i], v[m + i]);
    if (!(length > bound[i])) return;
    v[i] *= bound[i] / length;
    v[m + i] *= bound[i] / length;
  });
}

double shear_scale(const ShearProblem& problem, const Field& shear, const Field& slip) {
  const double bound = *std::max_element(problem.bound.begin(), problem.bound.end());
  const double present = std::max(longest(shear), problem.stiffness * longest(slip));
  return std::max(std::min(bound, 10 * present), problem.smallest_shear);
}

double natural_residual(const ShearProblem& problem, const Field& shear, const Field& slip) {
  const std::size_t m = problem.size();
  const double rho = problem.stiffness;
  const double furthest = largest_of(m, [&](std::size_t i) {
    const double x = shear[i] + rho * slip[i], y = shear[m + i] + rho * slip[m + i];
    const double square = x * x + y * y, bound = problem.bound[i];
    const double share = square > bound * bound ? bound / std::sqrt(square) : 1.0;
    const double off_x = shear[i] - share * x, off_y = shear[m + i] - share * y;
    return off_x * off_x + off_y * off_y;
  });
  const double scale = shear_scale(problem, shear, slip);
  double error = std::sqrt(furthest) / scale;
  for (const ShearProblem::Mode& mode : problem.modes) {
    const Field& arms = mode.arms();
    const double possible = ordered_sum(2 * m, [&](std::size_t i) {
      return std::fabs(arms[i]) * std::min(problem.bound[i < m ? i : i - m], scale);
    });
    error = std::max(error, std::fabs(mode.missing(shear)) / possible);
  }
  return error;
}

double energy_gap(const ShearProblem& problem, const Field& shear, const Field& slip) {
  const std::size_t m = problem.size();
  return ordered_sum(m, [&](std::size_t i) {
    return problem.bound[i] * length_of(slip[i], slip[m + i]) - shear[i] * slip[i] -
           shear[m + i] * slip[m + i];
  });
}

}  // namespace samcontact::contact
