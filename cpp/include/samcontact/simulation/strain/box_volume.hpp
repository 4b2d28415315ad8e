// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of plastic strain in zones, and of tractions, by the operators of one box around all
// zones.
#pragma once

#include "samcontact/simulation/cells/zones.hpp"
#include "samcontact/simulation/scene/scene.hpp"
#include "samcontact/simulation/strain/zone_volume.hpp"

namespace samcontact::simulation {

/// All tractions must lie in the box around the zones.
class BoxVolume : public ZoneVolume {
 public:
  BoxVolume(const Scene& scene, int body, const Zones& zones, operators::Tensor tensor,
            operators::ResidualMethod method, fft::Symmetry symmetry,
            const operators::Heating& heating);

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
  OperatorCache::Operators operators_;
  operators::VolumeSpectrum spectrum_;
};

}  // namespace samcontact::simulation
