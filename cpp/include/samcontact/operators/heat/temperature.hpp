// SPDX-License-Identifier: GPL-3.0-or-later
// Temperature rise in a body due to frictional heat.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/heat/heating.hpp"

namespace samcontact::operators {

/// For any pressure on a grid; the kernels of all depths are kept after use. Thread-safe.
class Temperature {
 public:
  Temperature(const Grid& grid, Heating heating);

  const Grid& grid() const { return grid_; }
  const Heating& heating() const { return heating_; }
  /// Temperature rise [depth][i][j] [K] due to a pressure [i][j] [Pa].
  Field rise(const double* pressure, std::span<const double> depths) const;
  std::size_t bytes() const;

 private:
  using Kernels = std::vector<ParityKernel>;
  std::shared_ptr<const Kernels> kernels(double depth) const;

  Grid grid_;
  Heating heating_;
  SurfaceConvolution convolution_;
  mutable std::mutex mutex_;
  mutable std::map<double, std::shared_ptr<const Kernels>> kept_;
};

}  // namespace samcontact::operators
