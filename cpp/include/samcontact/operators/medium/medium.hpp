// SPDX-License-Identifier: GPL-3.0-or-later
// Half-space model of a body: the interface for all influence coefficients that depend on its
// elastic constants. Operators request coefficients from a medium and never use elastic constants,
// so that another kind of body is one more class.
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
  /// Whether all coefficients are equal.
  virtual bool operator==(const Medium& other) const = 0;

  /// Surface displacement along `axis` at offsets from a cell of the grid due to a unit traction,
  /// [j][i] [m/Pa]. Its parity is given by compliance_parity().
  virtual Field compliance(Traction traction, Axis axis, const Grid& grid,
                           const CellOffsets& offsets) const = 0;
  /// u_z over the pressure of a Fourier mode [m/Pa], wavenumber > 0 [1/m].
  virtual double wave_compliance(double wavenumber) const = 0;

  /// Stress at a depth z >= 0 [m], 0 in rigid material, due to a unit traction on one cell of the
  /// grid, [component of tensor][j][i] [-].
  virtual Field stress(Traction traction, const Grid& grid, const KernelOffsets& offsets, double z,
                       Tensor tensor) const = 0;

  /// Number of layers of a grid in which tractions cause stress; 0 below.
  virtual int stressed_layers(const Grid& grid) const { return grid.nz; }
  /// Stress at any offsets, on a grid that is not periodic.
  virtual Field stress(Traction traction, const Grid& grid, const CellOffsets& offsets, double z,
                       Tensor tensor) const = 0;
  /// Surface displacement along an axis due to a unit eigenstrain in a cell of a layer, [component
  /// of all six][j][i] [m], on a grid that is not periodic.
  virtual Field residual_displacement(Axis axis, const Grid& grid, const CellOffsets& offsets,
                                      int layer) const = 0;

  /// Stress influence of one cell, with the additional data of its lattice sums. Throws
  /// std::logic_error if it is not available.
  virtual CellInfluence stress_influence(Traction traction, const Grid& cell, double z) const;
  virtual CellInfluence residual_influence(Axis axis, const Grid& cell, int layer) const;

  /// Residual-stress operator of the layers of a grid. The exact method needs layers from the
  /// surface on.
  virtual std::unique_ptr<ResidualStress> residual_stress(
      const Grid& grid, const VolumeTransform& transform,
      const ResidualSettings& settings) const = 0;
  /// shallower: operator of fewer layers from which kernels are copied; null: no such operator.
  virtual std::unique_ptr<ResidualDisplacement> residual_displacement(
      Axis axis, const Grid& grid, const VolumeTransform& transform, Tensor tensor,
      const ResidualDisplacement* shallower) const = 0;

  /// Thermal coefficients of the body; null: not available.
  virtual SharedHeatMedium heat() const { return nullptr; }

  /// Ratio of u_z due to a traction to u_z of another medium, if this ratio is equal at all
  /// offsets; one table then serves both media.
  virtual std::optional<double> normal_ratio(Traction traction, const Medium& other) const;

 protected:
  Medium() = default;
  Medium(const Medium&) = default;
  Medium& operator=(const Medium&) = default;
};

/// Bodies of one simulation with equal media share one object, which is the key of caches.
using SharedMedium = std::shared_ptr<const Medium>;

/// Throws std::logic_error if thermal coefficients are not available.
SharedHeatMedium heat_of(const Medium& medium);

}  // namespace samcontact::operators
