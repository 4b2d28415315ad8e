// SPDX-License-Identifier: GPL-3.0-or-later
// Residual stress of eigenstrain (plastic strain) in layers on a substrate: per wavenumber the
// field of an infinite space of each layer's own constants, and the waves that its interfaces send
// back (docs/theory.md, "Layers"). Time and memory are proportional to the number of cells.
#pragma once

#include <memory>
#include <vector>

#include "samcontact/base/stack.hpp"
#include "samcontact/operators/layer_residual_stress.hpp"

namespace samcontact::operators {

/// As LayerResidualStress is, of which it is the case without layers. Images are those of the
/// substrate, or of the lowest layer on a rigid one: they lie far from the coating.
class StackResidualStress : public ResidualStress {
 public:
  /// The grid's layers start at the surface. Throws std::invalid_argument where an interface lies
  /// inside one of them.
  StackResidualStress(const Grid& grid, const VolumeTransform& transform, const Stack& stack,
                      const ResidualSettings& settings);

  void apply(VolumeSpectrum& spectrum) const override;
  Field far_field(Tensor tensor, const double* strain) const override;
  void correct(Tensor tensor, const Field& far_field, int layer, double* stress) const override;

  std::size_t bytes() const override { return images_ ? images_->bytes() : 0; }

 private:
  Grid grid_;
  const VolumeTransform* transform_;
  Stack stack_;
  decltype(ResidualSettings::share) share_;
  std::vector<int> layer_of_;             // of each layer of cells
  std::shared_ptr<const Images> images_;  // null where the surface has all of them
};

}  // namespace samcontact::operators
