// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/strain/acting_strain.hpp"

#include <algorithm>

#include "samcontact/simulation/cells/tensor_fields.hpp"
#include "samcontact/simulation/cells/zone_choice.hpp"

namespace samcontact::simulation {

Box acting_box(const PlasticState& history, const Box& wanted, int reach) {
  const int step = std::max(8, (wanted.nx + 3) / 4);
  const auto beyond = [&](int cells) {
    return std::clamp((cells + step - 1) / step * step, 0, reach);
  };
  const Box& past = history.box();
  const int left = beyond(wanted.i0 - past.i0);
  const int right = beyond(past.i0 + past.nx - (wanted.i0 + wanted.nx));
  const Box long_box{wanted.i0 - left, past.j0, wanted.nx + left + right, past.ny, past.nz};
  return wanted.united(long_box);
}

Zones acting_zones(const PlasticState& history, const Zones& zones,
                   const operators::ZoneTables& tables, int reach) {
  const Grid& grid = tables.grid();
  std::vector<Box> boxes = zones.boxes();
  for (const Box& box : history.boxes_beyond(zones)) {
    const Box acting = box.intersected({-reach, box.j0, grid.nx + 2 * reach, box.ny, box.nz});
    if (!acting.empty()) boxes.push_back(acting);
  }
  return boxes.size() == zones.count() ? zones : Zones(merged(boxes, tables.split()));
}

Field stress_of(const PlasticState& history, const Scene& scene, int body,
                operators::ResidualMethod method, const Box& region) {
  const PlasticState all = history.symmetry() == fft::Symmetry::none
                               ? history
                               : history.unfolded(scene.grid, fft::Symmetry::none);
  const Box around = acting_box(all, region, scene.reach);
  const auto operators =
      scene.cache.volume(body, around, operators::Tensor::full, method, fft::Symmetry::none, {});
  const Field strain = six_components(all.strain(around), all.tensor());
  return cut(operators->stress(strain.data(), nullptr, 1.0), around, region);
}

}  // namespace samcontact::simulation
