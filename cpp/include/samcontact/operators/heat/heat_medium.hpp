// SPDX-License-Identifier: GPL-3.0-or-later
// Thermal coefficients of a body. They are separate from the medium of elastic fields, so that a
// body without thermal kernels has none of these functions.
#pragma once

#include <array>
#include <memory>

#include "samcontact/base/stack.hpp"
#include "samcontact/operators/heat/heat_history.hpp"
#include "samcontact/operators/heat/heating.hpp"

namespace samcontact::operators {

/// Thermal stress due to a unit pressure on one cell of dx x dy, see heating.hpp. Immutable and
/// thread-safe.
class ThermalStress {
 public:
  virtual ~ThermalStress() = default;
  /// Stress at a depth z >= 0 [m], components xx, yy, zz, yz, xz, xy [-].
  virtual std::array<ParityParts, 6> stress(const Heating& heating, double dx, double dy, double z,
                                            const Offsets& offsets) const = 0;
  /// Whether stress() takes no longer than a copy of its tables.
  virtual bool is_fast(const Heating& heating) const = 0;

 protected:
  ThermalStress() = default;
  ThermalStress(const ThermalStress&) = default;
  ThermalStress& operator=(const ThermalStress&) = default;
};
using SharedThermalStress = std::shared_ptr<const ThermalStress>;

/// All thermal coefficients of one body.
class HeatMedium : public ThermalStress {
 public:
  /// Normal surface displacement, positive into the body, per unit pressure on a cell [m/Pa].
  virtual ParityParts displacement(const Heating& heating, double dx, double dy,
                                   const Offsets& offsets) const = 0;
  /// Empty history of the heat described by `heating`.
  virtual HeatHistory history(const Grid& grid, const Heating& heating,
                              const HeatHistorySettings& settings) const = 0;
};
using SharedHeatMedium = std::shared_ptr<const HeatMedium>;

/// Body of the given elastic structure; a Heating contains the thermal structure.
SharedHeatMedium heated_body(const Stack& elastic);

}  // namespace samcontact::operators
