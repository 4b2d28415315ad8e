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

/// Cells of the ring around a zone: the near band's range.
constexpr int ring = range(Band::near);
/// Nodes between the ends of the middle plane: its band is at its end there but for 1e-4 of the
/// residual stress.
constexpr int middle_ring = 10;
/// The ring's strain fades out in its last part.
constexpr double fades_from = 0.75;

double fade(int outside) {
  const double r = std::max(0.0, outside - 0.5) / ring;
  const double s = std::clamp((r - fades_from) / (1 - fades_from), 0.0, 1.0);
  const double c = std::cos(0.5 * std::numbers::pi * s);
  return c * c;
}

/// Cells by which a place lies outside of [begin, begin + count).
int outside(int at, int begin, int count) {
  return std::max({0, begin - at, at - (begin + count) + 1});
}

/// A periodic plane.
Grid plane(int nx, int ny, const Grid& cells, int step, int layers) {
  Grid grid(nx, ny, step * cells.dx, step * cells.dy, layers, cells.dz);
  grid.period = {nx, ny, 0.0};
  return grid;
}

VolumeOptions options(Tensor tensor, double image_tol) {
  return {tensor, Symmetry::none, ResidualMethod::fast, image_tol, {}};
}

}  // namespace

struct ZoneOperators::Around {
  Box box;                 // zone and ring, layers of all zones in it
  int mx, my;              // the plane
  std::vector<int> zones;  // that have cells in it
  bool alone = false;      // there is no other zone
  NearOperators operators;
};

/// The nodes of a band, with the strain's spectrum.
struct ZoneOperators::Lattice {
  NodeSpread nodes;
  VolumeOperators operators;
  VolumeSpectrum spectrum;

  Lattice(int factor, const Box& cells, const Grid& grid, const SharedMedium& medium,
          const VolumeOptions& options)
      : nodes(factor, cells),
        operators(grid, medium, options),
        spectrum(operators.make_spectrum()) {}

  std::size_t plane_size() const { return operators.grid().surface_size(); }
  int pitch() const { return operators.grid().ny; }
};

ZoneOperators::ZoneOperators(const Grid& grid, const SharedMedium& medium, std::vector<Box> zones,
                             Tensor tensor, double image_tol)
    : grid_(grid), zones_(std::move(zones)), tensor_(tensor), media_(bands_of(medium, grid)) {
  Box whole = Box::surface(grid);
  for (const Box& zone : zones_) {
    first_.push_back(cells_);
    cells_ += zone.volume_size();
    layers_ = std::max(layers_, zone.nz);
    whole = whole.united(zone);
  }
  const auto even = [](int cells) { return fft::good_even_size(cells); };
  const NodeSpread nodes(spacing(Band::middle), whole);
  const int nx = nodes.x().count(), ny = nodes.y().count(), reach = middle_ring;
  middle_ = std::make_unique<Lattice>(
      spacing(Band::middle), whole,
      plane(even(nx + reach), even(ny + reach), grid, spacing(Band::middle), layers_), media_[1],
      options(tensor, image_tol));
  constexpr int step = spacing(Band::far) / spacing(Band::middle);
  const Box middle_nodes{nodes.x().first(), nodes.y().first(), nx, ny, 1};
  const NodeSpread far_nodes(step, middle_nodes);
  const Grid far(far_nodes.x().count() + fading_nodes, far_nodes.y().count() + fading_nodes,
                 spacing(Band::far) * grid.dx, spacing(Band::far) * grid.dy, layers_, grid.dz);
  far_ = std::make_unique<Lattice>(step, middle_nodes, far, media_[2], options(tensor, image_tol));
  for (const Box& zone : zones_) {
    Around around{{zone.i0 - ring, zone.j0 - ring, zone.nx + 2 * ring, zone.ny + 2 * ring, zone.nz},
                  even(zone.nx + 2 * ring),
                  even(zone.ny + 2 * ring),
                  {},
                  true,
                  {}};
    for (std::size_t z = 0; z < zones_.size(); ++z) {
      if (around.box.intersected(zones_[z]).empty()) continue;
      around.zones.push_back(static_cast<int>(z));
      around.box.nz = std::max(around.box.nz, zones_[z].nz);
    }
    around.alone = around.zones.size() == 1;
    around.operators = near_operators(around.mx, around.my, around.box.nz);
    around_.push_back(std::move(around));
  }
}

