// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/zone_operators.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/team.hpp"
#include "samcontact/fft/plan.hpp"

namespace samcontact::operators {
namespace {

/// Weights of the strain along one axis, for a zone of `count` cells and its margins of given
/// widths, in which it fades out from a fraction on.
Field fades(int before, int count, int after, double fades_from) {
  Field weights(before + count + after);
  for (int n = 0; n < before + count + after; ++n) {
    const double outside = std::max({0.0, before - n - 0.5, n - (before + count) + 0.5});
    const double r = outside / (n < before ? before : after);
    const double s = std::clamp((r - fades_from) / (1 - fades_from), 0.0, 1.0);
    weights[n] = std::pow(std::cos(0.5 * std::numbers::pi * s), 2);
  }
  return weights;
}

}  // namespace

struct ZoneOperators::Around {
  Box box;                // zone and margin, with the layers of all zones in it
  int mx, my;             // size of the plane
  std::vector<int> near;  // neighbours with cells in it; its own zone first
  ZoneTables::Operators operators;
  Field fade_x, fade_y;  // weights of the strain in the margin
  // By axis, [i][j] of the plane, due to the strain of the zone itself.
  std::array<Field, 3> displacement;
};

ZoneOperators::ZoneOperators(std::shared_ptr<const ZoneTables> tables, std::vector<Box> zones)
    : tables_(std::move(tables)),
      grid_(tables_->grid()),
      zones_(std::move(zones)),
      tensor_(tables_->tensor()),
      low_(tables_, zones_) {
  for (const Box& zone : zones_) {
    first_.push_back(cells_);
    cells_ += zone.volume_size();
  }
  find_neighbours();
  for (std::size_t z = 0; z < zones_.size(); ++z) add_ring(static_cast<int>(z));
  tables_->forget_unused();
}

ZoneOperators::~ZoneOperators() = default;

void ZoneOperators::find_neighbours() {
  shifts_ = {{0, 0}};
  for (int x = -1; x <= 1 && tables_->is_periodic(); ++x) {
    for (int y = -1; y <= 1; ++y) {
      if (x != 0 || y != 0) shifts_.push_back({x * grid_.nx, y * grid_.ny});
    }
  }
  std::vector<Box> boxes;
  boxes.reserve(shifts_.size() * zones_.size());
  for (const auto& [x, y] : shifts_) {
    for (const Box& zone : zones_) boxes.push_back(zone.moved(x, y));
  }
  neighbours_ = BoxIndex(std::move(boxes));
}

void ZoneOperators::add_ring(int number) {
  const Box& zone = zones_[number];
  const double fades_from = tables_->split().margin_fade_fraction;
  Box box = zone_with_margin(zone, neighbours_, tables_->split());
  const int x0 = zone.i0 - box.i0, x1 = box.nx - zone.nx - x0;
  const int y0 = zone.j0 - box.j0, y1 = box.ny - zone.ny - y0;
  std::vector<int> inside = neighbours_.overlapping(box);
  for (const int n : inside) box.nz = std::max(box.nz, neighbours_[n].nz);
  // Strain of other zones at larger depths is as far away as the end of the margin.
  const int ring = std::max({x0, x1, y0, y1});
  box.nz = std::min(box.nz, zone.nz + static_cast<int>(std::ceil(ring * grid_.dx / grid_.dz)));
  const int mx = fft::fast_plane_size(box.nx), my = fft::fast_plane_size(box.ny);
  Grid plane(mx, my, grid_.dx, grid_.dy, box.nz, grid_.dz);
  plane.period = {mx, my, 0.0};
  around_.push_back({box,
                     mx,
                     my,
                     std::move(inside),
                     tables_->of(Band::near, plane),
                     fades(x0, zone.nx, x1, fades_from),
                     fades(y0, zone.ny, y1, fades_from),
                     {}});
}

void ZoneOperators::transform(const Field& strain, std::span<const Axis> axes) {
  low_.transform(strain);
  // Not in the loop over zones: cached data are built once, by all threads.
  for (const Around& around : around_) {
    std::ignore = around.operators->residual_stress();
    for (const Axis axis : axes) around.operators->residual_displacement(axis).build_all();
  }
#pragma omp parallel for schedule(dynamic)
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Uninterrupted quiet;
    const SingleThread alone;
    transform_zone(static_cast<int>(z), strain, axes);
  }
}

void ZoneOperators::transform_zone(int zone, const Field& strain, std::span<const Axis> axes) {
  Around& around = around_[zone];
  const VolumeOperators& near = *around.operators;
  const VolumeSpectrum spectrum = spectrum_around(around, {&zone, 1}, strain);
  for (const Axis axis : axes) {
    Field& displacement = around.displacement[static_cast<int>(axis)];
    displacement.resize(near.grid().surface_size());
    near.residual_displacement(axis).apply(spectrum, displacement.data());
  }
}

void ZoneOperators::displacement(Axis axis, double* out) const {
  std::fill_n(out, grid_.surface_size(), 0.0);
  low_.add_displacement(axis, out);
  for (const Around& around : around_) {
    const double* of_zone = around.displacement[static_cast<int>(axis)].data();
    for (const auto& [x, y] : shifts_) add_displacement(around, of_zone, x, y, out);
  }
}

void ZoneOperators::add_displacement(const Around& around, const double* of_zone, int x, int y,
                                     double* out) const {
  const Box there = around.box.moved(x, y), box = there.intersected(Box::surface(grid_));
  for (int i = box.i0; i < box.i0 + box.nx; ++i) {
    const double* row = of_zone + static_cast<std::ptrdiff_t>(i - there.i0) * around.my - there.j0;
    double* to = out + static_cast<std::size_t>(i) * grid_.ny;
    for (int j = box.j0; j < box.j0 + box.ny; ++j) to[j] += row[j];
  }
}

