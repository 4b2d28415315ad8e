// SPDX-License-Identifier: GPL-3.0-or-later
// One Newton step on pressure and shear together: the linear system of fixed cell states.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "samcontact/contact/joint/joint_problem.hpp"

namespace samcontact::contact {

/// Upper limit of the vectors that a linear solve stores.
constexpr int max_joint_vectors = 80;

/// Unknowns of a touching cell: its three tractions if it sticks; if it slips, a change along its
/// line and one across its direction. Prescribed forces add their motions. All are in Pa.
class JointStep {
 public:
  JointStep(const JointProblem& problem, JointState& state, ComplexField& work);

  /// Changes tractions, directions and motions of the state so that the gap of its touching cells,
  /// and the slip that their states exclude, vanish to first order, to a fraction `gain` of their
  /// residual. Returns the number of GMRES steps.
  int take(double gain);

 private:
  /// Row of the prescribed force of a motion, and the residual due to the motion.
  struct Constraint {
    Field residual, force;
    double residual_length, force_length, missing;
  };

  double* slot(Field& v, int k) const { return v.data() + k * cells_.size(); }
  const double* slot(const Field& v, int k) const { return v.data() + k * cells_.size(); }
  bool slips(std::size_t i) const { return state_.states[i] >= CellState::slide; }
  /// Change of pressure, and of shear along the direction, per unit change along the line.
  double pressed(std::size_t i) const {
    return state_.states[i] == CellState::slide ? problem_.cone.slope * line_ : 1.0;
  }
  double sheared(std::size_t i) const { return state_.states[i] == CellState::slide ? line_ : 0.0; }
  void find_cells();
  void add_constraints();
  void add_constraint(const Field& direction, double missing);
  Field right_side() const;

  /// Tractions [3][i][j] of unknowns, and unknowns of a displacement [3][i][j].
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
  std::vector<std::size_t> cells_;           // that touch
  Field length_, lambda_;  // of slipping cells: shear along the direction, stiffness of a turn
  std::vector<Constraint> constraints_;
  std::vector<Field> solved_;  // preconditioned residuals of the motions
  Eigen::MatrixXd schur_;      // pseudo-inverse
  Field box_;
};

}  // namespace samcontact::contact
