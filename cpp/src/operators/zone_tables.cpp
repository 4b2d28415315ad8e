// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zone_tables.hpp"

#include <algorithm>
#include <utility>

#include "samcontact/fft/plan.hpp"

namespace samcontact::operators {
namespace {

/// Tables have so many layers, times a whole number: they outlast zones that grow.
constexpr int layers_at_once = 8;

}  // namespace

Tractions spread(const Tractions& cells, const Box& box, int pitch, const NodeSpread& nodes,
                 const Grid& lattice) {
  const auto spread_one = [&](const Field& from) {
    Field to;
    if (from.empty()) return to;
    to.assign(lattice.surface_size(), 0.0);
    nodes.spread(from.data(), pitch, box, to.data(), lattice.ny);
    return to;
  };
  return {spread_one(cells.pressure), spread_one(cells.shear_x), spread_one(cells.shear_y)};
}

Box with_ring(const Box& zone, const std::vector<Box>& zones, const BandSplit& split) {
  const int ring = split.near_range, more = std::max(0, split.wide_ring - ring);
  const Box box{zone.i0 - ring, zone.j0 - ring, zone.nx + 2 * ring, zone.ny + 2 * ring, zone.nz};
  Box wide = box;
  for (const Box& other : zones) {
    if (other == zone || box.intersected(other).empty()) continue;
    if (other.i0 < zone.i0) wide = wide.united({box.i0 - more, box.j0, 1, 1, 1});
    if (other.j0 < zone.j0) wide = wide.united({box.i0, box.j0 - more, 1, 1, 1});
    if (other.i0 + other.nx > zone.i0 + zone.nx)
      wide = wide.united({box.i0 + box.nx + more - 1, box.j0, 1, 1, 1});
    if (other.j0 + other.ny > zone.j0 + zone.ny)
      wide = wide.united({box.i0, box.j0 + box.ny + more - 1, 1, 1, 1});
  }
  return wide;
}

ZoneTables::ZoneTables(const Grid& grid, const SharedMedium& medium, Tensor tensor,
                       double image_tol, const BandSplit& split, const Heating& heating)
    : grid_(grid),
      tensor_(tensor),
      image_tol_(image_tol),
      split_((require_valid(split), split)),
      media_(bands_of(medium, grid, split)) {
  if (!heating.is_on()) return;
  for (std::size_t band = 0; band < media_.size(); ++band) {
    heat_[band] = std::make_shared<const HeatStress>(media_[band], heating);
  }
}

NodeSpread ZoneTables::middle_nodes(const Box& cells) const {
  return {split_.middle_spacing, split_.window_width, cells};
}

NodeSpread ZoneTables::far_nodes(const NodeSpread& middle) const {
  return {split_.far_spacing / split_.middle_spacing, split_.window_width, middle.box()};
}

Grid ZoneTables::lattice(Band band, const NodeSpread& nodes, int layers) const {
  const int step = split_.spacing(band), nx = nodes.x().count(), ny = nodes.y().count();
  if (band == Band::far) {
    const auto cells = [this](int n) {
      return fft::fast_plane_size(2 * (n + split_.fading_nodes)) / 2;
    };
    return {cells(nx), cells(ny), step * grid_.dx, step * grid_.dy, layers, grid_.dz};
  }
  Grid lattice(fft::fast_plane_size(nx + split_.middle_ring),
               fft::fast_plane_size(ny + split_.middle_ring), step * grid_.dx, step * grid_.dy,
               layers, grid_.dz);
  lattice.period = {lattice.nx, lattice.ny, 0.0};
  return lattice;
}

ZoneTables::Operators ZoneTables::of(Band band, Grid lattice) const {
  lattice.nz = (lattice.nz + layers_at_once - 1) / layers_at_once * layers_at_once;
  const std::lock_guard lock(mutex_);
  const auto at =
      kept_.try_emplace({static_cast<int>(band), lattice.nx, lattice.ny, lattice.nz}).first;
  Operators& place = at->second;
  if (!place) {
    const VolumeOptions options{tensor_, Symmetry::none, ResidualMethod::fast, image_tol_,
                                heat(band)};
    // Those of fewer layers come just before.
    Operators shallower;
    if (at != kept_.begin()) {
      const auto& [key, of_key] = *std::prev(at);
      if (std::equal(key.begin(), key.end() - 1, at->first.begin())) shallower = of_key;
    }
    place = std::make_shared<const VolumeOperators>(lattice, media_[static_cast<int>(band)],
                                                    options, std::move(shallower));
  }
  return place;
}

void ZoneTables::forget_unused() const {
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [](const auto& entry) { return entry.second.use_count() == 1; });
}

std::size_t ZoneTables::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t bytes = 0;
  for (const auto& [key, operators] : kept_) bytes += operators->bytes();
  return bytes;
}

Field ZoneTables::borrow(std::size_t count) const {
  Field field;
  const std::lock_guard lock(mutex_);
  const auto fits = [count](const Field& one) { return one.capacity() >= count; };
  const auto found = std::find_if(spare_.begin(), spare_.end(), fits);
  if (found != spare_.end()) {
    field = std::move(*found);
    spare_.erase(found);
  } else {
    // They are too small for what zones have become, which go on growing a little.
    spare_.clear();
    field.reserve(count + count / 4);
  }
  field.resize(count);
  return field;
}

void ZoneTables::give_back(Field field) const {
  const std::lock_guard lock(mutex_);
  const auto larger = [&](const Field& one) { return one.capacity() > field.capacity(); };
  spare_.insert(std::find_if(spare_.begin(), spare_.end(), larger), std::move(field));
}

}  // namespace samcontact::operators
