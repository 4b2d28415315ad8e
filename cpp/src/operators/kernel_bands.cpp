// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/kernel_bands.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <tuple>
#include <unordered_map>

#include "samcontact/base/cells_over.hpp"
#include "samcontact/base/smooth_step.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/operators/cell_influence.hpp"
#include "samcontact/operators/node_spread.hpp"
#include "samcontact/operators/scaled_images.hpp"
#include "samcontact/operators/smooth_continuation.hpp"
#include "samcontact/operators/volume_medium.hpp"

namespace samcontact::operators {
namespace {

constexpr double pi = std::numbers::pi;

/// Low pass, 1 at q = 0 and gone at a part of the highest wavenumber of nodes `factor` cells apart:
/// a step smoothed by a Gaussian, even in q, so that the rest is of short range.
double low_pass(double q, int factor, double gone_at, double sharpness) {
  const double gone = gone_at * pi / factor, a = sharpness, b = 2 * a / gone;
  return (std::erf(a + b * q) + std::erf(a - b * q)) / (2 * std::erf(a));
}

/// The tables of all bands of one medium. Thread-safe.
class BandTables {
 public:
  BandTables(SharedMedium medium, const Grid& cells, const BandSplit& bands)
      : medium_(std::move(medium)),
        cells_(cells),
        bands_(bands),
        window_(bands.window_width),
        near_(bands.middle_spacing, bands.near_range, bands.clear_band, bands.middle_spacing),
        middle_(bands.far_spacing, bands.middle_range, bands.clear_band, bands.middle_spacing) {
    cells_.period = {};
  }

  const SharedMedium& medium() const { return medium_; }
  const BandSplit& bands() const { return bands_; }
  /// What spreading and gathering make of a wave along one axis, wavenumber in 1/cell.
  double window_gain(Band band, double k) const;
  /// Share of a band in the residual stress of a wave, wavenumbers in 1/cell: the three add up
  /// to 1.
  double share(Band band, double kx, double ky) const;

  /// Layers whose strain moves the surface by a band: below, that has fallen to 1e-4.
  int strained_layers(Band band, const Grid& grid) const {
    return layers(band, grid, bands_.near_moves, bands_.middle_moves);
  }
  /// Layers which tractions stress by a band: below, that has fallen to 1e-5.
  int stressed_layers(Band band, const Grid& grid) const {
    return layers(band, grid, bands_.near_stressed, bands_.middle_stressed);
  }

  /// [component][j][i] at nodes 0..offsets - 1 of the band.
  Field stress(Band band, Traction traction, const KernelOffsets& offsets, double z,
               Tensor tensor) const {
    const Key key{What::stress, traction, z, tensor};
    return tables(band, key, offsets, parities(traction, tensor), [&](const CellOffsets& at) {
      return medium_->stress(traction, cells_, at, z, tensor);
    });
  }

  /// Of heat, as Medium::heat_stress gives it.
  std::array<ParityParts, 6> heat_stress(Band band, const Heating& heating,
                                         const KernelOffsets& offsets, double z) const;

  Field residual_displacement(Band band, Axis axis, const KernelOffsets& offsets, int layer) const {
    const Traction along = traction_along(axis);
    const Key key{What::displacement, along, static_cast<double>(layer), Tensor::full};
    return tables(band, key, offsets, parities(along, Tensor::full), [&](const CellOffsets& at) {
      return medium_->residual_displacement(axis, cells_, at, layer);
    });
  }

 private:
  /// And the depth or layer.
  enum class What { stress, heat, displacement };
  using Key = std::tuple<What, Traction, double, Tensor>;
  using Exact = std::function<Field(const CellOffsets& offsets)>;
  using Parities = std::vector<kernels::Parity>;
  static Parities parities(Traction traction, Tensor tensor) {
    Parities parities;
    for (const int c : components(tensor)) parities.push_back(stress_parity(traction, c));
    return parities;
  }
  /// [component][j][i]: the short tables of near and middle nodes, and the inside of the far ones.
  struct Split {
    Field near, middle, far;
  };

  /// Of a grid, down to a depth in cells; all of the far band.
  int layers(Band band, const Grid& grid, double near, double middle) const {
    if (band == Band::far) return grid.nz;
    const double depth = (band == Band::near ? near : middle) * std::max(cells_.dx, cells_.dy);
    return std::min(grid.nz, cells_over(depth, grid.dz));
  }
  std::shared_ptr<const Split> split(const Key& key, const Parities& parities,
                                     const Exact& exact) const;
  Field tables(Band band, const Key& key, const KernelOffsets& offsets, const Parities& parities,
               const Exact& exact) const;
  Field far_tables(const Split& split, const KernelOffsets& offsets, const Parities& parities,
                   const Exact& exact) const;
  void sharpen(Band band, const KernelOffsets& offsets, int mx, int my, const Parities& parities,
               Field& tables) const;

