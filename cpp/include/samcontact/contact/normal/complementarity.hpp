// SPDX-License-Identifier: GPL-3.0-or-later
// Frictionless contact problem on a grid: p >= 0, g = h + K p - delta >= 0, p g = 0. Data and
// functions shared by its solvers. With attraction, p is the repulsion (see Attraction).
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/reduce.hpp"
#include "samcontact/contact/normal/drive.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::contact {

struct Solution {
  operators::Tractions tractions;  // on body 2
  Field gap;                       // [i][j] [m]; +inf in cells without a body
  RigidMotion motion;
  double load = 0.0;   // [N]
  AboutAxes moment{};  // about the origin of the grid [N m]
  /// max over cells of |min(p / max p, g / max u)|: pressure in open cells, and gap or
  /// interpenetration in closed cells, each relative to its own scale.
  double error = 0.0;
  /// Gaps up to this value count as closed [m]: rounding error of a displacement without mean
  /// value.
  double rounding = 0.0;
  /// Conjugate-gradient steps on the grid itself, not on coarser grids.
  int iterations = 0;
  /// Applications of the exact operators (pressure or shear to displacement) on the grid itself.
  int operator_applications = 0;
  /// Transforms of the whole solve, including coarse grids and preconditioner, as a number of
  /// applications of the exact operator.
  double work = 0.0;
  bool converged = true;
  /// Number of steps along a direction in which the operator is not positive, as may occur with
  /// frictional heat.
  int negative_curvatures = 0;
  /// Message that names the edges of the grid reached by the contact and the remedy; empty: none.
  std::string edge_warning;
};

bool all_finite(const Field& field);
/// Whether all values of a solution are finite. Comparisons with NaN are false, so a solution with
/// NaN may appear to have converged.
bool is_finite(const Solution& solution);

/// Solution of bodies that a drive separates or brings just into touch, without pressure; none if
/// it presses them together. lowest: smallest gap [m].
std::optional<Solution> separated(const Field& gap, double lowest, const Given& normal);

/// Gap up to which cells count as closed if the displacement has no mean value [m]: its rounding
/// error, from that of the longest wave with the mean pressure. lowest: smallest gap [m].
double rounding_error(const Field& gap, double lowest, double longest_wave);

/// Mean of a field over the cells with pressure; 0 if there are none.
double contact_mean(const Field& pressure, const Field& field);

/// Error of a Solution, from pressure, displacement and gap; gaps up to `rounding` [m] count as
/// closed.
double complementarity_error(const Field& pressure, const Field& displacement, const Field& gap,
                             double rounding = 0.0);

/// Complementarity error, with displacement and gap as functions of the cell.
template <class Displacement, class Gap>
double complementarity_error(const Field& pressure, const Displacement& displacement,
                             const Gap& gap) {
  const std::size_t n = pressure.size();
  const double p_max = largest_of(n, [&](std::size_t i) { return pressure[i]; });
  // Thermal expansion of a surface may exceed its elastic compression.
  const double u_max = largest_of(n, [&](std::size_t i) { return std::fabs(displacement(i)); });
  if (p_max <= 0 || u_max <= 0) {
    // Without pressure, any interpenetration counts in full.
    return largest_of(n, [&](std::size_t i) { return -gap(i); }) > 0 ? 1.0 : 0.0;
  }
  const double over_p = 1.0 / p_max, over_u = 1.0 / u_max;
  return largest_of(n, [&](std::size_t i) {
    const double p = pressure[i] * over_p, g = gap(i) * over_u;
    return std::fabs(p < g ? p : g);
  });
}

/// Scales the pressure to the sum `sum` and returns the factor; a pressure that is zero everywhere
/// becomes uniform.
double scale_to_sum(Field& pressure, double sum);

/// Moments of a pressure on body 2 about x and y at the origin of the grid [N m].
AboutAxes moments(const Grid& grid, const Field& pressure);

}  // namespace samcontact::contact
