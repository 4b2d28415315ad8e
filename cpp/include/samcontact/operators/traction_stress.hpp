// SPDX-License-Identifier: GPL-3.0-or-later
// Stress at given depths due to pressure, the heat that goes with it, and shear on the surface:
// exact coefficients by DC-FFT.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/heat_stress.hpp"
#include "samcontact/operators/volume_spectrum.hpp"

namespace samcontact::operators {

/// Heat at rest is in the kernels of the pressure. That of a moving source has further parts, which
/// are odd in x where those are even (and the reverse), in y, in both.
enum class Traction { pressure, shear_x, shear_y, heat_x, heat_y, heat_xy };
constexpr int traction_kinds = 6;

/// One quarter spectrum per component, depth and kind of traction; the kernels of a kind are built
/// when it is first prepared.
class TractionStress {
 public:
  /// heat: that goes with the pressure; null: none.
  TractionStress(const Grid& grid, const VolumeTransform& transform, const Elastic& elastic,
                 std::shared_ptr<const HeatStress> heat, std::vector<double> depths, Tensor tensor);

  /// Builds the kernels of a kind of traction (with the pressure all of the heat); not thread-safe
  /// against add().
  void prepare(Traction kind);

  /// Kinds that a pressure acts by.
  std::vector<Traction> pressure_kinds() const;

  /// out += scale * stress of the traction whose spectrum is given. The kind must have been
  /// prepared. All layers of `out` then count as used.
  void add(Traction kind, const Field& traction, double scale, VolumeSpectrum& out) const;

  int layers() const { return static_cast<int>(depths_.size()); }
  std::size_t bytes() const;

 private:
  /// Kernel tables of heat at one depth, by component of tensor_.
  using HeatTables = std::vector<ParityParts>;
  HeatTables heat_tables(double z) const;
  /// heat: by depth, empty without.
  void build(Traction kind, const std::vector<HeatTables>& heat);

  Grid grid_;
  const VolumeTransform* transform_;
  Elastic elastic_;
  std::shared_ptr<const HeatStress> heat_;
  std::vector<double> depths_;
  Tensor tensor_;
  std::array<Field, traction_kinds> spectra_;  // [ky][component][layer][kx <= mx/2]
};

/// Stress [component][depth][i][j] of tractions [i][j] (a null pointer: none) at any depths.
Field traction_stress(const Grid& grid, const Elastic& elastic, const Heating& heating,
                      std::span<const double> depths, const double* pressure, const double* shear_x,
                      const double* shear_y);

}  // namespace samcontact::operators
