// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/lattice_images.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "samcontact/kernels/gauss.hpp"

namespace samcontact::operators {
namespace {

constexpr double pi = std::numbers::pi;

/// The window g = erfc((q/q_1 - 1)/s)/2. Its steps are Gaussians: what lies above it reaches as far
/// as reach/(s q_1) and no farther.
constexpr double steepness = 0.2, reach = 10.5, end = 1 + 5.6 * steepness;
/// Of the interpolation.
constexpr double digits = 28.0;

double window(double q) { return 0.5 * std::erfc((q - 1) / steepness); }

/// First wavenumber of short waves, for images at this distance.
double split(double distance) { return reach / (steepness * distance); }

/// Sum over the cell and its images that are added one by one, relative to the cell.
double of_images(double k, const LatticeAxis& axis) {
  double sum = 1.0;
  for (int n = 1; n <= axis.apart; ++n) sum += 2 * std::cos(k * n * axis.period);
  return sum;
}

/// What a cell's length does to a wave, times the length.
double of_cell(double k, double d) { return k == 0 ? d : 2 * std::sin(0.5 * k * d) / k; }

/// Growth of the error of polynomials over -1..1 for a function whose nearest singularities lie at
/// x on the real line and at y beside it.
double growth(double x, double y) {
  const double beyond = std::max(x, 1.0 + 1e-6);
  return std::min(beyond + std::sqrt(beyond * beyond - 1), y + std::sqrt(1 + y * y));
}

}  // namespace

void LatticeImages::Modes::push(double x, double y, double w) {
  if (w == 0) return;
  kx.push_back(x);
  ky.push_back(y);
  weight.push_back(w);
}

LatticeImages::Points::Points(const LatticeAxis& axis, double ratio) {
  if (axis.cells == 1) {
    nodes = {0.0};
    even = Eigen::MatrixXd::Ones(1, 1);
    odd = Eigen::MatrixXd::Zero(1, 1);
    return;
  }
  const int half = static_cast<int>(std::ceil(0.5 * digits / std::log(ratio))) + 2;
  const double extent = axis.extent();
  std::vector<double> weights;
  for (int a = 0; a < half; ++a) {
    const double angle = (2 * a + 1) * pi / (4 * half);
    nodes.push_back(extent * std::cos(angle));
    weights.push_back((a % 2 == 0 ? 1.0 : -1.0) * std::sin(angle));
  }
  even.resize(axis.cells, half);
  odd.resize(axis.cells, half);
  // Barycentric; the node opposite to a has weight +-w_a, as the number of nodes is even.
  for (int i = 0; i < axis.cells; ++i) {
    const double x = i * axis.d;
    double sum = 0.0;
    for (int a = 0; a < half; ++a) {
      const double here = weights[a] / (x - nodes[a]), there = -weights[a] / (x + nodes[a]);
      sum += here + there;
      even(i, a) = here + there;
      odd(i, a) = here - there;
    }
    even.row(i) /= sum;
    odd.row(i) /= sum;
    for (int a = 0; a < half; ++a) {
      if (x != nodes[a]) continue;
      even.row(i).setZero();
      odd.row(i).setZero();
      even(i, a) = odd(i, a) = 1.0;
    }
  }
}

LatticeImages::Factors::Factors(const std::vector<double>& nodes,
                                const std::vector<double>& wavenumbers, double subtracted)
    : even(nodes.size(), wavenumbers.size()), odd(nodes.size(), wavenumbers.size()) {
  for (std::size_t m = 0; m < wavenumbers.size(); ++m) {
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      const double phase = wavenumbers[m] * nodes[a];
      even(a, m) = std::cos(phase) - subtracted;
      odd(a, m) = std::sin(phase);
    }
  }
}

LatticeImages::LatticeImages(Modes modes, Points x, Points y, double subtracted)
    : modes_(std::move(modes)),
      x_(std::move(x)),
      y_(std::move(y)),
      along_x_(x_.nodes, modes_.kx, subtracted),
      along_y_(y_.nodes, modes_.ky, 0.0) {}

void LatticeImages::Modes::add_lattice(const LatticeAxis& x, const LatticeAxis& y, double q1) {
  // Without a period along x, waves that vary along y die out beside the load.
  const double beside = std::max(8 * y.period, 1.1 * y.distance()) + x.d;
  const double period_x = x.period > 0 ? x.period : x.extent() + beside;
  const int nx = static_cast<int>(end * q1 * period_x / (2 * pi));
  const int ny = static_cast<int>(end * q1 * y.period / (2 * pi));
  for (int n = x.period > 0 ? 0 : 1; n <= ny; ++n) {
    for (int m = n == 0 ? 1 : 0; m <= nx; ++m) {
      const double k_x = 2 * pi * m / period_x, k_y = 2 * pi * n / y.period;
      const double twins = (m > 0 ? 2.0 : 1.0) * (n > 0 ? 2.0 : 1.0);
      push(k_x, k_y,
           twins / (period_x * y.period) * window(std::hypot(k_x, k_y) / q1) * of_cell(k_x, x.d) *
               of_cell(k_y, y.d));
    }
  }
}

