// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/heat_medium.hpp"

#include <utility>

#include "samcontact/operators/heat/layered_heat.hpp"

namespace samcontact::operators {
namespace {

class HeatedBody : public HeatMedium {
 public:
  explicit HeatedBody(Stack elastic) : elastic_(std::move(elastic)) {}

  std::array<ParityParts, 6> stress(const Heating& heating, double dx, double dy, double z,
                                    const Offsets& offsets) const override {
    return layered_heat_stress(elastic_, heating, dx, dy, z, offsets);
  }
  bool is_fast(const Heating& heating) const override {
    return heating.is_steady_at_rest() && HeatedStack::of(elastic_, heating.thermal).is_uniform();
  }
  ParityParts displacement(const Heating& heating, double dx, double dy,
                           const Offsets& offsets) const override {
    return layered_heat_displacement(elastic_, heating, dx, dy, offsets);
  }
  HeatHistory history(const Grid& grid, const Heating& heating,
                      const HeatHistorySettings& settings) const override {
    return {grid, elastic_, heating, settings};
  }

 private:
  Stack elastic_;
};

}  // namespace

SharedHeatMedium heated_body(const Stack& elastic) {
  return std::make_shared<const HeatedBody>(elastic);
}

}  // namespace samcontact::operators