  SharedMedium medium_;
  Grid cells_;
  BandSplit bands_;
  WindowTransform window_;
  SmoothContinuation near_, middle_;
  mutable std::mutex mutex_;
  mutable std::map<Key, std::shared_ptr<const Split>> kept_;
};

double BandTables::window_gain(Band band, double k) const {
  if (band == Band::near) return 1.0;
  double gain = window_(k * bands_.middle_spacing);
  if (band == Band::far) gain *= window_(k * bands_.far_spacing);
  return gain * gain;
}

double BandTables::share(Band band, double kx, double ky) const {
  const double q = std::hypot(kx, ky);
  const auto pass = [&](int spacing, double sharpness) {
    return low_pass(q, spacing, bands_.gone_at, sharpness);
  };
  const double middle = pass(bands_.middle_spacing, bands_.middle_sharpness);
  const double far = pass(bands_.far_spacing, bands_.far_sharpness);
  switch (band) {
    case Band::near:
      return 1 - middle;
    case Band::middle:
      return middle - far;
    default:
      return far;
  }
}

/// Of some offsets in cells from 0 on, those between nodes.
int nodes_in(int cells, int spacing) { return (cells + spacing - 1) / spacing; }

/// Puts the inside [j][i] of a square into a table.
void replace(const Field& inside, int cells, double* table, int width) {
  for (int j = 0; j < cells; ++j) {
    std::copy_n(inside.data() + static_cast<std::ptrdiff_t>(j) * cells, cells,
                table + static_cast<std::ptrdiff_t>(j) * width);
  }
}

std::shared_ptr<const BandTables::Split> BandTables::split(const Key& key, const Parities& parities,
                                                           const Exact& exact) const {
  {
    const std::lock_guard lock(mutex_);
    const auto found = kept_.find(key);
    if (found != kept_.end()) return found->second;
  }
  const int wide = middle_.reach(), close = near_.reach();
  const int near_cells = near_.cells(), middle_cells = middle_.cells();
  const int step = bands_.middle_spacing;
  const int near_nodes = nodes_in(close, step), middle_nodes = nodes_in(wide, step);
  Field whole = exact(CellOffsets::lattice(wide, wide));
  auto split = std::make_shared<Split>();
  Field around(static_cast<std::size_t>(close) * close);
  for (std::size_t c = 0; c < parities.size(); ++c) {
    double* table = whole.data() + c * static_cast<std::size_t>(wide) * wide;
    for (int j = 0; j < close; ++j)
      std::copy_n(table + static_cast<std::size_t>(j) * wide, close,
                  around.data() + static_cast<std::size_t>(j) * close);
    const Field exact_near(around);
    replace(near_.inside(around.data(), parities[c]), near_cells, around.data(), close);
    for (int j = 0; j < near_cells; ++j) {
      for (int i = 0; i < near_cells; ++i) {
        split->near.push_back(exact_near[j * close + i] - around[j * close + i]);
      }
    }
    replace(middle_.inside(table, parities[c]), middle_cells, table, wide);
    const Field near_rest = near_.rest(around.data(), parities[c]);
    const Field middle_rest = middle_.rest(table, parities[c]);
    const auto far_at = [&](int j, int i) {
      return table[j * wide + i] - middle_rest[j / step * middle_nodes + i / step];
    };
    for (int j = 0; j < close; j += step) {
      for (int i = 0; i < close; i += step) {
        const double held = around[j * close + i] - near_rest[j / step * near_nodes + i / step];
        split->middle.push_back(held - far_at(j, i));
      }
    }
    for (int j = 0; j < wide; j += bands_.far_spacing) {
      for (int i = 0; i < wide; i += bands_.far_spacing) split->far.push_back(far_at(j, i));
    }
  }
  const std::lock_guard lock(mutex_);
  return kept_.emplace(key, std::move(split)).first->second;
}

/// Divides tables [component][j][i] at nodes 0..nx - 1, 0..ny - 1 by what the window of a band
/// makes of their waves. mx, my: period.
void BandTables::sharpen(Band band, const KernelOffsets& offsets, int mx, int my,
                         const Parities& parities, Field& tables) const {
  const auto [nx, ny] = offsets;
  const fft::ParitySpectrum spectrum(mx, my);
  const int hx = spectrum.hx(), hy = spectrum.hy();
  const auto factors = [&](int count) {
    Field factor(count);
    for (int n = 0; n < count; ++n) {
      const double part = static_cast<double>(n) / (count - 1);
      const double above = (part - bands_.clear_band) / (1 - bands_.clear_band);
      factor[n] = rising(1 - above) / window_gain(band, part * pi / bands_.spacing(band));
    }
    return factor;
  };
  const Field factor_x = factors(hx), factor_y = factors(hy);
  const double points = static_cast<double>(mx) * my;
  for (std::size_t c = 0; c < parities.size(); ++c) {
    double* table = tables.data() + c * static_cast<std::size_t>(nx) * ny;
    Field quarter(spectrum.size(), 0.0);
    for (int j = 0; j < ny; ++j) {
      std::copy_n(table + static_cast<std::size_t>(j) * nx, nx,
                  quarter.data() + static_cast<std::size_t>(j) * hx);
    }
    spectrum.transform(quarter.data(), parities[c].odd_x, parities[c].odd_y);
    for (int j = 0; j < hy; ++j) {
      for (int i = 0; i < hx; ++i) {
        quarter[static_cast<std::size_t>(j) * hx + i] *= points * factor_x[i] * factor_y[j];
      }
    }
    spectrum.transform(quarter.data(), parities[c].odd_x, parities[c].odd_y);
    for (int j = 0; j < ny; ++j) {
      std::copy_n(quarter.data() + static_cast<std::size_t>(j) * hx, nx,
                  table + static_cast<std::size_t>(j) * nx);
    }
  }
}

Field BandTables::tables(Band band, const Key& key, const KernelOffsets& offsets,
                         const Parities& parities, const Exact& exact) const {
  const auto parts = split(key, parities, exact);
  if (band == Band::far) return far_tables(*parts, offsets, parities, exact);
  const Field& from = band == Band::near ? parts->near : parts->middle;
  const int size =
      band == Band::near ? near_.cells() : nodes_in(near_.reach(), bands_.middle_spacing);
  const std::size_t plane = static_cast<std::size_t>(offsets.nx) * offsets.ny;
  Field out(parities.size() * plane, 0.0);
  for (std::size_t c = 0; c < parities.size(); ++c) {
    for (int j = 0; j < std::min(size, offsets.ny); ++j) {
      std::copy_n(from.data() + (c * size + j) * size, std::min(size, offsets.nx),
                  out.data() + c * plane + static_cast<std::size_t>(j) * offsets.nx);
    }
  }
  if (band == Band::middle) {
    sharpen(band, offsets, 2 * (offsets.nx - 1), 2 * (offsets.ny - 1), parities, out);
  }
  return out;
}

std::array<ParityParts, 6> BandTables::heat_stress(Band band, const Heating& heating,
                                                   const KernelOffsets& offsets, double z) const {
  const std::vector<HeatPart> places = heat_stress_parts(heating);
  Parities parities;
  for (const HeatPart& place : places) parities.push_back(place.parity);
  const auto exact = [&](const CellOffsets& at) {
    Offsets lengths;
    for (const int i : at.x) lengths.x.push_back(i * cells_.dx);
    for (const int j : at.y) lengths.y.push_back(j * cells_.dy);
    const auto parts = medium_->heat_stress(heating, cells_.dx, cells_.dy, z, lengths);
    const std::size_t plane = at.x.size() * at.y.size();
    Field all(places.size() * plane, 0.0);
    for (std::size_t n = 0; n < places.size(); ++n) {
      const Field& table = parts[places[n].component][places[n].flip];
      std::copy(table.begin(), table.end(), all.data() + n * plane);
    }
    return all;
  };
  const Key key{What::heat, Traction::pressure, z, Tensor::full};
  const Field all = tables(band, key, offsets, parities, exact);
  const auto plane = static_cast<std::ptrdiff_t>(offsets.nx) * offsets.ny;
  std::array<ParityParts, 6> stress;
  auto from = all.begin();
  for (const HeatPart& place : places) {
    stress[place.component][place.flip].assign(from, from + plane);
    from += plane;
  }
  return stress;
}

Field BandTables::far_tables(const Split& split, const KernelOffsets& offsets,
                             const Parities& parities, const Exact& exact) const {
  const int step = bands_.far_spacing, kept = nodes_in(middle_.reach(), step);
  const int inner = std::min({kept, offsets.nx, offsets.ny});
  const auto [nx, ny] = offsets;
  CellOffsets at;
  for (int i = 0; i < nx; ++i) at.x.push_back(i * step);
  for (int j = 0; j < ny; ++j) at.y.push_back(j * step);
  Field out = exact(at);
  for (std::size_t c = 0; c < parities.size(); ++c) {
    double* table = out.data() + c * static_cast<std::size_t>(nx) * ny;
    for (int j = 0; j < inner; ++j) {
      std::copy_n(split.far.data() + (c * kept + j) * kept, inner,
                  table + static_cast<std::size_t>(j) * nx);
    }
    // The last offsets occur to empty nodes only.
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const auto fades = [this](int n, int count) {
          return rising(static_cast<double>(count - n) / bands_.fading_nodes);
        };
        table[static_cast<std::size_t>(j) * nx + i] *= fades(i, nx) * fades(j, ny);
      }
    }
  }
  sharpen(Band::far, offsets, fft::good_even_size(2 * nx), fft::good_even_size(2 * ny), parities,
          out);
  return out;
}

