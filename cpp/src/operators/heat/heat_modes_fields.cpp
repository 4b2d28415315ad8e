// SPDX-License-Identifier: GPL-3.0-or-later
// Amplitudes of the modes of a field, and fields of given amplitudes.
#include "samcontact/operators/heat/heat_modes.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace samcontact::operators {
namespace {

using std::numbers::pi;
using ComplexMatrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RealMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ComplexView = Eigen::Map<const ComplexMatrix>;
using RealView = Eigen::Map<const RealMatrix>;

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

}  // namespace

void HeatModes::add_points(HeatLevel& level) const {
  const int a = level.reach_a, b = level.reach_b;
  const auto x = cells(transform_.nx(), 1), y = cells(transform_.ny(), cell_y_);
  // Points per shortest wavelength, with a margin.
  const double waves_x = a * level.dw1 * transform_.nx() / (2 * pi);
  const double waves_y = b * level.dw2 * transform_.ny() * cell_y_ / (2 * pi);
  level.points = static_cast<int>(pi * std::max(waves_x, waves_y) + 4 +
                                  0.7 * scales_.sharpness * scales_.sharpness);
  const bool coarse = level.points < std::min(transform_.nx(), transform_.ny());
  const auto px = coarse ? chebyshev(level.points, transform_.nx(), 1) : x;
  const auto py = coarse ? chebyshev(level.points, transform_.ny(), cell_y_) : y;
  if (!coarse) level.points = 0;
  level.cells_x = waves(x, level.dw1, -a, a);
  level.cells_y = waves(y, level.dw2, 0, b);
  level.points_x = waves(px, level.dw1, -a, a);
  level.points_y = waves(py, level.dw2, 0, b);
  if (!coarse) return;
  const int before = levels_.back().points;
  const auto to_x = before > 0 ? chebyshev(before, transform_.nx(), 1) : x;
  const auto to_y = before > 0 ? chebyshev(before, transform_.ny(), cell_y_) : y;
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
    const int a = in_period(mode.a, mx), b = in_period(mode.b, my);
    const Complex value =
        b < mh
            ? spectrum[static_cast<std::size_t>(b) * mx + a]
            : std::conj(spectrum[static_cast<std::size_t>(my - b) * mx + in_period(-mode.a, mx)]);
    *out++ = mode.source * value;
  }
  const RealView q(flux, transform_.nx(), transform_.ny());
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    const HeatLevel& level = levels_[l];
    const ComplexView ex(level.cells_x.data(), 2 * level.reach_a + 1, transform_.nx());
    const ComplexView ey(level.cells_y.data(), level.reach_b + 1, transform_.ny());
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
    const int b = in_period(mode.b, my), minus_b = in_period(-mode.b, my);
    if (b < mh) spectrum[static_cast<std::size_t>(b) * mx + in_period(mode.a, mx)] += value;
    if (mode.b > 0 && minus_b < mh) {
      spectrum[static_cast<std::size_t>(minus_b) * mx + in_period(-mode.a, mx)] += std::conj(value);
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
    const int px = level.points > 0 ? level.points : transform_.nx();
    const int py = level.points > 0 ? level.points : transform_.ny();
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
  Eigen::Map<RealMatrix>(plane, transform_.nx(), transform_.ny()) += sum;
}

}  // namespace samcontact::operators
