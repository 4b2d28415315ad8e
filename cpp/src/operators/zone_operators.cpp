// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zone_operators.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/fft/plan.hpp"

namespace samcontact::operators {
namespace {

/// Numbers that are 0, of one thread: what it has once taken stays with it.
double* zeros(std::size_t count) {
  static thread_local Field buffer;
  if (buffer.size() < count) buffer.resize(count);
  std::fill_n(buffer.begin(), count, 0.0);
  return buffer.data();
}

/// Weights of the strain along one axis, of a zone of `count` cells and its ring, so many before
/// and after, where it fades out from a part on.
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

/// The rows of a plane that some boxes, of its nodes, hold.
std::vector<fft::RowRun> rows_of(const std::vector<Box>& boxes, const Box& plane) {
  std::vector<char> used(plane.nx, 0);
  for (const Box& box : boxes) std::fill_n(used.begin() + (box.i0 - plane.i0), box.nx, 1);
  return fft::runs_of(used);
}

}  // namespace

struct ZoneOperators::Around {
  Box box;                 // zone and ring, layers of all zones in it
  int mx, my;              // the plane
  std::vector<int> zones;  // that have cells in it
  ZoneTables::Operators operators;
  Field fade_x, fade_y;               // weights of the strain in it
  std::array<Field, 3> displacement;  // by axis, [i][j] of the plane, of the zone's own strain
  VolumeSpectrum spectrum;            // of that strain
};

/// The nodes of a band, with the strain's spectrum.
struct ZoneOperators::Lattice {
  NodeSpread nodes;
  ZoneTables::Operators operators;
  VolumeSpectrum spectrum;

  Lattice(NodeSpread spread, ZoneTables::Operators of, int layers, const ZoneTables& tables)
      : nodes(std::move(spread)),
        operators(std::move(of)),
        spectrum(operators->transform(), layers, operators->tensor(),
                 tables.borrow(operators->transform().mh() * operators->transform().row_size() *
                               count(operators->tensor()) * layers)) {}

  std::vector<std::vector<fft::RowRun>> rows;  // that zones read, by layer

  std::size_t plane_size() const { return operators->grid().surface_size(); }
  int pitch() const { return operators->grid().ny; }
  int layers() const { return spectrum.nz; }
  /// The nodes of its planes.
  Box planes() const {
    const Grid& grid = operators->grid();
    return {nodes.box().i0, nodes.box().j0, grid.nx, grid.ny, 1};
  }
};

ZoneOperators::ZoneOperators(std::shared_ptr<const ZoneTables> tables, std::vector<Box> zones)
    : tables_(std::move(tables)),
      grid_(tables_->grid()),
      zones_(std::move(zones)),
      tensor_(tables_->tensor()) {
  for (const Box& zone : zones_) {
    first_.push_back(cells_);
    cells_ += zone.volume_size();
    layers_ = std::max(layers_, zone.nz);
  }
  make_lattices();
  for (const Box& zone : zones_) add_ring(zone);
  tables_->forget_unused();
}

ZoneOperators::~ZoneOperators() {
  for (Field* field :
       {&middle_->spectrum.data, &far_->spectrum.data, &far_strain_, &far_stress_, &low_}) {
    tables_->give_back(std::move(*field));
  }
}

void ZoneOperators::add_ring(const Box& zone) {
  const double fades_from = tables_->split().ring_fades_from;
  Box box = with_ring(zone, zones_, tables_->split());
  const int x0 = zone.i0 - box.i0, x1 = box.nx - zone.nx - x0;
  const int y0 = zone.j0 - box.j0, y1 = box.ny - zone.ny - y0;
  std::vector<int> inside;
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    if (box.intersected(zones_[z]).empty()) continue;
    inside.push_back(static_cast<int>(z));
    box.nz = std::max(box.nz, zones_[z].nz);
  }
  // Deeper strain of others is as far away as the ring's end.
  const int ring = std::max({x0, x1, y0, y1});
  box.nz = std::min(box.nz, zone.nz + static_cast<int>(std::ceil(ring * grid_.dx / grid_.dz)));
  const int mx = fft::fast_plane_size(box.nx), my = fft::fast_plane_size(box.ny);
  Grid plane(mx, my, grid_.dx, grid_.dy, box.nz, grid_.dz);
  plane.period = {mx, my, 0.0};
  const auto operators = tables_->of(Band::near, plane);
  around_.push_back({box,
                     mx,
                     my,
                     std::move(inside),
                     operators,
                     fades(x0, zone.nx, x1, fades_from),
                     fades(y0, zone.ny, y1, fades_from),
                     {},
                     VolumeSpectrum(operators->transform(), box.nz, tensor_)});
}

