// SPDX-License-Identifier: GPL-3.0-or-later
// Medium that provides coefficients only for some volume operators.
#pragma once

#include <stdexcept>

#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// Functions that are not overridden throw std::logic_error.
class VolumeMedium : public Medium {
 public:
  Field stress(Traction, const Grid&, const KernelOffsets&, double, Tensor) const override {
    fail();
  }
  Field stress(Traction, const Grid&, const CellOffsets&, double, Tensor) const override { fail(); }
  Field residual_displacement(Axis, const Grid&, const CellOffsets&, int) const override { fail(); }
  std::unique_ptr<ResidualDisplacement> residual_displacement(
      Axis, const Grid&, const VolumeTransform&, Tensor,
      const ResidualDisplacement*) const override {
    fail();
  }

  Field compliance(Traction, Axis, const Grid&, const CellOffsets&) const final { fail(); }
  double wave_compliance(double) const final { fail(); }

 private:
  [[noreturn]] static void fail() {
    throw std::logic_error("this medium has coefficients of some volume operators only");
  }
};

}  // namespace samcontact::operators
