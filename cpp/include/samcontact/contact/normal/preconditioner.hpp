// SPDX-License-Identifier: GPL-3.0-or-later
// The spectral preconditioner of contact: the inverse of the periodic elastic operator, 1/K^ ~ E*
// |q|/2, seen from the cells of a working set. Heat is left out: with it K^ may be negative.
#pragma once

#include "samcontact/operators/surface/near_displacement.hpp"

namespace samcontact::contact {

/// On boxes with little padding. None at all costs a quarter more steps where
/// contact touches opposite borders.
class Preconditioner {
 public:
  /// near: the cheap operator of the same box, whose spectrum is taken where it is the one wanted.
  Preconditioner(const Grid& box, const operators::SurfaceInfluence& influence,
                 const operators::NearDisplacement& near);

  /// z = F^-1 (1/K^) F r; the caller restricts r and z to the working set. `work` is scratch.
  void apply(const double* r, double* z, ComplexField& work) const;

  double cost() const { return transform_.cost(); }

 private:
  fft::PeriodicTransform transform_;
  Field inverse_;  // real quarter spectrum [ky][kx]
};

/// A cheap operator and its preconditioner, both of one box size.
struct NearOperators {
  operators::NearDisplacement displacement;
  Preconditioner preconditioner;

  NearOperators(const Grid& box, const operators::SurfaceInfluence& influence)
      : displacement(box, influence), preconditioner(box, influence, displacement) {}
};

}  // namespace samcontact::contact
