// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/lagged_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "samcontact/contact/iteration/anderson.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

constexpr int max_iterations = 200;
// With dissimilar materials, shear that rotates by 90 degrees from iteration to iteration grows
// beyond mu beta = 1, although a solution exists for any mu: from this contraction factor on, the
// iterations are accelerated.
constexpr double slow_contraction = 0.5;
constexpr int depth = 12;

/// Largest change between two fields on the cells in contact; under load control a uniform change
/// is only a change of approach.
double change_in_contact(const Field& a, const Field& b, const Field& pressure, bool load_driven) {
  double lowest = INFINITY, highest = -INFINITY;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!in_contact(pressure[i])) continue;
    lowest = std::min(lowest, a[i] - b[i]);
    highest = std::max(highest, a[i] - b[i]);
  }
  if (!(lowest <= highest)) return 0.0;
  return load_driven ? highest - lowest : std::max(std::fabs(lowest), std::fabs(highest));
}

/// Replaces the separation computed from `estimate` by the next estimate.
void accelerate(Anderson& anderson, Field& estimate, Field& separation) {
  for (std::size_t i = 0; i < estimate.size(); ++i) separation[i] -= estimate[i];
  anderson.next(estimate, std::move(separation));
  separation = estimate;
}

}  // namespace

Solution solve_lagged(const LaggedContact& contact, const Field& gap, Given normal, Field pressure,
                      double tol) {
  const bool load_driven = normal.is_force();
  Field separation(gap.size()), previous(gap.size()), lagged(gap.size());
  int iterations = 0, applications = 0;
  double work = 0.0;
  const auto update = [&](const Field& p) {
    contact.separate(p, separation);
    ++applications;
    ++work;
  };
  update(pressure);

  Solution solution;
  Anderson anderson(depth);
  double outer_error = 1.0;
  bool slow = false;
  for (int n = 0; n < max_iterations; ++n) {
    for (std::size_t i = 0; i < gap.size(); ++i) lagged[i] = gap[i] + separation[i];
    const double inner_tol = std::clamp(0.1 * outer_error, 0.3 * tol, 1e-2);
    solution = contact.solve(lagged, std::move(pressure), std::max(inner_tol, 1e-13));
    iterations += solution.iterations;
    applications += solution.operator_applications;
    work += solution.work;
    if (!solution.converged) break;
    std::swap(previous, separation);
    update(solution.tractions.pressure);
    // Gap with the updated separation; its scale is the elastic displacement in the contact.
    double scale = 0.0;
    for (std::size_t i = 0; i < gap.size(); ++i) {
      scale = std::max(scale, std::fabs(solution.gap[i] + solution.motion.approach - lagged[i]));
    }
    const double change =
        change_in_contact(separation, previous, solution.tractions.pressure, load_driven);
    // The surfaces may be separated by shear that no longer exists.
    const bool parted = solution.load == 0 && !is_zero(previous);
    const double error = parted ? 1.0 : scale > 0 ? change / scale : 0.0;
    slow = slow || (n > 0 && error > slow_contraction * outer_error);
    outer_error = error;
    solution.error += outer_error;
    for (std::size_t i = 0; i < gap.size(); ++i) solution.gap[i] += separation[i] - previous[i];
    if (load_driven) {
      // The part of the change that is uniform over the contact is a rigid-body motion.
      const double shift = contact_mean(solution.tractions.pressure, solution.gap);
      for (double& g : solution.gap) g -= shift;
      solution.motion.approach += shift;
    }
    solution.converged = solution.error <= tol;
    if (solution.converged) break;
    pressure = solution.tractions.pressure;
    if (slow) accelerate(anderson, previous, separation);
  }
  solution.iterations = iterations;
  solution.operator_applications = applications;
  solution.work = work;
  return solution;
}

}  // namespace samcontact::contact
