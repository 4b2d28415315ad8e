// SPDX-License-Identifier: GPL-3.0-or-later
// Anderson acceleration of a fixed point x = G(x) (Walker & Ni 2011, doi:10.1137/10078356X).
#pragma once

#include <Eigen/Core>
#include <deque>
#include <vector>

#include "samcontact/base/aligned.hpp"

namespace samcontact::contact {

/// Number: precision of the history. It only steers the next iterate, whose residual is computed
/// again in double precision.
template <class Number>
class AndersonOf {
 public:
  explicit AndersonOf(int depth) : depth_(depth) {}

  void reset();
  /// Sets the number of steps in the history from the next call on.
  void set_depth(int depth) { depth_ = depth; }

  /// x: point at which the residual f = G(x) - x was evaluated; replaced by the next iterate. x may
  /// become longer between calls: new entries were zero before, in x and in f.
  void next(Field& x, Field f);

  /// Residual of the last call, empty before the first call; and the point of this residual,
  /// reconstructed from the next iterate as far as the history allows.
  const Field& last_f() const { return last_f_; }
  Field last_x(const Field& x) const;

 private:
  using Vector = std::vector<Number, AlignedAllocator<Number>>;
  struct Step {
    Vector dx, df;
  };
  void remember(const Field& f);
  void advance(Field& x);

  int depth_;
  Field last_f_;
  Vector last_dx_;          // of the last step
  std::deque<Step> steps_;  // oldest first
  Eigen::MatrixXd gram_;    // of the df
};

extern template class AndersonOf<float>;
extern template class AndersonOf<double>;

/// Single precision suffices for smooth problems, and halves the memory.
using Anderson = AndersonOf<float>;

/// Euclidean norm, with equal digits for any number of threads.
double norm(const Field& v);

}  // namespace samcontact::contact
