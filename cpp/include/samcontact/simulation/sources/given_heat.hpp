// SPDX-License-Identifier: GPL-3.0-or-later
// Heat in a body that is not proportional to the pressure of the increment: heat of earlier steps,
// and heat due to slip.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "samcontact/operators/heat/flux_heat.hpp"
#include "samcontact/simulation/setup/setup.hpp"

namespace samcontact::simulation {

class GivenHeat {
 public:
  /// past: heat history, evaluated `ahead` seconds after its end; null: no history. heating: used
  /// only for heat due to slip. slip_power: friction power per area [i][j] [W/m^2]; empty: zero.
  GivenHeat(const Setup& setup, int body, const std::shared_ptr<const operators::HeatHistory>& past,
            double ahead, const operators::Heating& heating, const Field& slip_power);

  bool is_on() const { return past_ || of_slip_; }
  // Fields as in HeatHistory, if there is any heat. offset: of the cells of the body, see
  // Placement.
  Field temperature(std::span<const double> depths, double offset) const;
  Field displacement() const;
  Field stress(std::span<const double> depths, double offset) const;

 private:
  Field power_at(double offset) const;
  /// Sum of the fields of both kinds of heat.
  template <class OfPast, class OfSlip>
  Field sum(const OfPast& of_past, const OfSlip& of_slip) const;

  const Grid& grid_;
  std::shared_ptr<const operators::HeatHistory> past_;
  double ahead_;
  std::shared_ptr<const operators::FluxHeat> of_slip_;
  const Field& slip_power_;
};

/// Given heat by body.
std::array<GivenHeat, 2> given_heat(const Setup& setup, const operators::HeatingPair& heating,
                                    const PastHeat& past, double ahead, const Field& slip_power);

/// Values in a box, of fields in layers below the grid [component][k][i][j]; cells laterally
/// outside the grid take the value of the nearest cell.
Field below_in(const Field& fields, int components, const Grid& grid, const Box& box);

}  // namespace samcontact::simulation
