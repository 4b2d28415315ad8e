// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/heat_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "samcontact/base/errors.hpp"
#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/memory.hpp"
#include "samcontact/operators/heat/heat_symbols.hpp"

namespace samcontact::operators {
namespace {

using std::numbers::pi;

/// 1 inside, 0 outside a ring, as a function of the wavenumber times 1/(2 pi) of a distance beyond
/// which the Fourier transform must be below the tolerance.
struct Edge {
  double middle, width;
  explicit Edge(double sharpness) : middle(sharpness * sharpness / pi), width(sharpness / pi) {}
  double inside(double number) const { return 0.5 * std::erfc((number - middle) / width); }
  double end() const { return 2 * middle; }
};

constexpr std::size_t block_size = 256;
/// Slowest rate of a layered body times the longest time.
constexpr double slowest_rate = 0.05;

/// Width of the edge of the part left to NearHeat [1/dx].
constexpr double split_width = 0.6;

/// Properties that all modes share.
struct ModeSource {
  const HeatScales& scales;
  double negligible, cell_y, speed_x, speed_y;
  bool is_layered;

  /// Adds modes whose window is not negligible. cells: number of cells in a period of the lattice.
  template <class Window>
  void add_to(HeatLevel& level, double cutoff, double cells, const Window& window) const {
    for (int b = 0; b <= level.reach_b; ++b) {
      for (int a = -level.reach_a; a <= level.reach_a; ++a) {
        HeatMode mode{a, b, a * level.dw1, b * level.dw2, 0, {}, 0};
        mode.w = std::hypot(mode.w1, mode.w2);
        mode.source = window(mode.w);
        mode.source *= scales.split(mode.w);
        if (mode.w > cutoff || std::abs(mode.source) < negligible) continue;
        mode.decay = {is_layered ? 0.0 : mode.w * mode.w, mode.w1 * speed_x + mode.w2 * speed_y};
        mode.source *= sinc(mode.w1 / 2) * sinc(mode.w2 * cell_y / 2) / cells;
        level.modes.push_back(mode);
      }
    }
  }
};

/// s = scale sinh(theta): integrands have their poles at s = +-i w, w >= scale, where the imaginary
/// part of theta is pi/2.
void add_nodes(HeatLevel& level, const HeatScales& scales, double scale) {
  for (int j = 0; level.s.empty() || level.s.back() < scales.cutoff; ++j) {
    level.s.push_back(scale * std::sinh(j * scales.step));
    level.weight.push_back((j == 0 ? 1 : 2) / pi * scales.step * scale *
                           std::cosh(j * scales.step));
    level.rates.push_back(level.s.back() * level.s.back());
  }
}

}  // namespace

HeatScales::HeatScales(const HeatResolution& resolution, bool is_whole)
    : sharpness(std::sqrt(-std::log(resolution.tolerance))),
      cutoff(sharpness / std::sqrt(resolution.shortest)),
      is_split(!is_whole && cutoff > 1.3 * split_end()),
      // Errors of the sums are exp(-pi^2/(2 step)) on the surface; cosines are resolved unless they
      // are faded out.
      step((resolution.in_depth ? 1.25 : 4.9) / (sharpness * sharpness)) {}

double HeatScales::fade(double sz) const {
  // The omitted end of the integral over s is smooth on the scale of the cosine.
  return 0.5 * std::erfc(sz / (2 * sharpness) - 0.97 * sharpness);
}

double HeatScales::split(double w) const {
  if (!is_split) return 1;
  return 0.5 * std::erfc((w - split_begin) / split_width - sharpness);
}

double HeatScales::split_reach() const { return 2 * sharpness / split_width; }

double HeatScales::split_end() const { return split_begin + 2 * sharpness * split_width; }

HeatModes::HeatModes(const Grid& grid, double speed_x, double speed_y,
                     const HeatResolution& resolution)
    : cell_y_(grid.dy / grid.dx),
      speed_x_(speed_x),
      speed_y_(speed_y),
      is_moving_(speed_x != 0 || speed_y != 0),
      periods_{grid.period.x * 1.0, grid.period.y * cell_y_},
      resolution_(resolution),
      scales_(resolution,
              is_moving_ || periods_.is_on() || resolution.follows() || resolution.is_layered()),
      transform_(padded(grid)) {
  const double mx = transform_.mx(), my = transform_.my() * cell_y_;
  double spread = 128 * std::sqrt(resolution.longest * resolution.contrast);
  if (is_moving_) spread = std::min(spread, 1e4 / std::hypot(speed_x, speed_y));
  // Minimum period of the last disc, in which kernels are not smooth at w = 0: the remaining images
  // decrease with its third power.
  spread = std::max({64 * std::max(mx, my), 64 * resolution.layers, spread});
  if (periods_.is_double()) {
    add_periodic(spread);
    return;
  }
  const double shorter = periods_.x > 0 ? my : periods_.y > 0 ? mx : std::min(mx, my);
  const int last = std::max(1, static_cast<int>(std::ceil(std::log2(spread / shorter))));
  double shrink = 1;
  for (int l = 0; l <= last; ++l, shrink *= 0.5) {
    check_interrupt();
    add_level(l, last, shrink);
  }
}

/// Wavenumbers of a surface that is periodic along x and y; heat of the mean spreads without limit.
void HeatModes::add_periodic(double spread) {
  levels_.emplace_back();
  const double cells = periods_.x * periods_.y / cell_y_;
  const ModeSource source{scales_,  0.1 * resolution_.tolerance, cell_y_, speed_x_,
                          speed_y_, resolution_.is_layered()};
  for (const bool mean : {false, true}) {
    HeatLevel level;
    level.dw1 = 2 * pi / periods_.x;
    level.dw2 = 2 * pi / periods_.y;
    level.generation = std::numeric_limits<double>::infinity();
    const double scale = mean ? 2 * pi / spread : std::min(level.dw1, level.dw2);
    level.reach_a = mean ? 0 : static_cast<int>(scales_.cutoff / level.dw1);
    level.reach_b = mean ? 0 : static_cast<int>(scales_.cutoff / level.dw2);
    require_memory_of(level, scale);
    source.add_to(level, scales_.cutoff, cells,
                  [&](double w) { return (w == 0) == mean ? 1.0 : 0.0; });
    finish(std::move(level), scale);
  }
}

/// Periods of the finest lattice. Rings are round, as kernels are: the same distance, one grid
/// width, is left free along x and y.
fft::PaddedTransform HeatModes::padded(const Grid& grid) const {
  const double x = grid.nx, y = grid.ny * cell_y_;
  const double clear = std::hypot(std::max(x, y), scales_.is_split ? scales_.split_reach() : 0);
  double px = x + clear + resolution_.track[0], py = y + clear + resolution_.track[1];
  if (is_moving_) {
    // As in set_reach().
    const double vx = std::abs(speed_x_), vy = std::abs(speed_y_);
    const bool along_x = vx / x >= vy / y;
    const double kept = 1.5 * ((along_x ? x : y) + clear);
    px += kept * (along_x ? 1 : vx / vy);
    py += kept * (along_x ? vy / vx : 1);
  }
  const auto size = [](int cells, double period, double min_size) {
    if (period > 0) return std::max(cells, 2);
    return fft::convolution_size(cells, 0, static_cast<int>(std::ceil(min_size)));
  };
  return {grid.nx, grid.ny, size(grid.nx, periods_.x, px), size(grid.ny, periods_.y, py / cell_y_)};
}

/// Range of the kernels of a level, and time for which it keeps heat.
void HeatModes::set_reach(HeatLevel& level, double shrink) const {
  const double x = transform_.nx(), y = transform_.ny() * cell_y_;
  const double px = transform_.mx() / shrink, py = transform_.my() * cell_y_ / shrink;
  level.generation = std::numeric_limits<double>::infinity();
  const double free_x = px - x - resolution_.track[0], free_y = py - y - resolution_.track[1];
  level.clear = periods_.x > 0 ? free_y : periods_.y > 0 ? free_x : std::min(free_x, free_y);
  if (is_moving_) {
    // With generations of a path g along the faster direction (in grids): dropped ones have moved 2
    // g >= size + clear, kept ones up to 3 g, and images of these are still clear of the grid.
    const double vx = std::abs(speed_x_), vy = std::abs(speed_y_);
    const bool along_x = vx / x >= vy / y;
    const double size = along_x ? x : y, speed = along_x ? vx : vy;
    // clear <= period - size - 3 g speed ratio, g = (size + clear)/2.
    const auto widest = [size](double period, double extent, double ratio) {
      return (period - extent - 1.5 * size * ratio) / (1 + 1.5 * ratio);
    };
    const double along = widest(px, x, vx / speed), across = widest(py, y, vy / speed);
    level.clear = periods_.x > 0 ? across : periods_.y > 0 ? along : std::min(along, across);
    level.generation = (size + level.clear) / (2 * speed);
  }
  // Where the edge of a ring meets that of the split, their ranges add like those of Gaussians.
  if (scales_.is_split)
    level.clear =
        std::sqrt(level.clear * level.clear - scales_.split_reach() * scales_.split_reach());
}

void HeatModes::add_level(int number, int last, double shrink) {
  HeatLevel level;
  const double mx = transform_.mx(), my = transform_.my();
  const double shrink_x = periods_.x > 0 ? 1 : shrink, shrink_y = periods_.y > 0 ? 1 : shrink;
  const double cells_x = periods_.x > 0 ? periods_.x : mx,
               cells_y = periods_.y > 0 ? periods_.y / cell_y_ : my;
  level.dw1 = 2 * pi / cells_x * shrink_x;
  level.dw2 = 2 * pi / (cells_y * cell_y_) * shrink_y;
  set_reach(level, shrink);
  const Edge edge(scales_.sharpness);
  // The ring begins at the end of that of the previous level, and ends at the beginning of the next
  // one.
  const double before = number == 0 ? 0 : levels_.back().clear / (2 * pi);
  const double here = level.clear / (2 * pi);
  const auto window = [&](double w) {
    const double from = number == 0 ? 1 : edge.inside(w * before);
    return from - (number == last ? 0 : edge.inside(w * here));
  };
  const double cutoff =
      scales_.is_split ? std::min(scales_.cutoff, scales_.split_end()) : scales_.cutoff;
  const double end = number == 0 ? cutoff : std::min(cutoff, edge.end() / before);
  const double scale = (number == last ? 1 : 2) * std::min(level.dw1, level.dw2);
  level.reach_a = static_cast<int>(end / level.dw1);
  level.reach_b = static_cast<int>(end / level.dw2);
  require_memory_of(level, scale);
  const ModeSource source{scales_,  0.1 * resolution_.tolerance, cell_y_, speed_x_,
                          speed_y_, resolution_.is_layered()};
  source.add_to(level, cutoff, cells_x * cells_y / (shrink_x * shrink_y), window);
  finish(std::move(level), scale);
}

/// Completes a level with its modes; scale: lower bound of their wavenumbers other than 0.
void HeatModes::finish(HeatLevel level, double scale) {
  std::stable_sort(level.modes.begin(), level.modes.end(),
                   [](const HeatMode& p, const HeatMode& q) { return p.w < q.w; });
  resolution_.is_layered() ? add_rate_blocks(level) : add_depth_blocks(level, scale);
  mode_count_ += level.modes.size();
  if (!levels_.empty()) add_points(level);
  levels_.push_back(std::move(level));
}

void HeatModes::add_depth_blocks(HeatLevel& level, double scale) {
  add_nodes(level, scales_, scale);
  for (std::size_t first = 0; first < level.modes.size(); first += block_size) {
    const std::size_t count = std::min(block_size, level.modes.size() - first);
    const double w = level.modes[first].w;
    std::size_t nodes = 1;
    while (nodes < level.s.size() && std::hypot(w, level.s[nodes]) <= scales_.cutoff) ++nodes;
    level.blocks.push_back({first, count, nodes, size_, 0});
    size_ += count * nodes;
  }
}

/// Blocks of wavenumbers that differ at most by a factor of two; 0 is a block of its own.
void HeatModes::add_rate_blocks(HeatLevel& level) {
  for (std::size_t first = 0; first < level.modes.size();) {
    const double w = level.modes[first].w;
    std::size_t count = 1;
    while (count < block_size && first + count < level.modes.size() &&
           level.modes[first + count].w <= 2 * w) {
      ++count;
    }
    const double slowest = std::max(w * w, slowest_rate / resolution_.longest);
    const double fastest =
        slowest + 2 * scales_.sharpness * scales_.sharpness / resolution_.shortest;
    const double step = scales_.rate_step();
    const auto nodes = static_cast<std::size_t>(std::ceil(std::log(fastest / slowest) / step)) + 1;
    level.blocks.push_back({first, count, nodes, size_, level.rates.size()});
    for (std::size_t j = 0; j < nodes; ++j) {
      level.rates.push_back(slowest * std::exp(static_cast<double>(j) * step));
    }
    size_ += count * nodes;
    first += count;
  }
}

/// Memory of modes and amplitudes of a level with a half disc or ring of its lattice.
void HeatModes::require_memory_of(const HeatLevel& level, double scale) const {
  const double modes = 0.5 * pi * (level.reach_a + 1.0) * (level.reach_b + 1.0);
  const double nodes =
      1 + (resolution_.is_layered() ? 2 * std::log(2 * scales_.cutoff / scale) / scales_.rate_step()
                                    : std::asinh(scales_.cutoff / scale) / scales_.step);
  // An increment needs those of the previous state and its own.
  const double amplitudes = 2.0 * sizeof(Complex) * (generations() + 1);
  require_memory(modes * (sizeof(HeatMode) + 0.5 * nodes * amplitudes),
                 "the heat history, resolved down to time steps of " +
                     to_short_text(resolution_.shortest) + " dx^2/diffusivity,");
}

}  // namespace samcontact::operators
