// SPDX-License-Identifier: GPL-3.0-or-later
// Rise of temperature in a body that frictional heat enters.
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

/// Under any pressure on a grid; keeps the kernels of the depths it was asked for. Thread-safe.
class Temperature {
 public:
  Temperature(const Grid& grid, const Heating& heating);

  const Grid& grid() const { return grid_; }
  const Heating& heating() const { return heating_; }
  /// Rise [depth][i][j] [K] under a pressure [i][j] [Pa].
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
