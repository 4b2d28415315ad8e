// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/heat_modes.hpp"

#include <Eigen/Core>
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
using ComplexMatrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RealMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ComplexView = Eigen::Map<const ComplexMatrix>;
using RealView = Eigen::Map<const RealMatrix>;

/// 1 inside, 0 outside a ring, as a function of the wavenumber times 1/(2 pi) of a distance beyond
/// which the Fourier transform must be below the tolerance.
struct Edge {
  double middle, width;
  explicit Edge(double sharpness) : middle(sharpness * sharpness / pi), width(sharpness / pi) {}
  double inside(double number) const { return 0.5 * std::erfc((number - middle) / width); }
  double end() const { return 2 * middle; }
};

/// Width of the edge of the part left to NearHeat [1/dx].
constexpr double split_width = 0.6;

std::vector<double> cells(int n, double size) {
  std::vector<double> x(n);
  for (int i = 0; i < n; ++i) x[i] = (i - 0.5 * (n - 1)) * size;
  return x;
}

/// Chebyshev points of the interval that contains the centres of n cells.
std::vector<double> chebyshev(int count, int n, double size) {
  std::vector<double> x(count);
  for (int i = 0; i < count; ++i) {
    x[i] = -0.5 * (n - 1) * size * std::cos(pi * (i + 0.5) / count);
  }
  return x;
}

/// Barycentric interpolation from Chebyshev points, [to][from].
Field interpolation(const std::vector<double>& to, const std::vector<double>& from) {
  const std::size_t n = from.size();
  Field matrix(to.size() * n, 0.0);
  for (std::size_t t = 0; t < to.size(); ++t) {
    double* row = matrix.data() + t * n;
    double sum = 0;
    for (std::size_t f = 0; f < n; ++f) {
      const double gap = to[t] - from[f];
      if (std::abs(gap) <= 1e-14 * std::abs(from[0])) {
        std::fill(row, row + n, 0.0);
        row[f] = sum = 1;
        break;
      }
      row[f] = (f % 2 ? -1 : 1) * std::sin(pi * (f + 0.5) / n) / gap;
      sum += row[f];
    }
    for (std::size_t f = 0; f < n; ++f) row[f] /= sum;
  }
  return matrix;
}

/// exp(i number dw x) for numbers from `first` to `last`, [number][point].
ComplexField waves(const std::vector<double>& x, double dw, int first, int last) {
  ComplexField out;
  out.reserve((last - first + 1) * x.size());
  for (int a = first; a <= last; ++a) {
    for (const double v : x) out.push_back(std::polar(1.0, a * dw * v));
  }
  return out;
}

int wrapped(int number, int m) { return ((number % m) + m) % m; }

/// Properties that all modes share.
struct ModeSource {
  const HeatScales& scales;
  double negligible, cell_y, speed_x, speed_y;

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
        mode.decay = {mode.w * mode.w, mode.w1 * speed_x + mode.w2 * speed_y};
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
  }
}

}  // namespace

