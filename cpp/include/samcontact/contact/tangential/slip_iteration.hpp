// SPDX-License-Identifier: GPL-3.0-or-later
// What iterations of stick and slip have in common: the cells that slip, whose shear stays on the
// circle of its bound, and when the iteration ends.
#pragma once

#include <cmath>
#include <cstddef>

#include "samcontact/contact/tangential/shear_problem.hpp"

namespace samcontact::contact {

/// A shear of this share of its bound is on it.
constexpr double on_circle = 1 - 1e-9;
/// Directions in which the cells that are free make up this share of a motion decide it.
constexpr double decisive = 1e-10;

class SlipIteration {
 public:
  virtual ~SlipIteration() = default;
  SlipIteration(const SlipIteration&) = delete;
  SlipIteration(SlipIteration&&) = delete;
  SlipIteration& operator=(const SlipIteration&) = delete;
  SlipIteration& operator=(SlipIteration&&) = delete;

  /// Steps until the natural residual is below tol; where steps gain little, another method helps.
  /// Converged = false after most_steps.
  ShearResult run(double tol, int most_steps);

 protected:
  /// self_influence: of one cell on what it slips, without sign [m/Pa].
  SlipIteration(const ShearProblem& problem, ShearApplier& operators, ShearStart start,
                double self_influence);

  double length(std::size_t i) const { return length_of(r_.shear[i], r_.shear[m_ + i]); }
  bool is_slipping(std::size_t i) const { return r_.slipping[i] != 0; }
  /// Of the slip, along the shear.
  double outward(std::size_t i) const {
    return normal_[i] * r_.slip[i] + normal_[m_ + i] * r_.slip[m_ + i];
  }
  /// |s + rho w|
  double pull(std::size_t i, double rho) const {
    return length_of(r_.shear[i] + rho * r_.slip[i], r_.shear[m_ + i] + rho * r_.slip[m_ + i]);
  }

  /// Cells whose shear is on its bound.
  void take_slipping();
  /// A cell without shear or bound sticks.
  void put_on_circle(std::size_t i);
  /// All that slip, and those beyond their bound, which slip then.
  void slip_beyond_bound();
  void take_normals();
  /// Slipping cells stick where they would slip against their shear, sticking ones on their bound
  /// slip where they would leave it by this stiffness.
  void change_sides(double rho);
  /// Leaves slipping cells their tangent.
  void project_free(Field& v) const;
  /// P (C + lambda) v, nearly: a step gains no more than the cheap operator is good for.
  void apply(const Field& v, Field& out);

  const ShearProblem& problem_;
  ShearApplier& operators_;
  const std::size_t m_;
  const double self_influence_;
  bool gains_little_ = false;  // a step did, after the first
  ShearResult r_;
  Field normal_, lambda_;  // directions of the shear, and what its turn costs

 private:
  /// Whether forces change with their motions while the cells that slip go on to do so.
  bool forces_follow() const;
  void stick_everywhere();
  /// Motions, slip, normals and error of the present shear.
  virtual void evaluate() = 0;
  /// Which cells slip, from what they slip.
  virtual void choose_sets() = 0;
  /// One linear solve, and the shear that it leads to.
  virtual void step(double tol) = 0;
  /// Where steps are in vain.
  virtual void fall_back(double tol) = 0;
  void finish();
};

}  // namespace samcontact::contact