void ZoneOperators::make_lattices() {
  Box cells = Box::surface(grid_);
  for (const Box& zone : zones_) cells = cells.united(zone);
  const NodeSpread middle = tables_->middle_nodes(cells);
  const auto operators = [&](Band band, const NodeSpread& nodes) {
    return tables_->of(band, tables_->lattice(band, nodes, layers_));
  };
  middle_ = std::make_unique<Lattice>(middle, operators(Band::middle, middle), layers_, *tables_);
  const NodeSpread far = tables_->far_nodes(middle);
  const auto of_far = operators(Band::far, far);
  // Its images need the strain of all layers.
  far_ = std::make_unique<Lattice>(far, of_far, of_far->grid().nz, *tables_);
  find_rows();
  far_strain_ = tables_->borrow(far_->plane_size() * count(tensor_) * far_->layers());
  far_stress_ = tables_->borrow(far_->plane_size() * count(tensor_) * layers_);
  low_ = tables_->borrow(count(tensor_) * cells_);
}

void ZoneOperators::find_rows() {
  for (int k = 0; k < layers_; ++k) {
    std::vector<Box> in_middle, in_far;
    for (const Box& zone : zones_) {
      if (k >= zone.nz) continue;
      in_middle.push_back(middle_->nodes.reached(zone));
      in_far.push_back(far_->nodes.reached(in_middle.back()));
    }
    middle_->rows.push_back(rows_of(in_middle, middle_->planes()));
    far_->rows.push_back(rows_of(in_far, far_->planes()));
  }
}

void ZoneOperators::spread_layer(int k, const Field& strain) {
  const int parts = count(tensor_);
  const std::size_t middle = middle_->plane_size(), far = far_->plane_size();
  double* nodes = zeros(parts * middle);
  bool any = false;
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    if (k >= zones_[z].nz) continue;
    any = true;
    for (int c = 0; c < parts; ++c) {
      const double* from = strain.data() + c * cells_ + first_[z] + k * zones_[z].surface_size();
      middle_->nodes.spread(from, zones_[z].ny, zones_[z], nodes + c * middle, middle_->pitch());
    }
  }
  middle_->spectrum.used[k] = any;
  if (!any) return;
  for (int c = 0; c < parts; ++c) {
    far_->nodes.spread(
        nodes + c * middle, middle_->pitch(), middle_->nodes.box(),
        far_strain_.data() + (static_cast<std::size_t>(c) * far_->layers() + k) * far,
        far_->pitch());
  }
  forward(middle_->operators->transform(), nodes, middle_->spectrum, k);
}

void ZoneOperators::transform(const Field& strain, std::span<const Axis> axes) {
  check_interrupt();
  std::fill(far_strain_.begin(), far_strain_.end(), 0.0);
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < layers_; ++k) spread_layer(k, strain);
  forward(far_->operators->transform(), far_strain_.data(), far_->spectrum);

  // Not in the loop over zones: what is kept is made once, by all threads.
  for (const Around& around : around_) {
    std::ignore = around.operators->residual_stress();
    for (const Axis axis : axes) std::ignore = around.operators->residual_displacement(axis);
  }
#pragma omp parallel for schedule(dynamic)
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Uninterrupted quiet;
    transform_zone(static_cast<int>(z), strain, axes);
  }
}

void ZoneOperators::transform_zone(int zone, const Field& strain, std::span<const Axis> axes) {
  Around& around = around_[zone];
  const VolumeOperators& near = *around.operators;
  for (int k = 0; k < around.box.nz; ++k) {
    around.spectrum.used[k] = k < zones_[zone].nz;
    if (!around.spectrum.used[k]) continue;
    forward(near.transform(), strain_around(around, {&zone, 1}, k, strain), around.spectrum, k);
  }
  for (const Axis axis : axes) {
    Field& displacement = around.displacement[static_cast<int>(axis)];
    displacement.resize(near.grid().surface_size());
    near.residual_displacement(axis).apply(around.spectrum, displacement.data());
  }
}

void ZoneOperators::displacement(Axis axis, double* out) const {
  std::fill_n(out, grid_.surface_size(), 0.0);
  const Box surface = Box::surface(grid_);
  Field middle(middle_->plane_size()), far(far_->plane_size());
  far_->operators->residual_displacement(axis).apply(far_->spectrum, far.data());
  middle_->operators->residual_displacement(axis).apply(middle_->spectrum, middle.data());
  gather_low(far.data(), middle.data(), surface, out);
  for (const Around& around : around_) {
    const Box box = around.box.intersected(surface);
    for (int i = box.i0; i < box.i0 + box.nx; ++i) {
      const double* row = around.displacement[static_cast<int>(axis)].data() +
                          static_cast<std::ptrdiff_t>(i - around.box.i0) * around.my -
                          around.box.j0;
      double* to = out + static_cast<std::size_t>(i) * grid_.ny;
      for (int j = box.j0; j < box.j0 + box.ny; ++j) to[j] += row[j];
    }
  }
}

void ZoneOperators::gather_low(const double* far, const double* middle, const Box& box,
                               double* cells) const {
  const Box nodes = middle_->nodes.reached(box);
  Field sum(nodes.surface_size());
  extract(middle, middle_->planes(), sum.data(), nodes);
  far_->nodes.gather(far, far_->planes(), nodes, sum.data());
  middle_->nodes.gather(sum.data(), nodes, box, cells);
}

