// SPDX-License-Identifier: GPL-3.0-or-later
// Common parts of the partial-slip iterations: the slipping cells, whose shear stays on the circle
// of its bound, and the end of the iteration.
#pragma once

#include <cmath>
#include <cstddef>

#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {

/// A shear of at least this fraction of its bound is on the circle.
constexpr double on_circle = 1 - 1e-9;
/// Minimum part of the squared norm of a rigid motion that cells can follow freely; below it, they
/// do not determine this motion.
constexpr double decisive = 1e-10;

class SlipIteration {
 public:
  virtual ~SlipIteration() = default;
  SlipIteration(const SlipIteration&) = delete;
  SlipIteration(SlipIteration&&) = delete;
  SlipIteration& operator=(const SlipIteration&) = delete;
  SlipIteration& operator=(SlipIteration&&) = delete;

  /// Iterates until the natural residual is below tol; if steps gain little, a fallback is used.
  /// converged is false after max_steps.
  ShearResult run(double tol, int max_steps);

 protected:
  /// self_influence: magnitude of the displacement of a cell under its own unit shear [m/Pa].
  SlipIteration(const ShearProblem& problem, ShearApplier& operators, ShearStart start,
                double self_influence);

  double length(std::size_t i) const { return length_of(r_.shear[i], r_.shear[m_ + i]); }
  bool is_slipping(std::size_t i) const { return r_.slipping[i] != 0; }
  /// Component of the slip along the shear.
  double outward(std::size_t i) const {
    return normal_[i] * r_.slip[i] + normal_[m_ + i] * r_.slip[m_ + i];
  }
  /// |s + rho w|
  double pull(std::size_t i, double rho) const {
    return length_of(r_.shear[i] + rho * r_.slip[i], r_.shear[m_ + i] + rho * r_.slip[m_ + i]);
  }

  /// Marks the cells whose shear is at its bound as slipping.
  void take_slipping();
  /// Scales the shear of a slipping cell to its bound; a cell without shear or bound sticks.
  void put_on_circle(std::size_t i);
  /// Scales the shear of slipping cells, and of cells beyond their bound, which become slipping, to
  /// the bound.
  void slip_beyond_bound();
  void take_normals();
  /// Slipping cells stick if they would slip against their shear; sticking cells at their bound
  /// slip if they would leave it with this stiffness.
  void change_sides(double rho);
  /// Restricts slipping cells to the tangent of their circle.
  void project_free(Field& v) const;
  /// P (C + lambda) v with the approximate operator, which limits the accuracy of a step.
  void apply(const Field& v, Field& out);

  const ShearProblem& problem_;
  ShearApplier& operators_;
  const std::size_t m_;
  const double self_influence_;
  bool gains_little_ = false;  // whether a step gained little, after the first
  ShearResult r_;
  Field normal_, lambda_;  // directions of the shear, and the stiffness of its rotation

 private:
  /// Whether forces change with their motions while the slipping cells keep slipping.
  bool forces_follow() const;
  void stick_everywhere();
  /// Computes motions, slip, normals and error of the present shear.
  virtual void evaluate() = 0;
  /// Chooses the slipping cells from the slip.
  virtual void choose_sets() = 0;
  /// Solves one linear system and updates the shear.
  virtual void step(double tol) = 0;
  /// Fallback iteration that replaces steps without progress.
  virtual void fall_back(double tol) = 0;
  void finish();
};

}  // namespace samcontact::contact
