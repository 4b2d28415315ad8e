// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/strain/acting_strain.hpp"

#include <algorithm>

#include "samcontact/simulation/cells/tensor_fields.hpp"
#include "samcontact/simulation/cells/zone_choice.hpp"

namespace samcontact::simulation {
namespace {

PlasticState whole(const PlasticState& history, const Grid& grid) {
  const bool is_whole = history.symmetry() == fft::Symmetry::none;
  return is_whole ? history : history.unfolded(grid, fft::Symmetry::none);
}

}  // namespace

Box acting_box(const PlasticState& history, const Box& receiving, int reach) {
  // All strain of a period acts.
  if (history.lattice().period > 0) return receiving.united(history.box());
  const int step = std::max(8, (receiving.nx + 3) / 4);
  const auto beyond = [&](int cells) {
    return std::clamp((cells + step - 1) / step * step, 0, reach);
  };
  const Box& past = history.box();
  const int left = beyond(receiving.i0 - past.i0);
  const int right = beyond(past.i0 + past.nx - (receiving.i0 + receiving.nx));
  const Box long_box{receiving.i0 - left, past.j0, receiving.nx + left + right, past.ny, past.nz};
  return receiving.united(long_box);
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

Field stress_of(const PlasticState& history, const Setup& setup, int body,
                operators::ResidualMethod method, const Box& region) {
  const PlasticState all = whole(history, setup.grid);
  const Box around = acting_box(all, region, setup.reach);
  const auto operators =
      setup.cache.volume(body, around, operators::Tensor::full, method, fft::Symmetry::none, {});
  const Field strain = six_components(all.strain(around), all.tensor());
  return cut(operators->stress(strain.data(), nullptr, 1.0), around, region);
}

Field displacement_of(const PlasticState& history, const Setup& setup, int body,
                      operators::ResidualMethod method, operators::Axis axis, const Box& region) {
  const Box surface{region.i0, region.j0, region.nx, region.ny, 1};
  const PlasticState all = whole(history, setup.grid);
  const Box around = acting_box(all, surface, setup.reach);
  const auto operators =
      setup.cache.volume(body, around, all.tensor(), method, fft::Symmetry::none, {});
  operators::VolumeSpectrum spectrum = operators->make_spectrum();
  operators::forward(operators->transform(), all.strain(around).data(), spectrum);
  Field plane(around.surface_size()), out(surface.surface_size());
  operators->residual_displacement(axis).apply(spectrum, plane.data());
  Box layer = around;
  layer.nz = 1;
  extract(plane.data(), layer, out.data(), surface);
  return out;
}

Field displacement_of(const PlasticState& history, const Setup& setup, int body,
                      operators::ResidualMethod method, operators::Axis axis, double offset) {
  const Grid& grid = setup.grid;
  const int more = rows_beyond(grid, offset);
  Grid wide = grid;
  wide.nx += 2 * more;
  const Field own =
      displacement_of(history, setup, body, method, axis, {-more, 0, wide.nx, grid.ny, 0});
  const Field seen = seen_from_body(own, wide, -offset);
  const std::ptrdiff_t beyond = static_cast<std::ptrdiff_t>(more) * grid.ny;
  return {seen.begin() + beyond, seen.end() - beyond};
}

}  // namespace samcontact::simulation
