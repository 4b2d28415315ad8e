// SPDX-License-Identifier: GPL-3.0-or-later
// Surface displacement of one body due to tractions, with kernels that are kept.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <span>
#include <utility>

#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// Without heat and free faces. Kernels are built when they are first needed. Thread-safe.
class BodyDisplacement {
 public:
  BodyDisplacement(const Grid& grid, SharedMedium medium);

  /// Displacement along axes [axis][i][j] [m] due to tractions [i][j] in the frame of the grid,
  /// whose shear acts on the body with a sign. One transform for each traction and axis.
  Field operator()(const Tractions& tractions, double shear_sign, std::span<const Axis> axes) const;

  /// Work of tractions [J], one half of which is elastic energy if both are equal: tractions
  /// `force` on the displacement due to tractions `cause`.
  double work(const Tractions& force, const Tractions& cause, double shear_sign) const;

  const Grid& grid() const { return grid_; }
  std::size_t bytes() const;

 private:
  const ParityKernel& kernel(Traction kind, Axis axis) const;

  Grid grid_;
  SharedMedium medium_;
  SurfaceConvolution convolution_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<Traction, Axis>, ParityKernel> kernels_;  // spectra
};

}  // namespace samcontact::operators
