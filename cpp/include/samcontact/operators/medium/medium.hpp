// SPDX-License-Identifier: GPL-3.0-or-later
// What a body is to the operators: everything that its elastic constants decide. Operators ask a
// medium for coefficients and never for constants, so that a body of another make is one more
// class.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/heat/heat_medium.hpp"
#include "samcontact/operators/influence/tractions.hpp"
#include "samcontact/operators/periodic/cell_influence.hpp"
#include "samcontact/operators/residual/residual_displacement.hpp"
#include "samcontact/operators/residual/residual_stress.hpp"

namespace samcontact::operators {

/// Immutable and thread-safe. Frame: z into the body, x and y in its surface.
class Medium {
 public:
  virtual ~Medium() = default;

  virtual bool is_rigid() const = 0;
  /// Whether all coefficients are the same.
  virtual bool operator==(const Medium& other) const = 0;

  /// Displacement of the surface along `axis` at offsets from a cell of the grid under a unit
  /// traction, [j][i] [m/Pa]. Its parity is that of compliance_parity().
  virtual Field compliance(Traction traction, Axis axis, const Grid& grid,
                           const CellOffsets& offsets) const = 0;
  /// u_z over the pressure of a wave [m/Pa], wavenumber > 0 [1/m].
  virtual double wave_compliance(double wavenumber) const = 0;

  /// Stress at a depth z >= 0 [m], 0 in what is rigid, under a unit traction on one cell of the
  /// grid, [component of tensor][j][i] [-].
  virtual Field stress(Traction traction, const Grid& grid, const KernelOffsets& offsets, double z,
                       Tensor tensor) const = 0;

  /// Layers of a grid in which tractions stress the body; 0 below.
  virtual int stressed_layers(const Grid& grid) const { return grid.nz; }
  /// The same at any offsets, of a grid without period.
  virtual Field stress(Traction traction, const Grid& grid, const CellOffsets& offsets, double z,
                       Tensor tensor) const = 0;
  /// Displacement of the surface along an axis under a unit eigenstrain in a cell of a layer,
  /// [component of all six][j][i] [m], of a grid without period.
  virtual Field residual_displacement(Axis axis, const Grid& grid, const CellOffsets& offsets,
                                      int layer) const = 0;

  /// The same of one cell, and all that its sums over a lattice need. Throws std::logic_error where
  /// it is not known.
  virtual CellInfluence stress_influence(Traction traction, const Grid& cell, double z) const;
  virtual CellInfluence residual_influence(Axis axis, const Grid& cell, int layer) const;

  /// Operators of eigenstrain in the layers of a grid, the first of which starts at the surface.
  virtual std::unique_ptr<ResidualStress> residual_stress(
      const Grid& grid, const VolumeTransform& transform,
      const ResidualSettings& settings) const = 0;
  /// shallower: that of fewer layers, which are taken from it; null: none.
  virtual std::unique_ptr<ResidualDisplacement> residual_displacement(
      Axis axis, const Grid& grid, const VolumeTransform& transform, Tensor tensor,
      const ResidualDisplacement* shallower) const = 0;

  /// The coefficients of heat of the same body; null: they are not known.
  virtual SharedHeatMedium heat() const { return nullptr; }

  /// u_z under a traction over that of another medium, where it is the same at all offsets; one
  /// table then serves both.
  virtual std::optional<double> normal_ratio(Traction traction, const Medium& other) const;

 protected:
  Medium() = default;
  Medium(const Medium&) = default;
  Medium& operator=(const Medium&) = default;
};

/// Bodies of one scene whose media are equal share one object: it is the key of what is kept.
using SharedMedium = std::shared_ptr<const Medium>;

/// Throws std::invalid_argument where the coefficients of heat are not known.
SharedHeatMedium heat_of(const Medium& medium);

}  // namespace samcontact::operators