ZoneOperators::~ZoneOperators() = default;

ZoneOperators::NearOperators ZoneOperators::near_operators(int mx, int my, int layers) {
  auto& place = near_[{mx, my, layers}];
  if (!place) {
    place = std::make_shared<const VolumeOperators>(plane(mx, my, grid_, 1, layers), media_[0],
                                                    options(tensor_, 1e-3));
  }
  return place;
}

void ZoneOperators::spread_layer(int k, const Field& strain) {
  const int parts = count(tensor_);
  const std::size_t middle = middle_->plane_size(), far = far_->plane_size();
  Field nodes(parts * middle, 0.0);
  bool any = false;
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    if (k >= zones_[z].nz) continue;
    any = true;
    for (int c = 0; c < parts; ++c) {
      const double* from = strain.data() + c * cells_ + first_[z] + k * zones_[z].surface_size();
      middle_->nodes.spread(from, zones_[z], nodes.data() + c * middle, middle_->pitch());
    }
  }
  middle_->spectrum.used[k] = any;
  if (!any) return;
  const Nodes &x = middle_->nodes.x(), &y = middle_->nodes.y();
  const Box rows{x.first(), y.first(), x.count(), y.count(), 1};
  Field tight(rows.surface_size());
  for (int c = 0; c < parts; ++c) {
    const double* from = nodes.data() + c * middle;
    for (int a = 0; a < rows.nx; ++a) {
      std::copy_n(from + static_cast<std::size_t>(a) * middle_->pitch(), rows.ny,
                  tight.data() + static_cast<std::size_t>(a) * rows.ny);
    }
    far_->nodes.spread(tight.data(), rows, far_strain_.data() + (c * layers_ + k) * far,
                       far_->pitch());
  }
  forward(middle_->operators.transform(), nodes.data(), middle_->spectrum, k);
}

void ZoneOperators::transform(const Field& strain) {
  check_interrupt();
  far_strain_.assign(count(tensor_) * layers_ * far_->plane_size(), 0.0);
#pragma omp parallel for schedule(dynamic)
  for (int k = 0; k < layers_; ++k) spread_layer(k, strain);
  forward(far_->operators.transform(), far_strain_.data(), far_->spectrum);

  near_displacement_.assign(zones_.size(), {});
  // Not in the loop: they are made once, by all threads.
  for (const auto& entry : near_) std::ignore = entry.second->residual_displacement();
#pragma omp parallel for schedule(dynamic)
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Uninterrupted quiet;
    const Around& around = around_[z];
    const VolumeOperators& near = *around.operators;
    const Box own{zones_[z].i0 - around.box.i0, zones_[z].j0 - around.box.j0, zones_[z].nx,
                  zones_[z].ny, zones_[z].nz};
    Field planes(count(tensor_) * near.grid().volume_size(), 0.0);
    for (int c = 0; c < count(tensor_); ++c) {
      insert(strain.data() + c * cells_ + first_[z], own,
             planes.data() + c * near.grid().volume_size(), Box::whole(near.grid()));
    }
    VolumeSpectrum spectrum = near.make_spectrum();
    forward(near.transform(), planes.data(), spectrum);
    Field& out = near_displacement_[z];
    out.resize(near.grid().surface_size());
    near.residual_displacement().apply(spectrum, out.data());
  }
}

