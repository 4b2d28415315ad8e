// SPDX-License-Identifier: GPL-3.0-or-later
// Temperature, displacement and stress of a body due to any heat flux into it.
#pragma once

#include <mutex>
#include <span>
#include <vector>

#include "samcontact/operators/heat/heat_stress.hpp"
#include "samcontact/operators/heat/temperature.hpp"

namespace samcontact::operators {

/// Fields [i][j] over a grid due to a flux on it, times the factor of a heating. The kernels are
/// kept after use. Thread-safe.
class FluxHeat {
 public:
  FluxHeat(const Grid& grid, SharedHeatMedium body, const Heating& heating);

  const Heating& heating() const { return temperature_.heating(); }
  /// Temperature rise [depth][i][j] [K] due to a flux [i][j] [W/m^2].
  Field temperature(const Field& flux, std::span<const double> depths) const {
    return temperature_.rise(flux.data(), depths);
  }
  /// u_z of the surface [i][j] [m], positive into the body.
  Field displacement(const Field& flux) const;
  /// [component][depth][i][j] [Pa], components xx, yy, zz, yz, xz, xy.
  Field stress(const Field& flux, std::span<const double> depths) const;

 private:
  Grid grid_;
  SharedHeatMedium body_;
  Temperature temperature_;
  HeatStress stress_;
  SurfaceConvolution convolution_;
  mutable std::mutex mutex_;
  mutable std::vector<ParityKernel> displacement_;  // built on first use
};

}  // namespace samcontact::operators
