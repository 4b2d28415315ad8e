// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/contact_temperature.hpp"

#include "samcontact/simulation/cells/traction_window.hpp"

namespace samcontact::simulation {

ContactTemperature::ContactTemperature(const IncrementTask& task)
    : task_(task),
      given_(given_heat(task.setup(), task.target.heating, task.target.past, task.target.duration,
                        task.target.slip_power)),
      offsets_(task.from.placement().offset) {}

bool ContactTemperature::is_on(int body) const {
  return task_.target.heating[body].factor != 0 || given_[body].is_on();
}

Field ContactTemperature::rise(int body, const Field& pressure, const Box& box) {
  const Grid& grid = task_.setup().grid;
  const auto depths = grid.z(box.nz);
  const auto operators = task_.setup().cache.temperature(task_.target.heating[body], box);
  Field rise = operators->rise(window({pressure, {}, {}}, grid, box).pressure.data(), depths);
  if (!given_[body].is_on()) return rise;
  BoxField& more = of_given_[body];
  if (more.values.empty() || more.box != box) {
    more = {box, below_in(given_[body].temperature(depths, offsets_[body]), 1, grid, box)};
  }
  for (std::size_t n = 0; n < rise.size(); ++n) rise[n] += more.values[n];
  return rise;
}

}  // namespace samcontact::simulation
