// SPDX-License-Identifier: GPL-3.0-or-later
// Influence of pressure on one cell, with the proportional shear and heat, on the gap: the
// coefficients of all contact operators, on any grid.
#pragma once

#include <memory>
#include <vector>

#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/medium/medium.hpp"
#include "samcontact/operators/surface/end_effects.hpp"

namespace samcontact::operators {

/// Sum over the bodies in contact.
class SurfaceInfluence {
 public:
  /// Adds a body. shear_x: shear on it over the pressure [-]. Throws std::invalid_argument for
  /// shear or heat on a body with free faces.
  void add(const SharedMedium& medium, double shear_x = 0.0, const Heating& heating = {});

  /// The same influence with the effect of heat tabulated for the offsets of a grid: other members
  /// then read it from the table, for all offsets that the table contains.
  SurfaceInfluence tabulated(const Grid& grid, const KernelOffsets& offsets) const;

  /// Part that is even in x and y, [j][i] [m/Pa].
  Field even(const Grid& grid, const CellOffsets& offsets) const;
  /// Elastic part of the even part, which is positive definite [m/Pa].
  Field elastic(const Grid& grid, const CellOffsets& offsets) const;
  /// u_z over the pressure of a Fourier mode [m/Pa], elastic and even; wavenumber > 0 [1/m].
  double wave_compliance(double wavenumber) const;

  /// Effect of the free faces of the bodies, in addition to even(); null: no faces.
  SharedEndEffects ends(const Grid& grid) const;

  /// Parts that are not even.
  std::vector<ParityKernel> rest(const Grid& grid, const KernelOffsets& offsets) const;
  /// Whether a body is heated: the operator may then be indefinite.
  bool is_heated() const;

 private:
  struct Body {
    SharedMedium medium;
    double shear_x;
    Heating heating;
  };
  /// Effect of heat of all bodies at consecutive offsets, by parity, [j][i] [m/Pa].
  struct HeatTable {
    double dx = 0.0, dy = 0.0;
    int nx = 0, ny = 0;
    ParityParts parts;
    bool contains(const Grid& grid, const CellOffsets& offsets) const;
  };
  ParityParts heat(const Grid& grid, const Offsets& offsets) const;
  /// u_z due to a traction, summed over all bodies with their weights; empty: zero.
  template <class Weight>
  Field sum(Traction traction, const Grid& grid, const CellOffsets& offsets,
            const Weight& weight) const;

  std::vector<Body> bodies_;  // those that are not rigid
  std::shared_ptr<const HeatTable> heat_;
};

}  // namespace samcontact::operators
