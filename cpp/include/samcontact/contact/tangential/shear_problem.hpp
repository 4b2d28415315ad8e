// SPDX-License-Identifier: GPL-3.0-or-later
// Shear problem under a given pressure: |s| <= bound, no slip below the bound, slip along the shear
// at the bound. Data and functions shared by its iterations, on the cells in contact of one box.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/contact/laws/stretch.hpp"
#include "samcontact/contact/tangential/tangential_preconditioner.hpp"

namespace samcontact::contact {

/// Shear below this fraction of the largest pressure, or of the largest bound, counts as zero.
constexpr double smallest_fraction = 1e-12;

/// Vectors are [component][cell] on the cells in contact.
///
///   min 1/2 s'C s - s'b   over |s_i| <= bound_i,  direction_k's = target_k
///
/// The slip w = b + sum of motion_k direction_k - C s is minus the gradient, and the motions are
/// the multipliers of the forces, except for newly contacting cells. If the admissible shears form
/// an ellipse, all vectors are in the coordinates in which it is a circle: s stands for M^-1 s, C
/// for M C M, and slips for M times the slip (`stretch_to_circle`).
struct ShearProblem {
  /// Rigid motion with a prescribed force.
  struct Mode {
    Field direction;      // slip due to a unit motion
    double target;        // sum of arms . shear over the cells: force over the area of a cell [Pa]
    int axis = 2;         // 0, 1: along x, y; 2: rotation
    Field own_arms = {};  // empty: the direction, by virtual work

    const Field& arms() const { return own_arms.empty() ? direction : own_arms; }
    double missing(const Field& shear) const;
  };

  const ShearOperators* operators = nullptr;
  std::size_t box_size = 0;
  std::vector<std::size_t> cells;  // indices of the cells in the box
  /// 0, or offset of the upstream cell: C then stands for C - T C, the displacement less that of
  /// the cell whose index in the box is larger by this offset, from which the material comes.
  std::size_t carried = 0;
  Field bound;      // of the friction law, > 0 [Pa], may be infinite
  Field free_slip;  // b [m]
  /// Whether nothing resists a uniform shear, because infinite bodies touch everywhere. C then has
  /// no inverse, and the mean slip is given.
  bool floats = false;
  std::vector<Mode> modes;
  /// Fraction of the slip due to a rigid motion that occurs in contact, as a symmetric matrix for
  /// each cell, [xx, xy, yy][cell]; empty: 1.
  Field slip_part;
  Stretch stretch = {};  // M
  /// Scale of shear per scale of slip of the contact [Pa/m].
  double stiffness = 0.0;
  /// Shear below this counts as zero [Pa].
  double smallest_shear = 0.0;

  std::size_t size() const { return cells.size(); }
};

/// Applies the operators of a problem and counts the applications.
class ShearApplier {
 public:
  explicit ShearApplier(const ShearProblem& problem)
      : problem_(problem),
        inverse_(problem.stretch.inverse()),
        box_(2 * problem.box_size, 0.0),
        near_(box_.size()) {}

  /// u = C v on the cells in contact; both may be the same field.
  void displacement(const Field& v, Field& u);
  /// u = C v by the approximate operator.
  void near(const Field& v, Field& u);
  void precondition(const Field& r, Field& z);

  /// Adds the counts of another applier.
  void count(const ShearApplier& other) {
    applications_ += other.applications_;
    operations_ += other.operations_;
  }

  /// Applications of the exact operator.
  int applications() const { return applications_; }
  /// Operations in units of fft::filter_cost.
  double operations() const { return operations_; }

 private:
  /// Both multiply the vectors by a matrix.
  void scatter(const Field& v, const Stretch& stretch);
  /// Values of the box at the cells, less those `carried` cells ahead.
  void gather(const Field& box, Field& v, const Stretch& stretch, std::size_t carried = 0) const;

  const ShearProblem& problem_;
  const Stretch inverse_;
  Field box_, near_;
  ComplexField work_;
  int applications_ = 0;
  double operations_ = 0.0;
};

/// Whether a uniform shear on a box causes no tangential displacement: on whole periods, unless
/// layers lie on a rigid base.
bool gives_way_to_uniform_shear(const Grid& box,
                                const operators::TangentialDisplacement& displacement);

/// Sets the ellipse of the admissible shears, and changes free slip and motions to the coordinates
/// in which it is a circle.
void stretch_to_circle(ShearProblem& problem, const Stretch& stretch);

/// Length of a vector; hypot takes ten times as long, for a range that shear and slip do not need.
inline double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// sum of a . b.
double dot(const Field& a, const Field& b);
/// Maximum length of a vector.
double longest(const Field& v);
/// y += factor x.
void add_scaled(double factor, const Field& x, Field& y);
/// Multiplies the slip due to a rigid motion by the part that occurs in contact.
void apply_slip_part(const ShearProblem& problem, Field& slip);
/// Adds the slip due to a motion of a mode.
void add_motion(const ShearProblem& problem, std::size_t mode, double motion, Field& slip);
/// Shortens each vector that is longer than its bound.
void cut_to_bound(const Field& bound, Field& v);

/// Reference value of the error e_t [Pa]: the largest bound, or ten times the largest shear if that
/// is much less, as it is if friction prevents slip.
double shear_scale(const ShearProblem& problem, const Field& shear, const Field& slip);
/// max |s - P(s + stiffness w)| over the scale, P the nearest point within the bound; and the
/// relative error of the prescribed forces.
double natural_residual(const ShearProblem& problem, const Field& shear, const Field& slip);
/// sum (bound |w| - s . w): times the area of a cell, the energy that friction could still
/// dissipate. NaN if the bound is infinite.
double energy_gap(const ShearProblem& problem, const Field& shear, const Field& slip);

/// Start of an iteration.
struct ShearStart {
  Field shear;                          // empty: none
  std::vector<unsigned char> slipping;  // empty: cells whose shear is at its bound
  std::vector<double> motion;           // of the modes; empty: none
};

struct ShearResult {
  Field shear, slip;
  std::vector<unsigned char> slipping;
  std::vector<double> motion;
  double error = 0.0;       // natural_residual
  double energy_gap = 0.0;  // times the area of a cell: [J]
  int steps = 0;            // outer steps
  int iterations = 0;       // conjugate-gradient steps
  int fallbacks = 0;        // number of fallbacks to projected gradients
  bool converged = false;
};

}  // namespace samcontact::contact
