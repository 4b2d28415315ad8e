// SPDX-License-Identifier: GPL-3.0-or-later
// Frictional heat, and influence coefficients of one heated cell.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/elastic.hpp"
#include "samcontact/base/thermal_stack.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/kernels/heat_source.hpp"
#include "samcontact/operators/influence/offsets.hpp"

namespace samcontact::operators {

/// Heat that enters one body: flux = factor p, or due to slip; stationary relative to the contact,
/// constant over `age`.
struct Heating {
  double factor = 0.0;  // heat flux per unit pressure Q_f [m/s]; due to slip: fraction of the
                        // friction power [-]
  ThermalStack thermal{{}, {1.0, 0.0, 1.0}};
  double speed_x = 0.0, speed_y = 0.0;  // of the body relative to the contact [m/s]
  double age = std::numeric_limits<double>::infinity();  // [s]; infinity: steady state
  /// Distance at which the displacement due to a steady stationary point source is zero [m].
  double reference = 1.0;

  bool of_slip = false;
  /// Periods of the surface along x and y [m], for a source of finite age that does not move along
  /// these directions; 0: not periodic.
  double period_x = 0.0, period_y = 0.0;

  /// Whether the heat is proportional to the pressure.
  bool is_on() const { return factor != 0 && !of_slip; }
  bool is_of_slip() const { return factor != 0 && of_slip; }
  /// Copy for a pressure that stands for the friction power.
  Heating of_power() const {
    Heating heating = *this;
    heating.of_slip = false;
    return heating;
  }
  /// Copy for a homogeneous body.
  Heating in(const Thermal& body) const {
    Heating heating = *this;
    heating.thermal = {{}, body};
    return heating;
  }
  bool is_moving() const { return speed_x != 0 || speed_y != 0; }
  /// Whether the source is steady and stationary: only then has the displacement no far-field
  /// limit.
  bool is_steady_at_rest() const { return !is_moving() && age == infinity(); }
  /// A source that is transient or moving needs tables instead of closed forms.
  static constexpr double infinity() { return std::numeric_limits<double>::infinity(); }

  bool operator==(const Heating&) const = default;
};

/// Heat of both bodies, the upper one first.
using HeatingPair = std::array<Heating, 2>;

/// Parts of a kernel by parity, compared with the parities of the field due to pressure: equal;
/// opposite in x; opposite in y; opposite in both. Each is a quarter [j][i] of offsets i dx >= 0, j
/// dy >= 0; empty parts are zero.
using ParityParts = std::array<Field, 4>;

/// One part of a kernel of stress, and its parity.
struct HeatPart {
  int component, flip;  // index among the six components, and among ParityParts
  kernels::Parity parity;
};
/// Parts that may be non-zero.
std::vector<HeatPart> heat_stress_parts(const Heating& heating);

// Coefficients of a homogeneous body, with the thermal constants of the substrate.

/// Normal surface displacement, positive into the body, per unit pressure [m/Pa] on a cell of dx x
/// dy.
ParityParts heat_displacement(const Heating& heating, double nu, double dx, double dy,
                              const Offsets& offsets);
/// Stress at a depth per unit pressure [-], components xx, yy, zz, yz, xz, xy.
std::array<ParityParts, 6> heat_stress(const Heating& heating, const Elastic& elastic, double dx,
                                       double dy, double z, const Offsets& offsets);
/// Temperature rise at a depth per unit pressure [K/Pa].
ParityParts heat_temperature(const Heating& heating, double dx, double dy, double z,
                             const Offsets& offsets);

}  // namespace samcontact::operators
