// SPDX-License-Identifier: GPL-3.0-or-later
// Spectral preconditioner of the normal contact: inverse of the periodic elastic operator, 1/K^ ~
// E* |q|/2, restricted to the cells of a working set. Heat is omitted: with heat K^ may be
// negative.
#pragma once

#include "samcontact/operators/surface/near_displacement.hpp"

namespace samcontact::contact {

/// On boxes with little padding. Without any padding a quarter more steps are needed if the contact
/// touches opposite edges.
class Preconditioner {
 public:
  /// near: approximate operator of the box; its spectrum is used if it is the required one.
  Preconditioner(const Grid& box, const operators::SurfaceInfluence& influence,
                 const operators::NearDisplacement& near);

  /// z = F^-1 (1/K^) F r; the caller restricts r and z to the working set. `work` is scratch.
  void apply(const double* r, double* z, ComplexField& work) const;

  double cost() const { return transform_.cost(); }

 private:
  fft::PeriodicTransform transform_;
  Field inverse_;  // real quarter spectrum [ky][kx]
};

/// Approximate operator and its preconditioner, of one box size.
struct NearOperators {
  operators::NearDisplacement displacement;
  Preconditioner preconditioner;

  NearOperators(const Grid& box, const operators::SurfaceInfluence& influence,
                const operators::SharedEndEffects& ends)
      : displacement(box, influence, ends), preconditioner(box, influence, displacement) {}
};

}  // namespace samcontact::contact
