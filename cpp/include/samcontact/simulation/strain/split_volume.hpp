// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of plastic strain in zones, and of tractions, by operators whose cost is proportional to
// the zones.
#pragma once

#include <memory>

#include "samcontact/operators/zones/zone_operators.hpp"
#include "samcontact/simulation/cells/zones.hpp"
#include "samcontact/simulation/strain/zone_volume.hpp"

namespace samcontact::simulation {

/// Without mirror planes; the displacement is known on the whole grid.
class SplitVolume : public ZoneVolume {
 public:
  SplitVolume(std::shared_ptr<const operators::ZoneTables> tables, const Zones& zones)
      : surface_(Box::surface(tables->grid())), operators_(std::move(tables), zones.boxes()) {}

  void transform(const Field& strain, std::span<const operators::Axis> axes) override {
    operators_.transform(strain, axes);
  }
  const Box& surface() const override { return surface_; }
  void displacement(operators::Axis axis, double* out) const override {
    operators_.displacement(axis, out);
  }
  void for_each_layer(bool strained, const Field& strain, const operators::Tractions& tractions,
                      double sign, const Use& use) override {
    operators_.for_each_layer(strained ? &strain : nullptr, tractions, sign, use);
  }

 private:
  Box surface_;
  operators::ZoneOperators operators_;
};

}  // namespace samcontact::simulation
