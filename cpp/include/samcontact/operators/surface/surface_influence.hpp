// SPDX-License-Identifier: GPL-3.0-or-later
// What pressure on one cell, with the shear and heat that it brings, does to the gap around it: the
// coefficients behind all contact operators, on any grid.
#pragma once

#include <vector>

#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// The sum over the bodies that touch.
class SurfaceInfluence {
 public:
  /// Adds a body. shear_x: on it, over the pressure [-].
  void add(const SharedMedium& medium, double shear_x = 0.0, const Heating& heating = {});

  /// The part that is even in x and y, [j][i] [m/Pa].
  Field even(const Grid& grid, const CellOffsets& offsets) const;
  /// The elastic part of it, which is positive definite.
  Field elastic(const Grid& grid, const CellOffsets& offsets) const;
  /// u_z over the pressure of a wave [m/Pa], elastic and even; wavenumber > 0 [1/m].
  double wave_compliance(double wavenumber) const;

  /// All that is not even.
  std::vector<ParityKernel> rest(const Grid& grid, const KernelOffsets& offsets) const;
  /// Whether heat enters a body: the operator may then be indefinite.
  bool is_heated() const;

 private:
  struct Body {
    SharedMedium medium;
    double shear_x;
    Heating heating;
  };
  /// u_z of a traction on all bodies, that on a body times its weight; empty: zero.
  template <class Weight>
  Field sum(Traction traction, const Grid& grid, const CellOffsets& offsets,
            const Weight& weight) const;

  std::vector<Body> bodies_;  // those that are not rigid
};

}  // namespace samcontact::operators