void ZoneOperators::find_low_stress(bool strained, const Tractions& tractions, double shear_sign) {
  const int parts = count(tensor_);
  const std::size_t middle = middle_->plane_size(), far = far_->plane_size();
  const Box rows = middle_->nodes.box();
  const Tractions on_middle =
      spread(tractions, Box::surface(grid_), grid_.ny, middle_->nodes, middle_->operators->grid());
  const Tractions on_far =
      spread(on_middle, rows, middle_->pitch(), far_->nodes, far_->operators->grid());
  if (!strained) {
    for (Lattice* lattice : {middle_.get(), far_.get()}) {
      std::fill(lattice->spectrum.data.begin(), lattice->spectrum.data.end(), 0.0);
    }
  }
  const double* some = strained ? far_strain_.data() : nullptr;
  far_->operators->for_each_layer(
      far_->spectrum, some, &on_far, shear_sign,
      [&](int k, const double* stress) {
        std::copy_n(stress, parts * far,
                    far_stress_.data() + static_cast<std::size_t>(k) * parts * far);
      },
      layers_, [&](int k) { return std::span<const fft::RowRun>(far_->rows[k]); });
  middle_->operators->for_each_layer(
      middle_->spectrum, some, &on_middle, shear_sign,
      [&](int k, const double* stress) {
        for (std::size_t z = 0; z < zones_.size(); ++z) {
          if (k >= zones_[z].nz) continue;
          double* of_zone = low_.data() + first_[z] + k * zones_[z].surface_size();
          for (int c = 0; c < parts; ++c) {
            const std::size_t from = (static_cast<std::size_t>(k) * parts + c) * far;
            double* to = of_zone + c * cells_;
            std::fill_n(to, zones_[z].surface_size(), 0.0);
            gather_low(far_stress_.data() + from, stress + c * middle, zones_[z], to);
          }
        }
      },
      layers_, [&](int k) { return std::span<const fft::RowRun>(middle_->rows[k]); });
}

bool ZoneOperators::has_strain(int zone, int k, const Field& strain, const Box& box) const {
  const Box& own = zones_[zone];
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

void ZoneOperators::add_others(std::size_t zone, const Field* strain) {
  Around& around = around_[zone];
  if (strain == nullptr) {
    std::fill(around.spectrum.data.begin(), around.spectrum.data.end(), 0.0);
    return;
  }
  for (int k = 0; k < around.box.nz; ++k) {
    const auto reaches = [&](int other) {
      return other != static_cast<int>(zone) && has_strain(other, k, *strain, around.box);
    };
    if (std::none_of(around.zones.begin(), around.zones.end(), reaches)) continue;
    around.spectrum.used[k] = 1;
    forward(around.operators->transform(), strain_around(around, around.zones, k, *strain),
            around.spectrum, k);
  }
}

const double* ZoneOperators::strain_around(const Around& around, std::span<const int> zones, int k,
                                           const Field& strain) const {
  const int parts = count(tensor_);
  const Box& own = around.box;
  const std::size_t plane = static_cast<std::size_t>(around.mx) * around.my;
  double* planes = zeros(parts * plane);
  for (const int z : zones) {
    const Box& zone = zones_[z];
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
  Around& around = around_[zone];
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
    copy_common(field.data(), Box::surface(grid_), out.data(), plane);
    if (std::all_of(out.begin(), out.end(), [](double v) { return v == 0; })) out.clear();
    any = any || !out.empty();
  };
  cut(tractions.pressure, here.pressure);
  cut(tractions.shear_x, here.shear_x);
  cut(tractions.shear_y, here.shear_y);
  add_others(zone, strain);
  const fft::RowRun rows{box.i0 - around.box.i0, box.nx};
  // A plane with a period has no images to be found from the strain.
  const double unused = 0.0;
  Field sum(parts * size);
  const auto with_low = [&](int k, const double* stress) {
    for (int c = 0; c < parts; ++c) {
      const double* given = low_.data() + c * cells_ + first_[zone] + k * size;
      double* to = sum.data() + c * size;
      extract(stress + c * plane_size, plane, to, layer);
      for (std::size_t n = 0; n < size; ++n) to[n] += given[n];
    }
    use(zone, k, sum.data());
  };
  near.for_each_layer(around.spectrum, strain != nullptr ? &unused : nullptr, any ? &here : nullptr,
                      shear_sign, with_low, box.nz,
                      [&rows](int) { return std::span<const fft::RowRun>(&rows, 1); });
}

void ZoneOperators::for_each_layer(const Field* strain, const Tractions& tractions,
                                   double shear_sign, const Use& use) {
  find_low_stress(strain != nullptr, tractions, shear_sign);
  check_interrupt();
#pragma omp parallel for schedule(dynamic)
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Uninterrupted quiet;
    stress_of_zone(z, strain, tractions, shear_sign, use);
  }
}

}  // namespace samcontact::operators
