// SPDX-License-Identifier: GPL-3.0-or-later
// Pressure and shear together: data, state and error of an increment of dissimilar bodies with
// friction.
#pragma once

#include <cstddef>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/contact/joint/joint_preconditioner.hpp"
#include "samcontact/contact/laws/contact_law.hpp"
#include "samcontact/contact/laws/friction_law.hpp"
#include "samcontact/contact/laws/stretch.hpp"
#include "samcontact/contact/normal/drive.hpp"
#include "samcontact/operators/surface/relative_displacement.hpp"

namespace samcontact::contact {

/// Boundary of the admissible pressures and shears of a friction law: p = slope |s| up to |s| =
/// cap, then |s| = cap. Slope 0 (no slip, with infinite cap; constant limit of the shear): a cell
/// may carry shear at zero pressure.
struct FrictionCone {
  double slope;  // [-]
  double cap;    // [Pa]

  explicit FrictionCone(const FrictionLaw& law)
      : slope(1 / law.ratio(0.0)), cap(law.bound(INFINITY)) {}
  /// Maximum shear at a pressure; at zero pressure and slope 0, any shear up to the cap is on the
  /// boundary.
  double radius(double pressure, double shear) const {
    if (slope > 0) return std::min(std::max(pressure, 0.0) / slope, cap);
    if (in_contact(pressure)) return cap;
    return std::min(shear, cap);
  }
};

/// State of a cell.
enum class JointCellState : unsigned char {
  open,    // no tractions
  stick,   // gap 0, slip 0
  slide,   // gap 0, p = slope |s|, slip along the shear
  capped,  // gap 0, |s| = cap, slip along the shear
};

struct JointOperators {
  operators::RelativeDisplacement displacement;
  JointPreconditioner preconditioner;

  JointOperators(const Grid& grid, const operators::TangentialInfluence& influence)
      : displacement(grid, influence), preconditioner(grid, influence) {}
};

/// Fields over the n cells of a grid; vectors are [2][cell], tractions [3][cell] as (p, s_x, s_y).
///
///   g = gap + K p + B s - approach - tilts,  w = free_slip + rigid motion - (B'p + C s)
///
/// Shears and slips are in the coordinates in which the admissible shears are circles.
struct JointProblem {
  /// Rigid motion with a prescribed force.
  struct Mode {
    Field direction;  // slip, or lowering of body 1, due to a unit motion
    /// Sum of direction . shear, or pressure, over the cells: force over the area of a cell [Pa].
    double target;
  };

  const JointOperators* operators = nullptr;
  Field gap;       // without tractions [m]; +inf: no body
  Given normal{};  // approach [m], or sum of the pressures [Pa]
  /// Tilts with a prescribed moment: lever arms [m], and their target over the pressures.
  std::vector<Mode> tilts = {};
  FrictionCone cone;
  Field free_slip;  // slip due neither to rigid motion nor to tractions [m]
  Field motion;     // slip due to the prescribed rigid motion [m]
  std::vector<Mode> modes = {};
  /// Scale of shear per scale of slip of the contact [Pa/m].
  double stiffness = 0.0;
  double rounding = 0.0;  // gaps up to this value count as closed [m]
  CircleCoordinates circle = {};

  std::size_t size() const { return gap.size(); }
  /// Sets the coordinates, and changes the slips of the problem to them.
  void use(CircleCoordinates coordinates);
  /// Displacement due to tractions, and tractions by the preconditioner, in these coordinates;
  /// [3][cell], may be the same array.
  void displace(const Field& tractions, Field& displacement, ComplexField& work) const;
  void precondition(Field& displacement, ComplexField& work) const;
};

/// Iterate, and the fields due to its tractions and motions.
struct JointState {
  Field tractions;                     // [3][cell] [Pa]
  std::vector<JointCellState> states;  // [cell]
  Field direction;                     // [2][cell] unit vectors of the shear of slipping cells
  double approach = 0.0;               // [m]
  std::vector<double> tilt;            // of the problem's tilts [rad]
  std::vector<double> motion;          // of the modes [m, rad]

  Field displacement = {};  // [3][cell] (u_z, u_x, u_y) [m]
  Field gap = {}, slip = {};
  double pressure_error = 0.0, shear_error = 0.0;

  double shear(std::size_t i) const;
  /// Component of the slip along the direction.
  double outward(std::size_t i) const;
  double error() const { return std::max(pressure_error, shear_error); }
};

/// State with these tractions, which decide whether a cell slips, sticks or is open. Without
/// pressure, the cells with the smallest gaps stick.
JointState start_from(const JointProblem& problem, Field tractions);

/// Sets the tractions of open cells to zero, and those of slipping cells to the bound.
void put_on_lines(const FrictionCone& cone, JointState& state);

/// Updates displacement, gap, slip and errors.
void evaluate(const JointProblem& problem, JointState& state, ComplexField& work);

}  // namespace samcontact::contact
