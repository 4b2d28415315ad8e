// SPDX-License-Identifier: GPL-3.0-or-later
// Temperature of the cells of a heated body in an increment.
#pragma once

#include <array>

#include "samcontact/simulation/cells/box_field.hpp"
#include "samcontact/simulation/increment/increment_task.hpp"
#include "samcontact/simulation/sources/given_heat.hpp"

namespace samcontact::simulation {

class ContactTemperature {
 public:
  explicit ContactTemperature(const IncrementTask& task);

  /// Whether a body is warmer than before all heating.
  bool is_on(int body) const;
  /// Temperature rise [K] of the cells of a box [k][i][j], which contains all of the pressure.
  /// pressure: on the cells of the body [i][j] of the grid.
  Field rise(int body, const Field& pressure, const Box& box);

 private:
  IncrementTask task_;
  std::array<GivenHeat, 2> given_;
  std::array<double, 2> offsets_;
  std::array<BoxField, 2> of_given_;  // rise due to given heat in the last box; empty: not known
};

}  // namespace samcontact::simulation