bool ZoneOperators::has_strain(int neighbour, int k, const Field& strain, const Box& box) const {
  const Box& own = neighbours_[neighbour];
  const std::size_t zone = zone_of(neighbour);
  const Box common = own.intersected(box);
  if (k >= own.nz || common.empty()) return false;
  for (int c = 0; c < count(tensor_); ++c) {
    for (int i = common.i0; i < common.i0 + common.nx; ++i) {
      const double* row = strain.data() + c * cells_ + first_[zone] +
                          (static_cast<std::size_t>(k) * own.nx + i - own.i0) * own.ny + common.j0 -
                          own.j0;
      if (std::any_of(row, row + common.ny, [](double v) { return v != 0; })) return true;
    }
  }
  return false;
}

VolumeSpectrum ZoneOperators::spectrum_around(const Around& around, std::span<const int> neighbours,
                                              const Field& strain) const {
  const VolumeTransform& transform = around.operators->transform();
  VolumeSpectrum spectrum(transform, around.box.nz, tensor_);
  for (int k = 0; k < around.box.nz; ++k) {
    spectrum.used[k] = std::ranges::any_of(
        neighbours, [&](int n) { return has_strain(n, k, strain, around.box); });
    if (!spectrum.used[k]) continue;
    forward(transform, strain_around(around, neighbours, k, strain), spectrum, k);
  }
  return spectrum;
}

const double* ZoneOperators::strain_around(const Around& around, std::span<const int> neighbours,
                                           int k, const Field& strain) const {
  const int parts = count(tensor_);
  const Box& own = around.box;
  const std::size_t plane = static_cast<std::size_t>(around.mx) * around.my;
  double* planes = of_zeros(parts * plane);
  for (const int n : neighbours) {
    const Box& zone = neighbours_[n];
    const std::size_t z = zone_of(n);
    if (k >= zone.nz) continue;
    const Box common = own.intersected(zone);
    const double* y = around.fade_y.data() + common.j0 - own.j0;
    for (int c = 0; c < parts; ++c) {
      for (int i = common.i0; i < common.i0 + common.nx; ++i) {
        const double* from = strain.data() + c * cells_ + first_[z] +
                             (static_cast<std::size_t>(k) * zone.nx + i - zone.i0) * zone.ny +
                             common.j0 - zone.j0;
        double* to = planes + c * plane + static_cast<std::ptrdiff_t>(i - own.i0) * around.my +
                     common.j0 - own.j0;
        const double x = around.fade_x[i - own.i0];
        for (int j = 0; j < common.ny; ++j) to[j] = from[j] * x * y[j];
      }
    }
  }
  return planes;
}

void ZoneOperators::stress_of_zone(std::size_t zone, const Field* strain,
                                   const Tractions& tractions, double shear_sign, const Use& use) {
  const Around& around = around_[zone];
  const VolumeOperators& near = *around.operators;
  const Box& box = zones_[zone];
  const Box layer{box.i0, box.j0, box.nx, box.ny, 1};
  const Box plane{around.box.i0, around.box.j0, around.mx, around.my, 1};
  const int parts = count(tensor_);
  const std::size_t plane_size = near.grid().surface_size(), size = box.surface_size();
  Tractions here;
  bool any = false;
  const auto cut = [&](const Field& field, Field& out) {
    if (field.empty()) return;
    out.assign(plane_size, 0.0);
    for (const auto& [x, y] : shifts_) {
      copy_common(field.data(), Box::surface(grid_).moved(x, y), out.data(), plane);
    }
    if (std::all_of(out.begin(), out.end(), [](double v) { return v == 0; })) out.clear();
    any = any || !out.empty();
  };
  cut(tractions.pressure, here.pressure);
  cut(tractions.shear_x, here.shear_x);
  cut(tractions.shear_y, here.shear_y);
  VolumeSpectrum spectrum = strain != nullptr
                                ? spectrum_around(around, around.near, *strain)
                                : VolumeSpectrum(near.transform(), around.box.nz, tensor_);
  const fft::RowRun rows{box.i0 - around.box.i0, box.nx};
  // A periodic plane needs no image correction from the strain.
  const double unused = 0.0;
  Field near_part(size), sum(parts * size);
  const auto with_low = [&](int k, const double* stress) {
    low_.stress(zone, k, sum.data());
    for (int c = 0; c < parts; ++c) {
      double* to = sum.data() + c * size;
      extract(stress + c * plane_size, plane, near_part.data(), layer);
      for (std::size_t n = 0; n < size; ++n) to[n] += near_part[n];
    }
    use(zone, k, sum.data());
  };
  near.for_each_layer(spectrum, strain != nullptr ? &unused : nullptr, any ? &here : nullptr,
                      shear_sign, with_low, box.nz,
                      [&rows](int) { return std::span<const fft::RowRun>(&rows, 1); });
}

void ZoneOperators::for_each_layer(const Field* strain, const Tractions& tractions,
                                   double shear_sign, const Use& use) {
  low_.find_stress(strain != nullptr, tractions, shear_sign);
  check_interrupt();
#pragma omp parallel for schedule(dynamic)
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Uninterrupted quiet;
    const SingleThread alone;
    stress_of_zone(z, strain, tractions, shear_sign, use);
  }
  low_.lend();
}

}  // namespace samcontact::operators
