// SPDX-License-Identifier: GPL-3.0-or-later
// Residual stress of a lattice of nodes, with the images of the cells that the nodes represent.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "samcontact/operators/residual/residual_stress.hpp"

namespace samcontact::operators {

/// Images multiplied by `scale`.
class ScaledImages : public ResidualStress {
 public:
  ScaledImages(std::unique_ptr<ResidualStress> whole, double scale)
      : whole_(std::move(whole)), scale_(scale) {}

  void apply(VolumeSpectrum& spectrum) const override { whole_->apply(spectrum); }
  Field far_field(Tensor tensor, const double* strain) const override {
    Field images = whole_->far_field(tensor, strain);
    for (double& value : images) value *= scale_;
    return images;
  }
  void correct(Tensor tensor, const Field& far_field, int layer, double* stress) const override {
    whole_->correct(tensor, far_field, layer, stress);
  }
  std::size_t bytes() const override { return whole_->bytes(); }

 private:
  std::unique_ptr<ResidualStress> whole_;
  double scale_;
};

}  // namespace samcontact::operators