void ZoneOperators::displacement(double* out) {
  const Box surface = Box::surface(grid_);
  Field middle(middle_->plane_size()), far(far_->plane_size());
  far_->operators.residual_displacement().apply(far_->spectrum, far.data());
  middle_->operators.residual_displacement().apply(middle_->spectrum, middle.data());
  const Nodes &x = middle_->nodes.x(), &y = middle_->nodes.y();
  const Box rows{x.first(), y.first(), x.count(), y.count(), 1};
  Field tight(rows.surface_size());
  for (int a = 0; a < rows.nx; ++a) {
    std::copy_n(middle.data() + static_cast<std::size_t>(a) * middle_->pitch(), rows.ny,
                tight.data() + static_cast<std::size_t>(a) * rows.ny);
  }
  far_->nodes.gather(far.data(), far_->pitch(), rows, tight.data());
  middle_->nodes.gather(tight.data(), rows.ny, surface, out);
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Around& around = around_[z];
    Box box{around.box.i0, around.box.j0, around.mx, around.my, 1};
    const Field& near = near_displacement_[z];
    for (int i = std::max(0, box.i0); i < std::min(grid_.nx, box.i0 + around.box.nx); ++i) {
      for (int j = std::max(0, box.j0); j < std::min(grid_.ny, box.j0 + around.box.ny); ++j) {
        out[static_cast<std::size_t>(i) * grid_.ny + j] +=
            near[static_cast<std::size_t>(i - box.i0) * around.my + j - box.j0];
      }
    }
  }
}

Field ZoneOperators::low_stress(bool strained, const Tractions& tractions, double shear_sign) {
  const int parts = count(tensor_);
  const std::size_t middle = middle_->plane_size(), far = far_->plane_size();
  const Nodes &x = middle_->nodes.x(), &y = middle_->nodes.y();
  const Box rows{x.first(), y.first(), x.count(), y.count(), 1};
  Tractions on_middle, on_far;
  const auto spread = [&](const Field& cells, Field& to_middle, Field& to_far) {
    if (cells.empty()) return;
    to_middle.assign(middle, 0.0);
    to_far.assign(far, 0.0);
    middle_->nodes.spread(cells.data(), Box::surface(grid_), to_middle.data(), middle_->pitch());
    Field tight(rows.surface_size());
    for (int a = 0; a < rows.nx; ++a) {
      std::copy_n(to_middle.data() + static_cast<std::size_t>(a) * middle_->pitch(), rows.ny,
                  tight.data() + static_cast<std::size_t>(a) * rows.ny);
    }
    far_->nodes.spread(tight.data(), rows, to_far.data(), far_->pitch());
  };
  spread(tractions.pressure, on_middle.pressure, on_far.pressure);
  spread(tractions.shear_x, on_middle.shear_x, on_far.shear_x);
  spread(tractions.shear_y, on_middle.shear_y, on_far.shear_y);
  if (!strained) {
    for (Lattice* lattice : {middle_.get(), far_.get()}) {
      std::fill(lattice->spectrum.data.begin(), lattice->spectrum.data.end(), 0.0);
    }
  }
  Field far_stress(parts * layers_ * far);
  const double* some = strained ? far_strain_.data() : nullptr;
  far_->operators.for_each_layer(
      far_->spectrum, some, &on_far, shear_sign, [&](int k, const double* stress) {
        std::copy_n(stress, parts * far, far_stress.data() + k * parts * far);
      });
  Field low(parts * cells_, 0.0);
  middle_->operators.for_each_layer(
      middle_->spectrum, some, &on_middle, shear_sign, [&](int k, const double* stress) {
        Field tight(rows.surface_size());
        for (int c = 0; c < parts; ++c) {
          for (int a = 0; a < rows.nx; ++a) {
            std::copy_n(stress + c * middle + static_cast<std::size_t>(a) * middle_->pitch(),
                        rows.ny, tight.data() + static_cast<std::size_t>(a) * rows.ny);
          }
          far_->nodes.gather(far_stress.data() + (k * parts + c) * far, far_->pitch(), rows,
                             tight.data());
          for (std::size_t z = 0; z < zones_.size(); ++z) {
            if (k >= zones_[z].nz) continue;
            middle_->nodes.gather(
                tight.data(), rows.ny, zones_[z],
                low.data() + c * cells_ + first_[z] + k * zones_[z].surface_size());
          }
        }
      });
  return low;
}