void LatticeImages::Modes::subtract_integral(const LatticeAxis& x, const LatticeAxis& y,
                                             double q1) {
  const double last = end * q1;
  const double farthest = std::hypot(x.extent() + x.apart * x.period + 0.5 * x.d,
                                     y.extent() + y.apart * y.period + 0.5 * y.d);
  const auto radial = kernels::gauss_legendre(static_cast<int>(0.5 * last * farthest) + 30);
  const int angles = static_cast<int>(0.25 * last * farthest) + 15;
  for (const auto& [at, share] : radial) {
    const double q = last * at;
    for (int a = 0; a < angles; ++a) {
      const double angle = (a + 0.5) * pi / (2 * angles);
      const double k_x = q * std::cos(angle), k_y = q * std::sin(angle);
      push(k_x, k_y,
           -share * last * q / (2 * pi * angles) * window(q / q1) * of_cell(k_x, x.d) *
               of_cell(k_y, y.d) * of_images(k_x, x) * of_images(k_y, y));
    }
  }
}

LatticeImages LatticeImages::of_cells(const LatticeAxis& x, const LatticeAxis& y) {
  const double half_x = 0.5 * x.d, half_y = 0.5 * y.d;
  // To the nearest edge of an image.
  double distance = y.distance() - half_y;
  if (x.period > 0) distance = std::min(distance, x.distance() - half_x);
  const double q1 = split(distance);
  Modes modes;
  modes.add_lattice(x, y, q1);
  modes.subtract_integral(x, y, q1);
  const double to_y = (y.apart + 1) * y.period - half_y;
  const double to_x = x.period > 0 ? (x.apart + 1) * x.period - half_x : INFINITY;
  const auto beyond = [](double way, double extent) {
    return extent > 0 ? way / extent : INFINITY;
  };
  const double ratio_x = growth(beyond(to_x, x.extent()), beyond(to_y - y.extent(), x.extent()));
  const double ratio_y = growth(beyond(to_y, y.extent()), beyond(to_x - x.extent(), y.extent()));
  return {std::move(modes), Points(x, ratio_x), Points(y, ratio_y), 0.0};
}

LatticeImages LatticeImages::of_strips(const LatticeAxis& x) {
  const double q1 = split(std::max(x.distance() - 0.5 * x.d, 0.25 * x.distance()));
  const double last = end * q1;
  Modes modes;
  for (int m = 1; 2 * pi * m / x.period <= last; ++m) {
    const double k = 2 * pi * m / x.period;
    modes.push(k, 0.0, 2 / x.period * window(k / q1) * of_cell(k, x.d));
  }
  const auto rule = kernels::gauss_legendre(static_cast<int>(0.5 * last * (x.extent() + x.d)) + 40);
  for (const auto& [at, share] : rule) {
    const double k = last * at;
    modes.push(k, 0.0, -share * last / pi * window(k / q1) * of_cell(k, x.d));
  }
  const double ratio =
      growth(((x.apart + 1) * x.period - 0.5 * x.d) / std::max(x.extent(), 0.5 * x.d), INFINITY);
  // A wave's own infinity at k = 0 is no more than a constant.
  return {std::move(modes), Points(x, ratio), Points({}, ratio), 1.0};
}

void LatticeImages::add(const Wave& wave, const std::vector<kernels::Parity>& parities,
                        Field& table) const {
  const std::size_t count = parities.size(), modes = modes_.kx.size();
  Eigen::MatrixXd waves(count, modes);
  for (std::size_t m = 0; m < modes; ++m) {
    wave(modes_.kx[m], modes_.ky[m], waves.col(m).data());
    waves.col(m) *= modes_.weight[m];
  }
  const Eigen::Index nx = x_.even.rows(), ny = y_.even.rows();
  for (std::size_t c = 0; c < count; ++c) {
    const auto& [odd_x, odd_y, odd_z] = parities[c];
    const Eigen::MatrixXd at_nodes = (odd_x ? along_x_.odd : along_x_.even) *
                                     waves.row(c).transpose().asDiagonal() *
                                     (odd_y ? along_y_.odd : along_y_.even).transpose();
    Eigen::Map<Eigen::MatrixXd>(table.data() + c * nx * ny, nx, ny) +=
        (odd_x ? x_.odd : x_.even) * at_nodes * (odd_y ? y_.odd : y_.even).transpose();
  }
}

}  // namespace samcontact::operators
