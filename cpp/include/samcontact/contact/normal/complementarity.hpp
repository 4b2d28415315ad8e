// SPDX-License-Identifier: GPL-3.0-or-later
// The frictionless contact problem on a grid: p >= 0, g = h + K p - delta >= 0, p g = 0. What all
// its solvers share. Where surfaces attract each other, p is the repulsion (see Attraction).
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/normal/drive.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::contact {

struct Solution {
  operators::Tractions tractions;  // on body 2
  Field gap;                       // [i][j] [m]; +inf where there is no body
  RigidMotion motion;
  double load = 0.0;  // [N]
  /// max over cells of |min(p / max p, g / max u)|: pressure where there is a gap, and gap or
  /// penetration where there is pressure, each relative to its own scale.
  double error = 0.0;
  /// Gaps up to this are none [m]: rounding, where displacement has no mean.
  double rounding = 0.0;
  /// Conjugate-gradient steps on the grid itself; those on coarser grids do not count.
  int iterations = 0;
  /// Applications of the exact operators (pressure or shear to displacement) on the grid itself.
  int operator_applications = 0;
  /// Transforms of the whole solve, coarse grids and preconditioner included, in applications of
  /// the exact operator.
  double work = 0.0;
  bool converged = true;
  /// Steps that met a direction in which the operator is not positive: frictional heat can do that.
  int negative_curvatures = 0;
  /// Which border the contact touches and the remedy; empty when it touches none.
  std::string border_complaint;
};

bool all_finite(const Field& field);
/// Whether all of a solution is; comparisons with NaN are false, so that it may look converged.
bool is_finite(const Solution& solution);

/// Mean of a field over the cells with pressure; 0 without any.
double contact_mean(const Field& pressure, const Field& field);

/// The error of Solution, from pressure, displacement and gap; gaps up to `rounding` [m] are none.
double complementarity_error(const Field& pressure, const Field& displacement, const Field& gap,
                             double rounding = 0.0);

/// The same with displacement and gap as functions of the cell.
template <class Displacement, class Gap>
double complementarity_error(const Field& pressure, const Displacement& displacement,
                             const Gap& gap) {
  const std::size_t n = pressure.size();
  const double p_max = largest_of(n, [&](std::size_t i) { return pressure[i]; });
  // Heat may raise a surface more than pressure lowers it.
  const double u_max = largest_of(n, [&](std::size_t i) { return std::fabs(displacement(i)); });
  if (p_max <= 0 || u_max <= 0) {
    // No pressure yet: any penetration counts in full.
    return largest_of(n, [&](std::size_t i) { return -gap(i); }) > 0 ? 1.0 : 0.0;
  }
  const double over_p = 1.0 / p_max, over_u = 1.0 / u_max;
  return largest_of(n, [&](std::size_t i) {
    const double p = pressure[i] * over_p, g = gap(i) * over_u;
    return std::fabs(p < g ? p : g);
  });
}

/// Multiplies the pressure so that it sums to `sum`, and returns the factor; a pressure that is
/// zero everywhere becomes uniform.
double scale_to_sum(Field& pressure, double sum);

/// gap = initial gap + displacement - approach. Returns the approach: under load the mean of the
/// rest over the contact, else the one given.
double close_gap(const Field& initial_gap, const Field& displacement, const Field& pressure,
                 Given normal, Field& gap);

}  // namespace samcontact::contact