Field ZoneOperators::ring_strain(const Around& around, const Field& strain) const {
  const Grid& grid = around.operators->grid();
  const int parts = count(tensor_);
  const Box& own = around.box;
  Field planes(parts * grid.volume_size(), 0.0);
  for (const int z : around.zones) {
    const Box& zone = zones_[z];
    const Box common = own.intersected(zone);
    for (int c = 0; c < parts; ++c) {
      for (int k = 0; k < zone.nz; ++k) {
        for (int i = common.i0; i < common.i0 + common.nx; ++i) {
          const double* from = strain.data() + c * cells_ + first_[z] +
                               (static_cast<std::size_t>(k) * zone.nx + i - zone.i0) * zone.ny -
                               zone.j0;
          double* to =
              planes.data() +
              ((static_cast<std::size_t>(c) * grid.nz + k) * grid.nx + i - own.i0) * grid.ny -
              own.j0;
          const double x = fade(outside(i, own.i0 + ring, own.nx - 2 * ring));
          for (int j = common.j0; j < common.j0 + common.ny; ++j) {
            to[j] = from[j] * x * fade(outside(j, own.j0 + ring, own.ny - 2 * ring));
          }
        }
      }
    }
  }
  return planes;
}

void ZoneOperators::stress_of_zone(int zone, const Field* strain, const Tractions& tractions,
                                   double shear_sign, const Field& low, const Use& use) const {
  const Around& around = around_[zone];
  const VolumeOperators& near = *around.operators;
  const Box& box = zones_[zone];
  const int parts = count(tensor_);
  const std::size_t plane_size = near.grid().surface_size(), size = box.surface_size();
  Tractions here;
  bool any = false;
  const auto cut = [&](const Field& field, Field& out) {
    if (field.empty()) return;
    out.assign(plane_size, 0.0);
    Box to{around.box.i0, around.box.j0, around.mx, around.my, 1};
    copy_common(field.data(), Box::surface(grid_), out.data(), to);
    const bool loaded = std::any_of(out.begin(), out.end(), [](double v) { return v != 0; });
    if (!loaded) out.clear();
    any = any || loaded;
  };
  cut(tractions.pressure, here.pressure);
  cut(tractions.shear_x, here.shear_x);
  cut(tractions.shear_y, here.shear_y);
  VolumeSpectrum spectrum = near.make_spectrum();
  Field planes;
  if (strain != nullptr) {
    planes = ring_strain(around, *strain);
    forward(near.transform(), planes.data(), spectrum);
  }
  Field sum(parts * size);
  near.for_each_layer(spectrum, strain != nullptr ? planes.data() : nullptr, any ? &here : nullptr,
                      shear_sign, [&](int k, const double* stress) {
                        if (k >= box.nz) return;
                        for (int c = 0; c < parts; ++c) {
                          const double* given = low.data() + c * cells_ + first_[zone] + k * size;
                          for (int i = 0; i < box.nx; ++i) {
                            const double* from = stress + c * plane_size +
                                                 static_cast<std::size_t>(i + ring) * around.my +
                                                 ring;
                            for (int j = 0; j < box.ny; ++j) {
                              const std::size_t at = static_cast<std::size_t>(i) * box.ny + j;
                              sum[c * size + at] = given[at] + from[j];
                            }
                          }
                        }
                        use(zone, k, sum.data());
                      });
}

void ZoneOperators::for_each_layer(const Field* strain, const Tractions& tractions,
                                   double shear_sign, const Use& use) {
  const Field low = low_stress(strain != nullptr, tractions, shear_sign);
  for (const auto& entry : near_) {
    if (strain != nullptr) std::ignore = entry.second->residual_stress();
  }
  check_interrupt();
#pragma omp parallel for schedule(dynamic)
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const Uninterrupted quiet;
    stress_of_zone(static_cast<int>(z), strain, tractions, shear_sign, low, use);
  }
}

std::size_t ZoneOperators::bytes() const {
  std::size_t bytes = middle_->operators.bytes() + far_->operators.bytes();
  for (const auto& entry : near_) bytes += entry.second->bytes();
  for (const Lattice* lattice : {middle_.get(), far_.get()}) {
    bytes += lattice->spectrum.data.size() * sizeof(double);
  }
  return bytes;
}

}  // namespace samcontact::operators