HeatScales::HeatScales(const HeatResolution& resolution, bool moves)
    : sharpness(std::sqrt(-std::log(resolution.tolerance))),
      cutoff(sharpness / std::sqrt(resolution.shortest)),
      is_split(!moves && cutoff > 1.3 * split_end()),
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
      periods_{grid.period.x * 1.0, grid.period.y * cell_y_},
      resolution_(resolution),
      scales_(resolution, moving() || periods_.is_on() || resolution.track > 0),
      transform_(padded(grid)) {
  const double mx = transform_.mx(), my = transform_.my() * cell_y_;
  double spread = 128 * std::sqrt(resolution.longest);
  if (moving()) spread = std::min(spread, 1e4 / std::hypot(speed_x, speed_y));
  // Minimum period of the last disc, in which kernels are not smooth at w = 0: the remaining images
  // decrease with its third power.
  spread = std::max(64 * std::max(mx, my), spread);
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
  const ModeSource source{scales_, 0.1 * resolution_.tolerance, cell_y_, speed_x_, speed_y_};
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
  double px = x + clear + resolution_.track, py = y + clear;
  if (moving()) {
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
  const double x = nx(), y = ny() * cell_y_;
  const double px = transform_.mx() / shrink, py = transform_.my() * cell_y_ / shrink;
  level.generation = std::numeric_limits<double>::infinity();
  const double free_x = px - x - resolution_.track, free_y = py - y;
  level.clear = periods_.x > 0 ? free_y : periods_.y > 0 ? free_x : std::min(free_x, free_y);
  if (moving()) {
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
  const ModeSource source{scales_, 0.1 * resolution_.tolerance, cell_y_, speed_x_, speed_y_};
  source.add_to(level, cutoff, cells_x * cells_y / (shrink_x * shrink_y), window);
  finish(std::move(level), scale);
}

/// Completes a level with its modes; scale: lower bound of their wavenumbers other than 0.
void HeatModes::finish(HeatLevel level, double scale) {
  std::stable_sort(level.modes.begin(), level.modes.end(),
                   [](const HeatMode& p, const HeatMode& q) { return p.w < q.w; });
  add_nodes(level, scales_, scale);
  constexpr std::size_t block = 256;
  for (std::size_t first = 0; first < level.modes.size(); first += block) {
    const std::size_t count = std::min(block, level.modes.size() - first);
    const double w = level.modes[first].w;
    std::size_t nodes = 1;
    while (nodes < level.s.size() && std::hypot(w, level.s[nodes]) <= scales_.cutoff) ++nodes;
    level.blocks.push_back({first, count, nodes, size_});
    size_ += count * nodes;
  }
  mode_count_ += level.modes.size();
  if (!levels_.empty()) add_points(level);
  levels_.push_back(std::move(level));
}

/// Memory of modes and amplitudes of a level with a half disc or ring of its lattice.
void HeatModes::require_memory_of(const HeatLevel& level, double scale) const {
  const double modes = 0.5 * pi * (level.reach_a + 1.0) * (level.reach_b + 1.0);
  const double nodes = 1 + std::asinh(scales_.cutoff / scale) / scales_.step;
  // An increment needs those of the previous state and its own.
  const double amplitudes = 2.0 * sizeof(Complex) * (generations() + 1);
  require_memory(modes * (sizeof(HeatMode) + 0.5 * nodes * amplitudes),
                 "the heat history, resolved down to time steps of " +
                     to_short_text(resolution_.shortest) + " dx^2/diffusivity,");
}

void HeatModes::add_points(HeatLevel& level) const {
  const int a = level.reach_a, b = level.reach_b;
  const auto x = cells(nx(), 1), y = cells(ny(), cell_y_);
  // Points per shortest wavelength, with a margin.
  const double waves_x = a * level.dw1 * nx() / (2 * pi);
  const double waves_y = b * level.dw2 * ny() * cell_y_ / (2 * pi);
  level.points = static_cast<int>(pi * std::max(waves_x, waves_y) + 4 +
                                  0.7 * scales_.sharpness * scales_.sharpness);
  const bool coarse = level.points < std::min(nx(), ny());
  const auto px = coarse ? chebyshev(level.points, nx(), 1) : x;
  const auto py = coarse ? chebyshev(level.points, ny(), cell_y_) : y;
  if (!coarse) level.points = 0;
  level.cells_x = waves(x, level.dw1, -a, a);
  level.cells_y = waves(y, level.dw2, 0, b);
  level.points_x = waves(px, level.dw1, -a, a);
  level.points_y = waves(py, level.dw2, 0, b);
  if (!coarse) return;
  const int before = levels_.back().points;
  const auto to_x = before > 0 ? chebyshev(before, nx(), 1) : x;
  const auto to_y = before > 0 ? chebyshev(before, ny(), cell_y_) : y;
  level.refine_x = interpolation(to_x, px);
  level.refine_y = interpolation(to_y, py);
}

void HeatModes::project(const double* flux, ComplexField& amplitudes) const {
  amplitudes.resize(mode_count_);
  const int mx = transform_.mx(), my = transform_.my(), mh = transform_.mh();
  ComplexField spectrum(transform_.spectrum_size());
  transform_.forward(flux, spectrum.data(), mx, fft::PaddedTransform::Threads::many);
  Complex* out = amplitudes.data();
  for (const HeatMode& mode : levels_[0].modes) {
    const int a = wrapped(mode.a, mx), b = wrapped(mode.b, my);
    const Complex value =
        b < mh ? spectrum[static_cast<std::size_t>(b) * mx + a]
               : std::conj(spectrum[static_cast<std::size_t>(my - b) * mx + wrapped(-mode.a, mx)]);
    *out++ = mode.source * value;
  }
  const RealView q(flux, nx(), ny());
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    const HeatLevel& level = levels_[l];
    const ComplexView ex(level.cells_x.data(), 2 * level.reach_a + 1, nx());
    const ComplexView ey(level.cells_y.data(), level.reach_b + 1, ny());
    const ComplexMatrix along_y = q.cast<Complex>() * ey.adjoint();  // [i][b]
    const ComplexMatrix both = ex.conjugate() * along_y;             // [a][b]
    for (const HeatMode& mode : level.modes) {
      *out++ = mode.source * both(mode.a + level.reach_a, mode.b);
    }
  }
}

void HeatModes::evaluate(const Complex* amplitudes, double* plane) const {
  const int mx = transform_.mx(), my = transform_.my(), mh = transform_.mh();
  ComplexField spectrum(transform_.spectrum_size(), Complex{});
  for (const HeatMode& mode : levels_[0].modes) {
    const Complex value = *amplitudes++;
    const int b = wrapped(mode.b, my), minus_b = wrapped(-mode.b, my);
    if (b < mh) spectrum[static_cast<std::size_t>(b) * mx + wrapped(mode.a, mx)] += value;
    if (mode.b > 0 && minus_b < mh) {
      spectrum[static_cast<std::size_t>(minus_b) * mx + wrapped(-mode.a, mx)] += std::conj(value);
    }
  }
  transform_.inverse(spectrum.data(), plane, mx, fft::PaddedTransform::Threads::one);
  // From the smoothest fields to the finest: each is refined and added to the next.
  RealMatrix sum;
  const auto refine = [&](const HeatLevel& from) {
    const Eigen::Index nx_to = static_cast<Eigen::Index>(from.refine_x.size()) / from.points;
    const Eigen::Index ny_to = static_cast<Eigen::Index>(from.refine_y.size()) / from.points;
    const RealMatrix half = RealView(from.refine_x.data(), nx_to, from.points) * sum;
    sum = half * RealView(from.refine_y.data(), ny_to, from.points).transpose();
  };
  std::vector<const Complex*> starts;
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    starts.push_back(amplitudes);
    amplitudes += levels_[l].modes.size();
  }
  for (std::size_t l = levels_.size() - 1; l > 0; --l) {
    const HeatLevel& level = levels_[l];
    const int width = 2 * level.reach_a + 1, height = level.reach_b + 1;
    const int px = level.points > 0 ? level.points : nx();
    const int py = level.points > 0 ? level.points : ny();
    ComplexMatrix dense = ComplexMatrix::Zero(width, height);
    const Complex* from = starts[l - 1];
    for (const HeatMode& mode : level.modes) {
      dense(mode.a + level.reach_a, mode.b) = (mode.b > 0 ? 2.0 : 1.0) * *from++;
    }
    const ComplexView ex(level.points_x.data(), width, px), ey(level.points_y.data(), height, py);
    const ComplexMatrix along_x = ex.transpose() * dense;  // [point][b]
    const RealMatrix here = along_x.real() * ey.real() - along_x.imag() * ey.imag();
    if (l + 1 == levels_.size()) {
      sum = here;
    } else {
      if (levels_[l + 1].points > 0 && levels_[l + 1].points != level.points) {
        refine(levels_[l + 1]);
      }
      sum += here;
    }
  }
  if (levels_[1].points > 0) refine(levels_[1]);
  Eigen::Map<RealMatrix>(plane, nx(), ny()) += sum;
}

}  // namespace samcontact::operators
