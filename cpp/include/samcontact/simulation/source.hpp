// SPDX-License-Identifier: GPL-3.0-or-later
// What moves the surfaces and stresses the bodies besides the contact and the flow that an
// increment solves for.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"

namespace samcontact::simulation {

class Source {
 public:
  virtual ~Source() = default;
  /// Adds its part of the separation of the surfaces [i][j] of the grid.
  virtual void open(Field& gap) const = 0;
  /// Adds its stress in a box of a body, [component][k][i][j] of the tensor; an empty field is 0.
  virtual void stress(int body, const Box& box, operators::Tensor tensor, Field& sum) = 0;
};

/// Adds a field to a sum that is empty while it is 0.
inline void add_to(Field& sum, Field&& part) {
  if (sum.empty()) {
    sum = std::move(part);
  } else {
    for (std::size_t n = 0; n < part.size(); ++n) sum[n] += part[n];
  }
}

}  // namespace samcontact::simulation
