// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/yield_scan.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/deviator.hpp"

namespace samcontact::simulation {
namespace {

using operators::Tensor;

/// Cells of a level are at most this part of the depths that it serves: the stress of a uniform
/// cell then differs by about a percent from that of the pressure it averages.
constexpr double cells_per_depth = 8.0;
/// Depths follow each other by at most this part of the depth, or half a cell.
constexpr double depth_step = 0.125;
constexpr double most_layers = 1e6;

Grid coarsened(const Grid& grid, int factor) {
  const auto cells = [factor](int n) { return (n + factor - 1) / factor; };
  Grid coarse(cells(grid.nx), cells(grid.ny), factor * grid.dx, factor * grid.dy);
  coarse.period = {grid.period.x / factor, grid.period.y / factor, grid.period.reference};
  return coarse;
}

std::vector<double> depths(const Grid& grid, const std::vector<int>& layers) {
  std::vector<double> z;
  z.reserve(layers.size());
  for (const int k : layers) z.push_back((k + 0.5) * grid.dz);
  return z;
}

/// As deep as the window is wide, or the grid if it is deeper.
std::vector<int> scanned_layers(const Grid& grid) {
  const double half = 0.5 * std::min(grid.dx, grid.dy);
  const double width = std::max(grid.nx * grid.dx, grid.ny * grid.dy) / grid.dz;
  const int deepest = std::max(grid.nz, static_cast<int>(std::min(std::ceil(width), most_layers)));
  std::vector<int> layers;
  double next = 0.0;
  for (int k = 0; k < deepest; ++k) {
    const double z = (k + 0.5) * grid.dz;
    if (z < next && k + 1 != grid.nz && k + 1 < deepest) continue;
    next = z + std::max(half, depth_step * z);
    layers.push_back(k);
  }
  return layers;
}

/// Means over factor x factor cells; beyond the border nothing.
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

YieldScan::Level::Level(const Grid& fine, int factor_, std::vector<int> layers_,
                        const operators::SharedMedium& medium,
                        const std::shared_ptr<const operators::HeatStress>& heat)
    : factor(factor_),
      grid(coarsened(fine, factor_)),
      layers(std::move(layers_)),
      transform(grid, operators::Symmetry::none),
      stress(grid, transform, medium, heat, depths(fine, layers), Tensor::deviator) {}

YieldScan::YieldScan(const Scene& scene, int body, const operators::Heating& heating)
    : grid_(scene.grid) {
  const auto heat = scene.heat_stress(body, heating);
  const double cell = std::max(grid_.dx, grid_.dy);
  const int widest = std::max(grid_.nx, grid_.ny);
  std::vector<int> layers;
  int factor = 1;
  const auto flush = [&] {
    if (layers.empty()) return;
    const bool lower = grid_.nz > 0 && layers.front() >= grid_.nz;
    (lower ? below_ : levels_)
        .push_back(
            std::make_unique<Level>(grid_, factor, std::move(layers), scene.media[body], heat));
    layers.clear();
  };
  for (const int k : scanned_layers(grid_)) {
    if ((k + 0.5) * grid_.dz >= 2 * factor * cell * cells_per_depth && 4 * factor <= widest &&
        grid_.can_be_coarsened(2 * factor)) {
      flush();
      factor *= 2;
    }
    layers.push_back(k);
    if (k + 1 == grid_.nz) flush();
  }
  flush();
}

template <class Use>
void YieldScan::for_beyond(const Level& level, const operators::Tractions& tractions,
                           double shear_sign, double limit, const Use& use) const {
  const Grid& grid = level.grid;
  const int nz = level.stress.layers();
  operators::VolumeSpectrum spectrum(level.transform, nz, Tensor::deviator);
  const auto coarse = [&](const Field& field) {
    return field.empty() ? Field{} : average(field, grid_, grid, level.factor);
  };
  level.stress.add(
      {coarse(tractions.pressure), coarse(tractions.shear_x), coarse(tractions.shear_y)},
      shear_sign, spectrum);
  const std::size_t plane = grid.surface_size(), n = plane * nz;
  Field s(5 * n);
  operators::inverse(level.transform, spectrum, s.data());

  const double bound = limit * limit / 3;
  for (int k = 0; k < nz; ++k) {
    for (int i = 0; i < grid.nx; ++i) {
      for (int j = 0; j < grid.ny; ++j) {
        const std::size_t at = k * plane + static_cast<std::size_t>(i) * grid.ny + j;
        if (second_invariant(s[at], s[n + at], s[2 * n + at], s[3 * n + at], s[4 * n + at]) <=
            bound) {
          continue;
        }
        const int i0 = i * level.factor, j0 = j * level.factor;
        // Up to the next depth that is looked at.
        const int below = k + 1 < nz ? level.layers[k + 1] : level.layers[k] + 1;
        use(Box{i0, j0, std::min(level.factor, grid_.nx - i0),
                std::min(level.factor, grid_.ny - j0), below});
      }
    }
  }
}

Box YieldScan::level_box(const Level& level, const operators::Tractions& tractions,
                         double shear_sign, double limit) const {
  Box found;
  for_beyond(level, tractions, shear_sign, limit,
             [&](const Box& cells) { found = found.united(cells); });
  return found;
}

Box YieldScan::box(const Levels& levels, const operators::Tractions& tractions, double shear_sign,
                   double limit) const {
  Box found;
  for (const auto& level : levels) {
    found = found.united(level_box(*level, tractions, shear_sign, limit));
  }
  return found;
}

Columns YieldScan::columns(const operators::Tractions& tractions, double shear_sign,
                           double limit) const {
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
                                     double limit) const {
  if (grid_.period.x == 0 || grid_.period.y == 0) return false;
  // There is nothing but the mean left of the stress at the depth of a period.
  const Level& level = below_.empty() ? *levels_.back() : *below_.back();
  const Box found = level_box(level, tractions, shear_sign, limit);
  return found.nz > level.layers.back() && found.surface_size() == grid_.surface_size();
}

std::size_t YieldScan::bytes() const {
  std::size_t bytes = 0;
  for (const auto* levels : {&levels_, &below_}) {
    for (const auto& level : *levels) bytes += level->stress.bytes();
  }
  return bytes;
}

ZoneScan::ZoneScan(const std::shared_ptr<const operators::ZoneTables>& tables)
    : tables_(tables),
      grid_(tables->grid()),
      layers_(scanned_layers(grid_)),
      bound_(tables, depths(grid_, layers_)) {}

Columns ZoneScan::columns(const operators::Tractions& tractions, double shear_sign,
                          double limit) const {
  constexpr int block = operators::StressBound::block;
  const int nx = bound_.blocks_x(), ny = bound_.blocks_y();
  // Of blocks, by depth.
  std::vector<std::vector<std::size_t>> beyond(layers_.size());
  bound_.for_each_depth(tractions, shear_sign, [&](int depth, const double* bound) {
    for (std::size_t n = 0; n < static_cast<std::size_t>(nx) * ny; ++n) {
      if (bound[n] > limit) beyond[depth].push_back(n);
    }
  });
  Columns columns{Box::surface(grid_), std::vector<int>(grid_.surface_size(), 0)};
  for (std::size_t d = 0; d < layers_.size(); ++d) {
    // Down to the next depth that is looked at.
    const int below = d + 1 < layers_.size() ? layers_[d + 1] : layers_[d] + 1;
    for (const std::size_t n : beyond[d]) {
      const int i0 = static_cast<int>(n / ny) * block, j0 = static_cast<int>(n % ny) * block;
      for (int i = i0; i < std::min(grid_.nx, i0 + block); ++i) {
        for (int j = j0; j < std::min(grid_.ny, j0 + block); ++j) {
          columns.depth[static_cast<std::size_t>(i) * grid_.ny + j] = below;
        }
      }
    }
  }
  return columns;
}

}  // namespace samcontact::simulation
