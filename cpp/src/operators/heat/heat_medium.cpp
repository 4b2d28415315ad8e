// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/heat_medium.hpp"

namespace samcontact::operators {
namespace {

class HeatedHalfSpace : public HeatMedium {
 public:
  explicit HeatedHalfSpace(const Elastic& elastic) : elastic_(elastic) {}

  std::array<ParityParts, 6> stress(const Heating& heating, double dx, double dy, double z,
                                    const Offsets& offsets) const override {
    return heat_stress(heating, elastic_, dx, dy, z, offsets);
  }
  ParityParts displacement(const Heating& heating, double dx, double dy,
                           const Offsets& offsets) const override {
    return heat_displacement(heating, elastic_.nu, dx, dy, offsets);
  }
  HeatHistory history(const Grid& grid, const Heating& heating,
                      const HeatHistorySettings& settings) const override {
    return {grid, heating.thermal, elastic_, heating.speed_x, heating.speed_y, settings};
  }

 private:
  Elastic elastic_;
};

}  // namespace

SharedHeatMedium heated_half_space(const Elastic& elastic) {
  return std::make_shared<const HeatedHalfSpace>(elastic);
}

}  // namespace samcontact::operators
