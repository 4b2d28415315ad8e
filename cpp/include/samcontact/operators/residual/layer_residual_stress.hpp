// SPDX-License-Identifier: GPL-3.0-or-later
// Fast residual stress due to eigenstrain (plastic strain) in a box of layers of cells, by sweeps:
// for each wavenumber the Green operator of an infinite space is exp(-q |z - z'|) times a
// polynomial, so that one pass upwards and one downwards sum all layers of cells; the contributions
// of the surface, and of the interfaces of a layered body, are Fourier modes. Time and memory are
// proportional to the number of cells; no coefficients are stored.
//
// The eigenstrain is band-limited in the plane and constant in each layer; the stress is its mean
// over each layer. Near the highest wavenumber a mode and its alias are blended, so that the symbol
// has no jump and the stress decays correctly. The operator is symmetric and never feeds energy
// into a strain pattern. It is periodic: for a surface that is not, Images removes the images.
#pragma once

#include <memory>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/base/stack.hpp"
#include "samcontact/operators/residual/residual_stress.hpp"
#include "samcontact/operators/residual/swept_stack.hpp"

namespace samcontact::operators {

/// Stress due to the images that a periodic operator adds and the surface does not have, for a
/// `strain` [component][k][i][j] of the whole box.
class Images {
 public:
  virtual ~Images() = default;

  /// Opaque data for subtract().
  virtual Field stress(Tensor tensor, const double* strain) const = 0;
  /// Subtracts it from one layer of the stress, [component][i][j].
  virtual void subtract(Tensor tensor, const Field& images, int layer, double* stress) const = 0;
  virtual std::size_t bytes() const = 0;
};

class LayerResidualStress : public ResidualStress {
 public:
  /// settings: settings of the fast method. Throws
  /// std::invalid_argument if an interface of the body lies inside a layer of cells.
  LayerResidualStress(const Grid& grid, const VolumeTransform& transform, const Stack& body,
                      const ResidualSettings& settings);
  /// With all images of the period of the transform.
  LayerResidualStress(const Grid& grid, const VolumeTransform& transform, const Stack& body)
      : LayerResidualStress(grid, transform, body, Share{}, true) {}

  void apply(VolumeSpectrum& spectrum) const override;
  Field far_field(Tensor tensor, const double* strain) const override;
  void correct(Tensor tensor, const Field& far_field, int layer, double* stress) const override;

  std::size_t bytes() const override;

 private:
  /// One sweep over the wavenumbers first <= kx < last of a row, in whole blocks, or over their
  /// aliases.
  struct Pass {
    int first = 0, last = 0;
    Field modes;  // [coefficient][kx]
  };
  using Share = decltype(ResidualSettings::share);
  LayerResidualStress(const Grid& grid, const VolumeTransform& transform, const Stack& body,
                      const Share& share, bool blends);
  /// Sweeps of one row ky.
  std::vector<Pass> passes(const Grid& grid, const VolumeTransform& transform, int ky,
                           const Share& share, bool blends) const;
  Pass pass(const Grid& grid, const VolumeTransform& transform, int ky, bool alias_x, bool alias_y,
            const Share& share, bool blends) const;

  layers::SweptStack stack_;
  std::vector<std::vector<Pass>> passes_;  // for each ky, first its own wavenumbers
  std::shared_ptr<const Images> images_;   // null if the surface has all of them
};

}  // namespace samcontact::operators
