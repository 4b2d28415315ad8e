// SPDX-License-Identifier: GPL-3.0-or-later
// Rise of temperature in a body that frictional heat enters.
#pragma once

#include <span>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/heating.hpp"
#include "samcontact/operators/surface_convolution.hpp"

namespace samcontact::operators {

/// At given depths under any pressure; keeps its kernels.
class Temperature {
 public:
  Temperature(const Grid& grid, const Heating& heating, std::span<const double> depths);

  /// Rise [depth][i][j] [K] under a pressure [i][j] [Pa].
  Field rise(const double* pressure) const;
  std::size_t bytes() const;

 private:
  std::size_t plane_;
  SurfaceConvolution convolution_;
  std::vector<std::vector<ParityKernel>> kernels_;  // by depth; none without heat
};

}  // namespace samcontact::operators
