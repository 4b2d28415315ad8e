// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/body/body_surface.hpp"

#include <algorithm>
#include <cmath>

namespace samcontact::simulation {

using operators::Axis;

void BodySurface::add_displacement_to(Field& gap) {
  rim_displacement_ = 0.0;
  const Field& lift = outside_.displacement[static_cast<int>(Axis::z)];
  if (!lift.empty()) {
    add_displacement(outside_.surface, lift, Axis::z, copies_, gap.data());
    rim_displacement_ += largest_at_rim(outside_.surface, lift, false);
  }
  if (!strained_) return;
  const Box& surface = volume_->surface();
  Field displacement(surface.surface_size());
  volume_->displacement(Axis::z, displacement.data());
  add_displacement(surface, displacement, Axis::z, copies_, gap.data());
  rim_displacement_ += largest_at_rim(surface, displacement, true);
}

/// On a stored box, on one side of the mirror planes.
void BodySurface::add_displacement(const Box& box, const Field& displacement, Axis axis,
                                   double factor, double* to) const {
  const Grid& grid = setup_.grid;
  const Box whole = choice_.whole(box);
  const double mirrored_x = axis == Axis::x ? -1.0 : 1.0, mirrored_y = axis == Axis::y ? -1.0 : 1.0;
  const bool ends_at_zones = split_ && grid.period.x == 0;
  const auto add = [&](int at, const double* u, double part) {
    if (grid.period.x > 0) at = (at + grid.nx) % grid.nx;
    if (at < 0 || at >= grid.nx) return;
    double* row = to + static_cast<std::size_t>(at) * grid.ny;
    for (int j = std::max(0, whole.j0); j < std::min(grid.ny, whole.j0 + whole.ny); ++j) {
      row[j] += j < box.j0 ? mirrored_y * part * u[grid.ny - 1 - j - box.j0] : part * u[j - box.j0];
    }
  };
  const double part = std::fabs(offset_);
  const int side = offset_ > 0 ? -1 : 1;
  for (int i = whole.i0; i < whole.i0 + whole.nx; ++i) {
    const bool is_image = i < box.i0;
    const int si = is_image ? grid.nx - 1 - i : i;
    const double* u = displacement.data() + static_cast<std::size_t>(si - box.i0) * box.ny;
    const double weight = is_image ? mirrored_x * factor : factor;
    add(i, u, weight * (1 - part));
    if (part > 0) add(i + side, u, weight * part);
    // Zones have no displacement beyond the grid: that of the last row is close to it.
    if (ends_at_zones && i - side == (offset_ > 0 ? grid.nx : -1)) add(i, u, weight * part);
  }
}

std::span<const Axis> BodySurface::axes() const {
  // Mirror images have equal tangential displacements.
  if (setup_.friction.sticks() && copies_ == 1) return operators::all_axes;
  return operators::normal_axis;
}

void BodySurface::begin(ZoneVolume* volume, bool split, const Field& before) {
  volume_ = volume;
  split_ = split;
  displaced_before_ = {};
  if (before.empty() || volume_ == nullptr) return;
  volume_->transform(before, axes());
  for (const Axis axis : {Axis::x, Axis::y}) {
    Field& u = displaced_before_[static_cast<int>(axis)];
    u.resize(volume_->surface().surface_size());
    volume_->displacement(axis, u.data());
  }
}

void BodySurface::add_tangential_displacement_to(Field& free_slip) const {
  if (!strained_ || axes().size() == 1) return;
  const Box& surface = volume_->surface();
  Field u(surface.surface_size());
  for (const Axis axis : {Axis::x, Axis::y}) {
    const int a = static_cast<int>(axis);
    volume_->displacement(axis, u.data());
    // The displacement due to strain outside the zones is unchanged in the increment.
    const Field& before = displaced_before_[a];
    for (std::size_t i = 0; i < before.size(); ++i) u[i] -= before[i];
    add_displacement(surface, u, axis, -operators::shear_sign(body_),
                     free_slip.data() + a * setup_.grid.surface_size());
  }
}

/// Outside the box the displacement decreases.
double BodySurface::largest_at_rim(const Box& box, const Field& displacement, bool ends_x) const {
  double largest = 0.0;
  for (int i = 0; i < box.nx; ++i) {
    for (int j = 0; j < box.ny; ++j) {
      const bool at_x = ends_x && (i == box.nx - 1 || (i == 0 && !choice_.mirrors_x()));
      const bool at_y = j == box.ny - 1 || (j == 0 && !choice_.mirrors_y());
      if (!at_x && !at_y) continue;
      largest =
          std::max(largest, std::fabs(displacement[static_cast<std::size_t>(i) * box.ny + j]));
    }
  }
  return largest;
}

Box BodySurface::seen() const {
  Box seen = Box::surface(setup_.grid);
  // Zones have no displacement beyond the grid.
  if (split_ || rows_beyond(setup_.grid, offset_) == 0) return seen;
  ++seen.nx;
  if (offset_ < 0) --seen.i0;
  return seen;
}

Box BodySurface::possible_contact_outside(const Field& gap, double reach) const {
  if (rim_displacement_ == 0) return {};
  const Grid& grid = setup_.grid;
  const Box whole = known(), seen = this->seen();
  // A row of the grid between two rows of the body needs both.
  const int first = whole.i0 - seen.i0, end = first + whole.nx - (seen.nx - grid.nx);
  return bounding_box(grid, [&](std::size_t cell) {
    if (!(gap[cell] < reach)) return false;
    const int i = static_cast<int>(cell / grid.ny), j = static_cast<int>(cell % grid.ny);
    return i < first || i >= end || j < whole.j0 || j >= whole.j0 + whole.ny;
  });
}

Box BodySurface::below(const Box& part) const {
  const Box seen = this->seen();
  return {part.i0 + seen.i0, part.j0, part.nx + seen.nx - setup_.grid.nx, part.ny, 0};
}

}  // namespace samcontact::simulation
