// SPDX-License-Identifier: GPL-3.0-or-later
// Frictional heat that pressure makes, and the influence of one heated cell on the cells around it.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/elastic.hpp"
#include "samcontact/base/thermal.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/kernels/heat_source.hpp"
#include "samcontact/operators/influence/offsets.hpp"

namespace samcontact::operators {

/// Heat that enters one body: flux = factor p, or of slip, fixed to the contact, as it is for
/// `age`.
struct Heating {
  double factor = 0.0;  // Q_f [m/s]; of slip: the share of the power of friction
  Thermal thermal{1.0, 0.0, 1.0};
  double speed_x = 0.0, speed_y = 0.0;                   // of the body through the contact [m/s]
  double age = std::numeric_limits<double>::infinity();  // [s]; infinity: steady state
  /// Distance at which a steady point source at rest displaces nothing [m].
  double reference = 1.0;

  bool of_slip = false;

  /// Whether it goes with the pressure.
  bool is_on() const { return factor != 0 && !of_slip; }
  bool is_of_slip() const { return factor != 0 && of_slip; }
  /// The same under a pressure that stands for the power of friction.
  Heating of_power() const {
    Heating heating = *this;
    heating.of_slip = false;
    return heating;
  }
  bool is_moving() const { return speed_x != 0 || speed_y != 0; }
  /// Only then is there no limit of the displacement far away.
  bool is_steady_at_rest() const { return !is_moving() && age == infinity(); }
  /// A source that is neither steady nor at rest needs tables instead of closed forms.
  static constexpr double infinity() { return std::numeric_limits<double>::infinity(); }

  bool operator==(const Heating&) const = default;
};

/// Of both bodies, the upper one first.
using HeatingPair = std::array<Heating, 2>;

/// A kernel in the parts that its parities leave, relative to those of the field under pressure: as
/// it is, odd in x where that is even (and the reverse), in y, in both. Each is a quarter [j][i] of
/// offsets i dx >= 0, j dy >= 0; empty where there is none.
using ParityParts = std::array<Field, 4>;

/// One part of a kernel of stress, and its parity.
struct HeatPart {
  int component, flip;  // place in the six components, and among ParityParts
  kernels::Parity parity;
};
/// Those that there may be.
std::vector<HeatPart> heat_stress_parts(const Heating& heating);

/// Normal displacement of the surface, positive into the body, per unit pressure [m/Pa] on a cell
/// of dx x dy.
ParityParts heat_displacement(const Heating& heating, double nu, double dx, double dy,
                              const Offsets& offsets);
/// Stress per unit pressure at a depth [-], components xx, yy, zz, yz, xz, xy.
std::array<ParityParts, 6> heat_stress(const Heating& heating, const Elastic& elastic, double dx,
                                       double dy, double z, const Offsets& offsets);
/// Rise of temperature at a depth per unit pressure [K/Pa].
ParityParts heat_temperature(const Heating& heating, double dx, double dy, double z,
                             const Offsets& offsets);

}  // namespace samcontact::operators
