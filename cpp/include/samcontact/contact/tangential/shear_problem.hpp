// SPDX-License-Identifier: GPL-3.0-or-later
// Shear under a given pressure: |s| <= bound, no slip below the bound, slip along the shear on it.
// What its iterations share, on the cells of contact of one box.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/contact/tangential/tangential_preconditioner.hpp"

namespace samcontact::contact {

/// Shear below this share of the largest pressure, or of the largest bound, is none.
constexpr double smallest_share = 1e-12;

/// Vectors are [component][cell] on the cells of contact.
///
///   min 1/2 s'C s - s'b   over |s_i| <= bound_i,  direction_k's = target_k
///
/// The slip w = b + sum of motion_k direction_k - C s is minus the gradient, and the motions are
/// the multipliers of the forces; but for cells that touch late.
struct ShearProblem {
  /// A rigid motion whose force is given.
  struct Mode {
    Field direction;      // slip of a unit motion
    double target;        // sum of arms . shear over the cells: force over the area of a cell [Pa]
    int axis = 2;         // 0, 1: along x, y; 2: the turn
    Field own_arms = {};  // empty: the direction, as virtual work has it

    const Field& arms() const { return own_arms.empty() ? direction : own_arms; }
    double missing(const Field& shear) const;
  };

  const ShearOperators* operators = nullptr;
  std::size_t box_size = 0;
  std::vector<std::size_t> cells;  // their indices in the box
  /// 0, or C stands for C - T C: the displacement less that of the cell whose index in the box is
  /// larger by so much, from which the material comes.
  std::size_t carried = 0;
  Field bound;      // of the friction law, > 0 [Pa], may be infinite
  Field free_slip;  // b [m]
  /// Nothing resists a shear that is the same everywhere: the bodies have no ends and touch
  /// everywhere. C has no inverse there, and what they slip on the mean is given.
  bool floats = false;
  std::vector<Mode> modes;
  /// What each cell slips in touch of a rigid motion: a symmetric matrix, [xx, xy, yy][cell];
  /// empty: all of it.
  Field in_touch;
  /// A slip of one scale of the contact times this is its scale of shear [Pa/m].
  double stiffness = 0.0;
  /// Shear below this is none [Pa].
  double smallest_shear = 0.0;

  std::size_t size() const { return cells.size(); }
};

/// Applies the operators of a problem, and counts.
class ShearApplier {
 public:
  explicit ShearApplier(const ShearProblem& problem)
      : problem_(problem), box_(2 * problem.box_size, 0.0), near_(box_.size()) {}

  /// u = C v on the cells of contact; may be the same field.
  void displacement(const Field& v, Field& u);
  /// Nearly.
  void near(const Field& v, Field& u);
  void precondition(const Field& r, Field& z);

  /// Adds what another one has done.
  void count(const ShearApplier& other) {
    applications_ += other.applications_;
    operations_ += other.operations_;
  }

  /// Of the exact operator.
  int applications() const { return applications_; }
  /// In the unit of fft::filter_cost.
  double operations() const { return operations_; }

 private:
  void scatter(const Field& v);
  /// The box less what lies `carried` cells ahead.
  void gather(const Field& box, Field& v, std::size_t carried = 0) const;

  const ShearProblem& problem_;
  Field box_, near_;
  ComplexField work_;
  int applications_ = 0;
  double operations_ = 0.0;
};

/// Whether a shear that is the same everywhere in a box displaces nothing along the surface: on
/// whole periods, unless layers lie on a rigid base.
bool gives_way_to_uniform_shear(const Grid& box,
                                const operators::TangentialDisplacement& displacement);

/// Of a vector; hypot takes ten times as long, for a range that shear and slip do not need.
inline double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// sum of a . b.
double dot(const Field& a, const Field& b);
/// The largest length of a vector.
double longest(const Field& v);
/// y += factor x.
void add_scaled(double factor, const Field& x, Field& y);
/// Leaves of the slip by a rigid motion what cells do in touch.
void keep_in_touch(const ShearProblem& problem, Field& slip);
/// Adds a motion of a mode to the slip of the cells.
void add_motion(const ShearProblem& problem, std::size_t mode, double motion, Field& slip);
/// Shortens each vector that is longer than its bound.
void cut_to_bound(const Field& bound, Field& v);

/// What e_t is relative to [Pa]: the largest bound, or ten times the largest shear where that is
/// much less, as it is without slip.
double shear_scale(const ShearProblem& problem, const Field& shear, const Field& slip);
/// max |s - P(s + stiffness w)| over the scale, P the nearest point within the bound; and the share
/// by which forces are missed.
double natural_residual(const ShearProblem& problem, const Field& shear, const Field& slip);
/// sum (bound |w| - s . w): with the area of a cell, energy that friction could still turn over. No
/// number where the bound is infinite.
double energy_gap(const ShearProblem& problem, const Field& shear, const Field& slip);

/// Where an iteration starts, and where it ends.
struct ShearStart {
  Field shear;                          // empty: none
  std::vector<unsigned char> slipping;  // empty: where the shear is at its bound
  std::vector<double> motion;           // of the modes; empty: none
};

struct ShearResult {
  Field shear, slip;
  std::vector<unsigned char> slipping;
  std::vector<double> motion;
  double error = 0.0;       // natural_residual
  double energy_gap = 0.0;  // times the area of a cell: [J]
  int steps = 0;            // outer ones
  int iterations = 0;       // conjugate-gradient steps
  int fallbacks = 0;        // times that projected gradients had to help
  bool converged = false;
};

}  // namespace samcontact::contact
