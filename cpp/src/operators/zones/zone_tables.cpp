// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/zone_tables.hpp"

#include <algorithm>
#include <utility>

#include "samcontact/fft/plan.hpp"

namespace samcontact::operators {
namespace {

/// Tables have a multiple of this number of layers, so that they can be reused for zones that grow;
/// those of the near band are many and small.
constexpr int layers_at_once = 4, near_layers_at_once = 8;

/// Index of a node within its period.
int folded(int node, int period) { return ((node % period) + period) % period; }

}  // namespace

NodePlanes::NodePlanes(NodeSpread nodes, const Grid& lattice, bool periodic)
    : nodes_(std::move(nodes)), lattice_(lattice), periodic_(periodic), sheet_(nodes_.box()) {
  if (!periodic_) sheet_.nx = lattice_.nx, sheet_.ny = lattice_.ny;
}

Box NodePlanes::own() const {
  return periodic_ ? Box{0, 0, lattice_.nx, lattice_.ny, 1} : nodes_.box();
}

void NodePlanes::for_each_piece(const Box& box, const UsePiece& use) const {
  const int i0 = periodic_ ? 0 : sheet_.i0, j0 = periodic_ ? 0 : sheet_.j0;
  std::size_t from = 0;
  for (int a = box.i0 - i0; a < box.i0 - i0 + box.nx; ++a) {
    const std::size_t row = static_cast<std::size_t>(folded(a, lattice_.nx)) * lattice_.ny;
    for (int b = 0; b < box.ny;) {
      const int at = folded(box.j0 - j0 + b, lattice_.ny),
                count = std::min(lattice_.ny - at, box.ny - b);
      use(from, row + at, count);
      from += count;
      b += count;
    }
  }
}

void NodePlanes::fold(const double* sheet, double* plane) const {
  for_each_piece(sheet_, [&](std::size_t from, std::size_t to, int count) {
    for (int n = 0; n < count; ++n) plane[to + n] += sheet[from + n];
  });
}

void NodePlanes::spread(const double* cells, int pitch, const Box& box, double* plane) const {
  if (!periodic_) return nodes_.spread(cells, pitch, box, plane, sheet_.ny);
  Field sheet(sheet_size(), 0.0);
  nodes_.spread(cells, pitch, box, sheet.data(), sheet_.ny);
  fold(sheet.data(), plane);
}

const double* NodePlanes::sheet_of(const double* plane, Field& room) const {
  if (!periodic_) return plane;
  room.resize(sheet_size());
  for_each_piece(sheet_, [&](std::size_t to, std::size_t from, int count) {
    std::copy_n(plane + from, count, room.data() + to);
  });
  return room.data();
}

std::vector<fft::RowRun> NodePlanes::rows_of(const std::vector<Box>& boxes) const {
  std::vector<char> used(lattice_.nx, 0);
  for (const Box& box : boxes) {
    for (int a = box.i0; a < box.i0 + box.nx; ++a) {
      used[periodic_ ? folded(a, lattice_.nx) : a - sheet_.i0] = 1;
    }
  }
  return fft::runs_of(used);
}

Tractions spread(const Tractions& cells, const Box& box, int pitch, const NodePlanes& planes) {
  const auto spread_one = [&](const Field& from) {
    if (from.empty()) return Field{};
    Field to(planes.plane_size(), 0.0);
    planes.spread(from.data(), pitch, box, to.data());
    return to;
  };
  return {spread_one(cells.pressure), spread_one(cells.shear_x), spread_one(cells.shear_y)};
}

bool can_be_split(const Grid& grid, const BandSplit& split) {
  if (!grid.period.is_on()) return true;
  const int step = 2 * split.far_spacing;
  return grid.nx % step == 0 && grid.ny % step == 0 && grid.period.x == grid.nx &&
         grid.period.y == grid.ny;
}

Box zone_with_margin(const Box& zone, const std::vector<Box>& zones, const BandSplit& split) {
  const int ring = split.near_range, more = std::max(0, split.wide_margin - ring);
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

Box zone_with_margin(const Box& zone, const BoxIndex& zones, const BandSplit& split) {
  const int ring = split.near_range;
  std::vector<Box> near;
  for (const int n : zones.overlapping(
           {zone.i0 - ring, zone.j0 - ring, zone.nx + 2 * ring, zone.ny + 2 * ring})) {
    near.push_back(zones[n]);
  }
  return zone_with_margin(zone, near, split);
}

ZoneTables::ZoneTables(const Grid& grid, const SharedMedium& medium, Tensor tensor,
                       double image_tol, const BandSplit& split, const Heating& heating)
    : grid_(grid),
      tensor_(tensor),
      image_tol_(image_tol),
      split_((require_valid(split), split)),
      bands_(bands_of(medium, grid, split)) {
  if (!heating.is_on()) return;
  for (std::size_t band = 0; band < bands_.size(); ++band) {
    heat_[band] = std::make_shared<const HeatStress>(bands_[band].heat, heating);
  }
}

NodePlanes ZoneTables::middle_planes(const Box& cells, int layers) const {
  return planes(Band::middle, {split_.middle_spacing, split_.window_width, cells}, layers);
}

NodePlanes ZoneTables::far_planes(const NodePlanes& middle, int layers) const {
  const int step = split_.far_spacing / split_.middle_spacing;
  return planes(Band::far, {step, split_.window_width, middle.nodes().box()}, layers);
}

NodePlanes ZoneTables::planes(Band band, NodeSpread nodes, int layers) const {
  const int step = split_.spacing(band);
  const auto count = [&](int cells, int reached) {
    if (is_periodic()) return cells / step;
    if (band == Band::middle) return fft::fast_plane_size(reached + split_.middle_gap);
    return fft::fast_plane_size(2 * (reached + split_.fading_nodes)) / 2;
  };
  Grid lattice(count(grid_.nx, nodes.x().count()), count(grid_.ny, nodes.y().count()),
               step * grid_.dx, step * grid_.dy, layers, grid_.dz);
  if (is_periodic() || band == Band::middle) lattice.period = {lattice.nx, lattice.ny, 0.0};
  return {std::move(nodes), lattice, is_periodic()};
}

ZoneTables::Operators ZoneTables::of(Band band, Grid lattice) const {
  const int some = band == Band::near ? near_layers_at_once : layers_at_once;
  lattice.nz = (lattice.nz + some - 1) / some * some;
  const std::lock_guard lock(mutex_);
  const auto at =
      kept_.try_emplace({static_cast<int>(band), lattice.nx, lattice.ny, lattice.nz}).first;
  Operators& place = at->second;
  if (!place) {
    const VolumeOptions options{tensor_, Symmetry::none, ResidualMethod::fast, image_tol_,
                                heat(band)};
    // Tables of fewer layers come just before.
    Operators shallower;
    if (at != kept_.begin()) {
      const auto& [key, of_key] = *std::prev(at);
      if (std::equal(key.begin(), key.end() - 1, at->first.begin())) shallower = of_key;
    }
    place = std::make_shared<const VolumeOperators>(lattice, bands_[static_cast<int>(band)].medium,
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

std::size_t ZoneTables::held_bytes() const {
  std::size_t sum = bytes();
  const std::lock_guard lock(mutex_);
  for (const Field& field : spare_) sum += field.capacity() * sizeof(double);
  return sum;
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
    // They are too small for the present zones.
    spare_.clear();
  }
  field.resize(count);
  return field;
}

VolumeSpectrum ZoneTables::borrow_spectrum(const VolumeTransform& transform, int layers,
                                           Tensor tensor) const {
  const std::size_t plane = transform.mh() * transform.row_size();
  return {transform, layers, tensor, borrow(plane * count(tensor) * layers)};
}

void ZoneTables::give_back(Field field) const {
  const std::lock_guard lock(mutex_);
  const auto larger = [&](const Field& one) { return one.capacity() > field.capacity(); };
  spare_.insert(std::find_if(spare_.begin(), spare_.end(), larger), std::move(field));
}

}  // namespace samcontact::operators
