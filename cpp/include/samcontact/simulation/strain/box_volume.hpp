// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of plastic strain in zones, and of tractions, by the operators of one box around all
// zones.
#pragma once

#include "samcontact/simulation/cells/zones.hpp"
#include "samcontact/simulation/setup/setup.hpp"
#include "samcontact/simulation/strain/zone_volume.hpp"

namespace samcontact::simulation {

/// Smallest box around the cells of a box with any non-zero component, [component][k][i][j], over
/// all its layers; empty if there are none.
Box nonzero_part(const Field& field, const Box& box);

/// All tractions must lie in the box around the zones.
class BoxVolume : public ZoneVolume {
 public:
  /// needed: part of the box around the zones that may be strained and whose stress is needed; the
  /// stress elsewhere has no meaning.
  BoxVolume(const Setup& setup, int body, const Zones& zones, operators::Tensor tensor,
            operators::ResidualMethod method, fft::Symmetry symmetry,
            const operators::Heating& heating, const Box& needed);

  void transform(const Field& strain, std::span<const operators::Axis> axes) override;
  const Box& surface() const override { return surface_; }
  void displacement(operators::Axis axis, double* out) const override;
  void for_each_layer(bool strained, const Field& strain, const operators::Tractions& tractions,
                      double sign, const Use& use) override;

 private:
  bool is_one() const { return zones_.count() == 1 && zones_.boxes()[0] == box_; }
  /// Strain of the zones on all cells of the box.
  Field spread(const Field& strain) const;

  const Grid& grid_;
  Zones zones_;
  operators::Tensor tensor_;
  Box box_, surface_;
  fft::RowRun rows_;  // of the box, with needed stress
  int first_;         // layer of the box with needed stress
  OperatorCache::Operators operators_;
  operators::VolumeSpectrum spectrum_;
};

}  // namespace samcontact::simulation
