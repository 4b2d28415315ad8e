// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/sources/given_heat.hpp"

#include <algorithm>

namespace samcontact::simulation {

GivenHeat::GivenHeat(const Setup& setup, int body,
                     const std::shared_ptr<const operators::HeatHistory>& past, double ahead,
                     const operators::Heating& heating, const Field& slip_power)
    : grid_(setup.grid),
      past_(past),
      ahead_(ahead),
      of_slip_(heating.is_of_slip() && !slip_power.empty() ? setup.cache.flux_heat(body, heating)
                                                           : nullptr),
      slip_power_(slip_power) {}

Field GivenHeat::power_at(double offset) const {
  return seen_from_body(slip_power_, grid_, offset);
}

template <class OfPast, class OfSlip>
Field GivenHeat::sum(const OfPast& of_past, const OfSlip& of_slip) const {
  if (!of_slip_) return of_past();
  Field field = of_slip();
  if (!past_) return field;
  const Field earlier = of_past();
  for (std::size_t n = 0; n < field.size(); ++n) field[n] += earlier[n];
  return field;
}

Field GivenHeat::temperature(std::span<const double> depths, double offset) const {
  return sum([&] { return past_->temperature(ahead_, depths); },
             [&] { return of_slip_->temperature(power_at(offset), depths); });
}

Field GivenHeat::displacement() const {
  return sum([&] { return past_->displacement(ahead_); },
             [&] { return of_slip_->displacement(slip_power_); });
}

Field GivenHeat::stress(std::span<const double> depths, double offset) const {
  return sum([&] { return past_->stress(ahead_, depths); },
             [&] { return of_slip_->stress(power_at(offset), depths); });
}

std::array<GivenHeat, 2> given_heat(const Setup& setup, const operators::HeatingPair& heating,
                                    const PastHeat& past, double ahead, const Field& slip_power) {
  const auto of = [&](int b) {
    return GivenHeat(setup, b, past[b], ahead, heating[b], slip_power);
  };
  return {of(0), of(1)};
}

Field below_in(const Field& fields, int components, const Grid& grid, const Box& box) {
  const std::size_t layers = fields.size() / (components * grid.surface_size());
  Field out(components * box.volume_size());
  double* to = out.data();
  for (int c = 0; c < components; ++c) {
    for (int k = 0; k < box.nz; ++k) {
      const double* layer = fields.data() + (c * layers + k) * grid.surface_size();
      for (int i = box.i0; i < box.i0 + box.nx; ++i) {
        const double* row =
            layer + static_cast<std::size_t>(std::clamp(i, 0, grid.nx - 1)) * grid.ny;
        for (int j = box.j0; j < box.j0 + box.ny; ++j) *to++ = row[std::clamp(j, 0, grid.ny - 1)];
      }
    }
  }
  return out;
}

}  // namespace samcontact::simulation
