// SPDX-License-Identifier: GPL-3.0-or-later
// One Newton step on pressure and shear together: the linear system of fixed cell states.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "samcontact/contact/joint/joint_problem.hpp"

namespace samcontact::contact {

/// Maximum number of vectors that a linear solve stores.
constexpr int max_joint_vectors = 80;

/// Newton step. Unknowns of a sticking cell are its three tractions; those of a slipping cell a
/// change along the bound and a change of shear normal to its direction. Motions with a prescribed
/// force are unknowns too. All unknowns are in Pa.
class JointStep {
 public:
  JointStep(const JointProblem& problem, JointState& state, ComplexField& work);

  /// Changes tractions, directions and motions of the state so that the gap of touching cells and
  /// the slip excluded by their states vanish to first order, up to the fraction `gain` of the
  /// residual. Returns the number of GMRES steps.
  int take(double gain);

 private:
  /// Force equation of a motion, and the residual due to a unit motion.
  struct Constraint {
    Field residual, force;
    double residual_length, force_length, missing;
  };

  double* slot(Field& v, int k) const { return v.data() + k * cells_.size(); }
  const double* slot(const Field& v, int k) const { return v.data() + k * cells_.size(); }
  bool slips(std::size_t i) const { return state_.states[i] >= JointCellState::slide; }
  /// Change of pressure, and of shear along the direction, per unit change along the line.
  double pressed(std::size_t i) const {
    return state_.states[i] == JointCellState::slide ? problem_.cone.slope * line_ : 1.0;
  }
  double sheared(std::size_t i) const {
    return state_.states[i] == JointCellState::slide ? line_ : 0.0;
  }
  void find_cells();
  void add_constraints();
  void add_constraint(const Field& direction, double missing);
  Field right_side() const;

  /// Tractions [3][i][j] due to the unknowns, and residuals of the unknowns due to a displacement
  /// [3][i][j].
  void expand(const Field& v, Field& tractions) const;
  void reduce(const Field& displacement, Field& v) const;
  /// Transpose of expand().
  void gather(const Field& tractions, Field& v) const;
  void apply(const Field& v, Field& out);
  void precondition(const Field& v, Field& out);
  void precondition_cells(const Field& v, Field& out);
  void update(const Field& change);
  /// Turns and lengthens the shear of a slipping cell.
  void turn(std::size_t k, double along, double across);

  const JointProblem& problem_;
  JointState& state_;
  ComplexField& work_;
  const std::size_t n_;
  const double line_, normal_, tangential_;  // scale of slide cells; self influences
  std::vector<std::size_t> cells_;           // in contact
  Field length_, lambda_;  // of slipping cells: shear along the direction, stiffness of a turn
  std::vector<Constraint> constraints_;
  std::vector<Field> solved_;  // preconditioned residuals of the motions
  Eigen::MatrixXd schur_;      // pseudo-inverse
  Field box_;
};

}  // namespace samcontact::contact
