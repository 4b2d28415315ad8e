// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/setup/yield_scan.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/cells_over.hpp"
#include "samcontact/base/deviator.hpp"

namespace samcontact::simulation {
namespace {

using operators::Tensor;

/// Cells of a level are at most this fraction of the depths for which it is used: the stress of a
/// uniform cell then differs by about a percent from that of the pressure it averages.
constexpr double cells_per_depth = 8.0;
/// Consecutive depths differ by at most this fraction of the depth, or half a cell.
constexpr double depth_step = 0.125;
constexpr int max_scanned_layers = 1'000'000;

Grid coarsened(const Grid& grid, int factor) {
  const auto cells = [factor](int n) { return (n + factor - 1) / factor; };
  Grid coarse(cells(grid.nx), cells(grid.ny), factor * grid.dx, factor * grid.dy);
  coarse.period = {grid.period.x / factor, grid.period.y / factor, grid.period.reference};
  return coarse;
}

std::vector<double> depths(const Grid& grid, const std::vector<LayerRange>& ranges) {
  std::vector<double> z;
  z.reserve(ranges.size());
  for (const LayerRange& range : ranges) z.push_back((range.layer + 0.5) * grid.dz);
  return z;
}

/// Down to a depth of one grid width, or of the grid or the last change of strength if they are
/// deeper.
std::vector<int> scanned_layers(const Grid& grid, const Strength& strength) {
  const double half = 0.5 * std::min(grid.dx, grid.dy);
  const double width = std::max(grid.nx * grid.dx, grid.ny * grid.dy);
  const int wide = std::min(cells_over(width, grid.dz), max_scanned_layers);
  const int graded = strength.is_graded() ? strength.layers() + 1 : 0;
  const int deepest = std::max({grid.nz, wide, graded});
  std::vector<int> layers;
  double next = 0.0;
  for (int k = 0; k < deepest; ++k) {
    const double z = (k + 0.5) * grid.dz;
    const bool far = z >= next || (k < graded && strength.differs(layers.back(), k));
    const bool above = k + 1 < graded && strength.is_interface(k, k + 1);
    if (!far && !above && k + 1 != grid.nz && k + 1 < deepest) continue;
    next = z + std::max(half, depth_step * z);
    layers.push_back(k);
  }
  return layers;
}

/// Layer ranges of a part of the searched layers. A strength that depends on depth represents all
/// layers between the ones above and below.
std::vector<LayerRange> ranges_of(const std::vector<int>& layers, std::size_t begin,
                                  std::size_t end, bool graded) {
  std::vector<LayerRange> ranges;
  for (std::size_t n = begin; n < end; ++n) {
    const int k = layers[n];
    const bool last = n + 1 == (graded ? layers.size() : end);
    ranges.push_back({k, graded && n > 0 ? layers[n - 1] + 1 : k, last ? k + 1 : layers[n + 1]});
  }
  return ranges;
}

std::vector<LayerRange> all_ranges(const Grid& grid, const Strength& strength) {
  const std::vector<int> layers = scanned_layers(grid, strength);
  return ranges_of(layers, 0, layers.size(), strength.is_graded());
}

/// Adds one depth of a deviator [component][k][i][j] of the grid, sampled in the middle of coarser
/// cells; step: numbers between its components.
void add_sampled(const double* fine, std::size_t step, const Grid& grid, const Grid& coarse,
                 int factor, Field& sum) {
  double* to = sum.data();
  const auto middle = [factor](int n, int cells) {
    return std::min(n * factor + factor / 2, cells - 1);
  };
  for (const double* const end = sum.data() + sum.size(); to != end; fine += step) {
    for (int i = 0; i < coarse.nx; ++i) {
      const double* row = fine + static_cast<std::size_t>(middle(i, grid.nx)) * grid.ny;
      for (int j = 0; j < coarse.ny; ++j) *to++ += row[middle(j, grid.ny)];
    }
  }
}

/// Means over factor x factor cells; zero beyond the edges.
Field average(const Field& fine, const Grid& grid, const Grid& coarse, int factor) {
  if (factor == 1) return fine;
  Field means(coarse.surface_size(), 0.0);
  for (int i = 0; i < grid.nx; ++i) {
    double* row = means.data() + static_cast<std::size_t>(i / factor) * coarse.ny;
    const double* from = fine.data() + static_cast<std::size_t>(i) * grid.ny;
    for (int j = 0; j < grid.ny; ++j) row[j / factor] += from[j];
  }
  const double cells = static_cast<double>(factor) * factor;
  for (double& mean : means) mean /= cells;
  return means;
}

}  // namespace

YieldScan::Level::Level(const Grid& fine, int factor_, std::vector<LayerRange> ranges_,
                        const operators::SharedMedium& medium,
                        const std::shared_ptr<const operators::HeatStress>& heat)
    : factor(factor_),
      grid(coarsened(fine, factor_)),
      ranges(std::move(ranges_)),
      transform(grid, operators::Symmetry::none),
      stress(grid, transform, medium, heat, depths(fine, ranges), Tensor::deviator) {}

YieldScan::YieldScan(const Grid& grid, const Strength& strength,
                     const operators::SharedMedium& medium,
                     const std::shared_ptr<const operators::HeatStress>& heat)
    : grid_(grid) {
  const double cell = std::max(grid_.dx, grid_.dy);
  const int widest = std::max(grid_.nx, grid_.ny);
  const std::vector<int> layers = scanned_layers(grid_, strength);
  std::size_t begin = 0;
  int factor = 1;
  const auto flush = [&](std::size_t end) {
    if (begin == end) return;
    const bool lower = grid_.nz > 0 && layers[begin] >= grid_.nz;
    (lower ? below_ : levels_)
        .push_back(std::make_unique<Level>(
            grid_, factor, ranges_of(layers, begin, end, strength.is_graded()), medium, heat));
    begin = end;
  };
  for (std::size_t n = 0; n < layers.size(); ++n) {
    if ((layers[n] + 0.5) * grid_.dz >= 2 * factor * cell * cells_per_depth &&
        4 * factor <= widest && grid_.can_be_coarsened(2 * factor)) {
      flush(n);
      factor *= 2;
    }
    if (layers[n] + 1 == grid_.nz) flush(n + 1);
  }
  flush(layers.size());
}

template <class Use>
void YieldScan::for_beyond(const Level& level, const operators::Tractions& tractions,
                           double shear_sign, const YieldLimit& limit, const Use& use) const {
  const Grid& grid = level.grid;
  const int nz = level.stress.layers();
  const auto coarse = [&](const Field& field) {
    return field.empty() ? Field{} : average(field, grid_, grid, level.factor);
  };
  const auto loads = level.stress.spectra(
      {coarse(tractions.pressure), coarse(tractions.shear_x), coarse(tractions.shear_y)});
  const Field past = limit.past ? limit.past(depths(grid_, level.ranges)) : Field{};
  const std::vector<LayerLimit> limits = limit.of(level.ranges);
  std::vector<int> searched;  // elastic material does not yield
  for (int k = 0; k < nz; ++k) {
    if (limits[k].stress != INFINITY) searched.push_back(k);
  }
  level.stress.prepare(loads, searched);
  const std::size_t plane = grid.surface_size(), all = grid_.surface_size();
  // By depth: cells [i][j].
  std::vector<std::vector<std::uint32_t>> beyond(nz);
#pragma omp parallel
  {
    operators::VolumeSpectrum spectrum(level.transform, 1, Tensor::deviator);
    Field s(5 * plane);
#pragma omp for schedule(dynamic)
    for (const int k : searched) {
      std::ranges::fill(spectrum.data, 0.0);
      level.stress.add_depth(loads, shear_sign, k, spectrum);
      operators::inverse(level.transform, spectrum, 0, s.data());
      if (!past.empty()) {
        add_sampled(past.data() + k * all, nz * all, grid_, grid, level.factor, s);
      }
      const auto [strength, start] = limits[k];
      const double bound = strength > 0 ? strength * strength / 3 : -1.0;
      for (std::size_t at = 0; at < plane; ++at) {
        if (second_invariant(s[at] + start[0], s[plane + at] + start[1], s[2 * plane + at],
                             s[3 * plane + at], s[4 * plane + at] + start[2]) <= bound) {
          continue;
        }
        beyond[k].push_back(static_cast<std::uint32_t>(at));
      }
    }
  }
  for (int k = 0; k < nz; ++k) {
    for (const std::uint32_t at : beyond[k]) {
      const int i0 = static_cast<int>(at / grid.ny) * level.factor;
      const int j0 = static_cast<int>(at % grid.ny) * level.factor;
      // Down to the next searched depth.
      use(Box{i0, j0, std::min(level.factor, grid_.nx - i0), std::min(level.factor, grid_.ny - j0),
              level.ranges[k].end});
    }
  }
}

Box YieldScan::level_box(const Level& level, const operators::Tractions& tractions,
                         double shear_sign, const YieldLimit& limit) const {
  Box found;
  for_beyond(level, tractions, shear_sign, limit,
             [&](const Box& cells) { found = found.united(cells); });
  return found;
}

Box YieldScan::box(const Levels& levels, const operators::Tractions& tractions, double shear_sign,
                   const YieldLimit& limit) const {
  Box found;
  for (const auto& level : levels) {
    found = found.united(level_box(*level, tractions, shear_sign, limit));
  }
  return found;
}

Columns YieldScan::columns(const operators::Tractions& tractions, double shear_sign,
                           const YieldLimit& limit) const {
  Columns columns{Box::surface(grid_), std::vector<int>(grid_.surface_size(), 0)};
  const auto deepen = [&](const Box& cells) {
    for (int i = cells.i0; i < cells.i0 + cells.nx; ++i) {
      for (int j = cells.j0; j < cells.j0 + cells.ny; ++j) {
        int& depth = columns.depth[static_cast<std::size_t>(i) * grid_.ny + j];
        depth = std::max(depth, cells.nz);
      }
    }
  };
  for (const auto* levels : {&levels_, &below_}) {
    for (const auto& level : *levels) for_beyond(*level, tractions, shear_sign, limit, deepen);
  }
  return columns;
}

bool YieldScan::is_beyond_everywhere(const operators::Tractions& tractions, double shear_sign,
                                     const YieldLimit& limit) const {
  if (grid_.period.x == 0 || grid_.period.y == 0) return false;
  // At the depth of one period only the mean of the stress is left.
  const Level& level = below_.empty() ? *levels_.back() : *below_.back();
  const Box found = level_box(level, tractions, shear_sign, limit);
  return found.nz > level.ranges.back().layer && found.surface_size() == grid_.surface_size();
}

std::size_t YieldScan::bytes() const {
  std::size_t bytes = 0;
  for (const auto* levels : {&levels_, &below_}) {
    for (const auto& level : *levels) bytes += level->stress.bytes();
  }
  return bytes;
}

ZoneScan::ZoneScan(const std::shared_ptr<const operators::ZoneTables>& tables,
                   const Strength& strength)
    : tables_(tables),
      grid_(tables->grid()),
      ranges_(all_ranges(grid_, strength)),
      bound_(tables, depths(grid_, ranges_)) {}

bool ZoneScan::resolves(const Strength& strength) const {
  return ranges_ == all_ranges(grid_, strength);
}

Columns ZoneScan::columns(const operators::Tractions& tractions, double shear_sign,
                          const YieldLimit& limit) const {
  const int block = bound_.block();
  const int nx = bound_.blocks_x(), ny = bound_.blocks_y();
  const std::vector<LayerLimit> limits = limit.of(ranges_);
  operators::StressBound::Given given{{}, limit.past};
  for (const LayerLimit& layer : limits) given.start.push_back(layer.start);
  // Indices of blocks, by depth.
  std::vector<std::vector<std::size_t>> beyond(ranges_.size());
  bound_.for_each_depth(tractions, shear_sign, given, [&](int depth, const double* bound) {
    for (std::size_t n = 0; n < static_cast<std::size_t>(nx) * ny; ++n) {
      if (bound[n] > limits[depth].stress) beyond[depth].push_back(n);
    }
  });
  Columns columns{Box::surface(grid_), std::vector<int>(grid_.surface_size(), 0)};
  for (std::size_t d = 0; d < ranges_.size(); ++d) {
    for (const std::size_t n : beyond[d]) {
      const int i0 = static_cast<int>(n / ny) * block, j0 = static_cast<int>(n % ny) * block;
      for (int i = i0; i < std::min(grid_.nx, i0 + block); ++i) {
        for (int j = j0; j < std::min(grid_.ny, j0 + block); ++j) {
          // Down to the next searched depth.
          columns.depth[static_cast<std::size_t>(i) * grid_.ny + j] = ranges_[d].end;
        }
      }
    }
  }
  return columns;
}

}  // namespace samcontact::simulation
