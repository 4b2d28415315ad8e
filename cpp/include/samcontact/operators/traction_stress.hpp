// SPDX-License-Identifier: GPL-3.0-or-later
// Stress at given depths due to pressure and shear on the surface, exact coefficients by DC-FFT.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/volume_spectrum.hpp"

namespace samcontact::operators {

enum class Traction { pressure = 0, shear_x = 1, shear_y = 2 };

/// One quarter spectrum per component, depth and kind of traction; the kernels of a kind are built
/// when it is first prepared.
class TractionStress {
 public:
  TractionStress(const Grid& grid, const VolumeTransform& transform, double nu,
                 std::vector<double> depths, Tensor tensor);

  /// Builds the kernels of a kind of traction; not thread-safe against add().
  void prepare(Traction kind);

  /// out += scale * stress of the traction whose spectrum is given. The kind must have been
  /// prepared. All layers of `out` then count as used.
  void add(Traction kind, const Field& traction, double scale, VolumeSpectrum& out) const;

  int layers() const { return static_cast<int>(depths_.size()); }
  std::size_t bytes() const;

 private:
  Grid grid_;
  const VolumeTransform* transform_;
  double nu_;
  std::vector<double> depths_;
  Tensor tensor_;
  std::array<Field, 3> spectra_;  // [ky][component][layer][kx <= mx/2]
};

/// Stress [component][depth][i][j] of tractions [i][j] (a null pointer: none) at any depths.
Field traction_stress(const Grid& grid, double nu, std::span<const double> depths,
                      const double* pressure, const double* shear_x, const double* shear_y);

}  // namespace samcontact::operators