class BandMedium : public VolumeMedium {
 public:
  using VolumeMedium::residual_displacement;
  using VolumeMedium::stress;

  BandMedium(Band band, std::shared_ptr<const BandTables> tables)
      : band_(band), tables_(std::move(tables)) {}

  bool is_rigid() const override { return tables_->medium()->is_rigid(); }
  bool operator==(const Medium& other) const override { return this == &other; }

  Field stress(Traction traction, const Grid&, const KernelOffsets& offsets, double z,
               Tensor tensor) const override {
    return tables_->stress(band_, traction, offsets, z, tensor);
  }
  std::array<ParityParts, 6> heat_stress(const Heating& heating, double, double, double z,
                                         const Offsets& offsets) const override {
    const KernelOffsets count(static_cast<int>(offsets.x.size()),
                              static_cast<int>(offsets.y.size()));
    return tables_->heat_stress(band_, heating, count, z);
  }
  int stressed_layers(const Grid& grid) const override {
    return tables_->stressed_layers(band_, grid);
  }
  std::unique_ptr<ResidualStress> residual_stress(const Grid& grid,
                                                  const VolumeTransform& transform,
                                                  const ResidualSettings& settings) const override {
    const double step = tables_->bands().spacing(band_), dx = grid.dx / step, dy = grid.dy / step;
    // A node has the strain of its cells.
    const auto gain = [tables = tables_, band = band_,
                       known = std::make_shared<std::unordered_map<double, double>>()](double k) {
      const auto [at, is_new] = known->try_emplace(k, 0.0);
      if (is_new) at->second = tables->window_gain(band, k);
      return at->second;
    };
    const auto own = [tables = tables_, band = band_, gain, dx, dy, step](double kx, double ky) {
      return tables->share(band, kx * dx, ky * dy) / (gain(kx * dx) * gain(ky * dy) * step * step);
    };
    ResidualSettings of_band = settings;
    of_band.share = own;
    of_band.blends = band_ == Band::near;
    auto whole = tables_->medium()->residual_stress(grid, transform, of_band);
    if (band_ != Band::far) return whole;
    return std::make_unique<ScaledImages>(std::move(whole), own(0.0, 0.0));
  }
  std::unique_ptr<ResidualDisplacement> residual_displacement(
      Axis axis, const Grid& grid, const VolumeTransform& transform, Tensor tensor,
      const ResidualDisplacement* shallower) const override {
    const KernelOffsets offsets(grid, transform.mx(), transform.my());
    const auto layer = [&](int k) {
      return tables_->residual_displacement(band_, axis, offsets, k);
    };
    return std::make_unique<ResidualDisplacement>(
        grid, transform, axis, layer, tables_->strained_layers(band_, grid), tensor, shallower);
  }

 private:
  Band band_;
  std::shared_ptr<const BandTables> tables_;
};

}  // namespace

std::array<SharedMedium, 3> bands_of(const SharedMedium& medium, const Grid& cells,
                                     const BandSplit& split) {
  const auto tables = std::make_shared<const BandTables>(medium, cells, split);
  return {std::make_shared<const BandMedium>(Band::near, tables),
          std::make_shared<const BandMedium>(Band::middle, tables),
          std::make_shared<const BandMedium>(Band::far, tables)};
}

}  // namespace samcontact::operators
