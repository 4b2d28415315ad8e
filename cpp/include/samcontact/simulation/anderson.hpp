// SPDX-License-Identifier: GPL-3.0-or-later
// Anderson acceleration of a fixed point x = G(x) (Walker & Ni 2011, doi:10.1137/10078356X).
#pragma once

#include <vector>

#include "samcontact/base/aligned.hpp"

namespace samcontact::simulation {

class Anderson {
 public:
  explicit Anderson(int depth) : depth_(depth) {}

  void reset();

  /// x: where the residual f = G(x) - x was taken; replaced by the next iterate.
  void next(Field& x, const Field& f);

 private:
  int depth_;
  Field last_x_, last_f_;
  std::vector<Field> dx_, df_;  // oldest first
};

/// Euclidean norm, the same digits for any number of threads.
double norm(const Field& v);

}  // namespace samcontact::simulation
