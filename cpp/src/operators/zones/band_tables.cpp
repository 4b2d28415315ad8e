// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/band_tables.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "samcontact/base/smooth_step.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/fft/plan.hpp"

namespace samcontact::operators {
namespace {

using std::numbers::pi;

/// Low-pass filter, 1 at q = 0 and negligible at a fraction of the highest wavenumber of nodes
/// `factor` cells apart: a step smoothed by a Gaussian, even in q, so that the remainder has a
/// short range.
double low_pass(double q, int factor, double cutoff_fraction, double sharpness) {
  const double cutoff = cutoff_fraction * pi / factor, a = sharpness, b = 2 * a / cutoff;
  return (std::erf(a + b * q) + std::erf(a - b * q)) / (2 * std::erf(a));
}

/// Number of nodes within a number of cells.
int nodes_in(int cells, int spacing) { return (cells + spacing - 1) / spacing; }

/// Copies the inner part [j][i] of a square into a table.
void replace(const Field& inside, int cells, double* table, int width) {
  for (int j = 0; j < cells; ++j) {
    std::copy_n(inside.data() + static_cast<std::ptrdiff_t>(j) * cells, cells,
                table + static_cast<std::ptrdiff_t>(j) * width);
  }
}

}  // namespace

double BandTables::window_gain(Band band, double k) const {
  if (band == Band::near) return 1.0;
  double gain = window_(k * bands_.middle_spacing);
  if (band == Band::far) gain *= window_(k * bands_.far_spacing);
  return gain * gain;
}

double BandTables::share(Band band, double kx, double ky) const {
  const double q = std::hypot(kx, ky);
  const auto pass = [&](int spacing, double sharpness) {
    return low_pass(q, spacing, bands_.cutoff_fraction, sharpness);
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
  const Field before = repeated_ ? whole : Field{};
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
  if (repeated_) compare(parities, before, *split);
  const std::lock_guard lock(mutex_);
  return kept_.emplace(key, std::move(split)).first->second;
}

/// Divides tables [component][j][i] at nodes 0..nx - 1, 0..ny - 1 by the factors of their Fourier
/// modes due to the window of a band. mx, my: period.
void BandTables::sharpen(Band band, const KernelOffsets& offsets, int mx, int my,
                         const Parities& parities, Field& tables) const {
  const auto [nx, ny] = offsets;
  const fft::ParitySpectrum spectrum(mx, my);
  const int hx = spectrum.hx(), hy = spectrum.hy();
  const auto factors = [&](int count) {
    Field factor(count);
    for (int n = 0; n < count; ++n) {
      const double part = static_cast<double>(n) / (count - 1);
      const double above = (part - bands_.passband_fraction) / (1 - bands_.passband_fraction);
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
  if (band == Band::far) {
    return repeated_ ? periodic_far_tables(*parts, offsets, parities, key)
                     : far_tables(*parts, offsets, parities, exact);
  }
  const Field& from = band == Band::near ? parts->near : parts->middle;
  const int size =
      band == Band::near ? near_.cells() : nodes_in(near_.reach(), bands_.middle_spacing);
  const std::size_t plane = static_cast<std::size_t>(offsets.nx) * offsets.ny;
  Field out(parities.size() * plane, 0.0);
  for (std::size_t c = 0; c < parities.size(); ++c) {
    if (repeated_ && band == Band::middle) {
      add_folded(from.data() + c * size * size, size, parities[c], offsets, out.data() + c * plane);
      continue;
    }
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
    const auto parts = heat_of(*medium_)->stress(heating, cells_.dx, cells_.dy, z, lengths);
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
    // The last offsets occur between empty nodes only.
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

void BandTables::compare(const Parities& parities, const Field& whole, Split& split) const {
  const int wide = middle_.reach(), step = bands_.far_spacing, kept = nodes_in(wide, step);
  const int near = near_.cells(), middle = nodes_in(near_.reach(), bands_.middle_spacing);
  const double near_share = 1.0 / (step * step),
               middle_share = near_share * bands_.middle_spacing * bands_.middle_spacing;
  split.less = split.far;
  for (std::size_t c = 0; c < parities.size(); ++c) {
    for (int j = 0; j < kept; ++j) {
      for (int i = 0; i < kept; ++i) {
        split.less[(c * kept + j) * kept + i] -=
            whole[(c * wide + static_cast<std::size_t>(j) * step) * wide +
                  static_cast<std::size_t>(i) * step];
      }
    }
    split.held.push_back(
        near_share * total(split.near.data() + c * near * near, near, near, false) +
        middle_share * total(split.middle.data() + c * middle * middle, middle, middle, false));
  }
}

Field BandTables::periodic_far_tables(const Split& split, const KernelOffsets& offsets,
                                      const Parities& parities, const Key& key) const {
  const auto [what, traction, at, tensor] = key;
  const int kept = nodes_in(middle_.reach(), bands_.far_spacing);
  const auto [nx, ny] = offsets;
  const std::size_t plane = static_cast<std::size_t>(nx) * ny;
  if (what == What::heat)
    throw std::logic_error("influence tables of heat require a surface that is not periodic");
  Field out = what == What::stress
                  ? repeated_->stress(traction, at, tensor)
                  : repeated_->residual_displacement(axis_along(traction), static_cast<int>(at));
  for (std::size_t c = 0; c < parities.size(); ++c) {
    double* table = out.data() + c * plane;
    const bool is_even = !parities[c].odd_x && !parities[c].odd_y;
    const double mean = is_even ? total(table, nx, ny, true) - split.held[c] : 0.0;
    add_folded(split.less.data() + c * kept * kept, kept, parities[c], offsets, table);
    if (!is_even) continue;
    const double nodes = 4.0 * (nx - 1) * (ny - 1);
    const double shift = (mean - total(table, nx, ny, true)) / nodes;
    for (std::size_t n = 0; n < plane; ++n) table[n] += shift;
  }
  sharpen(Band::far, offsets, 2 * (nx - 1), 2 * (ny - 1), parities, out);
  return out;
}

}  // namespace samcontact::operators
