// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/smooth_continuation.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "samcontact/base/smooth_step.hpp"

namespace samcontact::operators {
namespace {

/// The problem is ill-conditioned by design: the undetermined part is smooth.
constexpr double min_value = 1e-7;
/// Distances at which a table begins to fade out and ends, in widths of the square.
constexpr int fade_start = 2, fade_end = 6;

/// Low-pass filter of a coarse lattice, by the distance in cells.
Eigen::VectorXd low_pass(int factor, int count, double passband_fraction) {
  constexpr int points = 4096;
  const double highest = std::numbers::pi / factor;
  Eigen::VectorXd filter = Eigen::VectorXd::Zero(count);
  for (int n = 0; n < points; ++n) {
    const double part = (n + 0.5) / points, twice_cosine = 2 * std::cos(part * highest);
    const double weight = rising((1 - part) / (1 - passband_fraction)) / (points * factor);
    // Chebyshev's recurrence.
    double before = 0.5 * twice_cosine, cosine = 1.0;
    for (double& sum : filter) {
      sum += weight * cosine;
      before = std::exchange(cosine, twice_cosine * cosine - before);
    }
  }
  return filter;
}

}  // namespace

SmoothContinuation::SmoothContinuation(int factor, int cells, double passband_fraction, int step)
    : cells_(cells), reach_(fade_end * cells), step_(step), fade_(reach_) {
  for (int n = 0; n < reach_; ++n) {
    fade_[n] = rising(static_cast<double>(reach_ - n) / (reach_ - fade_start * cells));
  }
  const double cut = passband_fraction * std::numbers::pi / factor;
  const Eigen::VectorXd filter = low_pass(factor, 2 * reach_, passband_fraction);
  for (const bool odd : {false, true}) {
    axes_[odd] = make_axis(cells, reach_, cut, odd);
    axes_[odd].low = make_low(filter, odd);
  }
}

SmoothContinuation::Axis SmoothContinuation::make_axis(int cells, int reach, double cut, bool odd) {
  const auto sine = [cut](int d) {
    return d == 0 ? cut / std::numbers::pi : std::sin(cut * d) / (std::numbers::pi * d);
  };
  const double sign = odd ? -1.0 : 1.0;
  // Pair at +-n: its normalised value at n, and its multiplicity.
  const auto unit = [&](int n) { return n == 0 ? (odd ? 0.0 : 1.0) : std::sqrt(0.5); };
  Axis axis{{}, {}, Eigen::MatrixXd(cells, reach), Eigen::VectorXd(cells), {}};
  Eigen::MatrixXd sines(cells, cells);
  for (int n = 0; n < cells; ++n) {
    axis.per_unit[n] = unit(n);
    for (int m = 0; m < reach; ++m) {
      const double both = m == 0 ? (odd ? 0.0 : sine(n)) : sine(n - m) + sign * sine(n + m);
      const double weight = n == 0 ? unit(0) : 2 * unit(n);
      axis.seen(n, m) = weight * both;
      if (m < cells) sines(n, m) = weight * both * unit(m);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (sines + sines.transpose()));
  axis.vectors = solver.eigenvectors();
  axis.values = solver.eigenvalues();
  return axis;
}

Eigen::MatrixXd SmoothContinuation::make_low(const Eigen::VectorXd& filter, bool odd) const {
  Eigen::MatrixXd low((reach_ + step_ - 1) / step_, reach_);
  for (int row = 0; row < low.rows(); ++row) {
    const int n = row * step_;
    for (int m = 0; m < reach_; ++m) {
      const double mirrored = m == 0 ? 0.0 : (odd ? -1.0 : 1.0) * filter[n + m];
      low(row, m) = filter[std::abs(n - m)] + mirrored;
    }
  }
  return low;
}

SmoothContinuation::Rows SmoothContinuation::faded(const double* table) const {
  return fade_.asDiagonal() * Eigen::Map<const Rows>(table, reach_, reach_) * fade_.asDiagonal();
}

Field SmoothContinuation::rest(const double* table, kernels::Parity parity) const {
  const Rows whole = faded(table);
  const Eigen::MatrixXd &x = axes_[parity.odd_x].low, &y = axes_[parity.odd_y].low;
  Rows rest = whole(Eigen::seqN(0, y.rows(), step_), Eigen::seqN(0, x.rows(), step_));
  rest -= y * whole * x.transpose();
  return {rest.data(), rest.data() + rest.size()};
}

Field SmoothContinuation::inside(const double* table, kernels::Parity parity) const {
  const Axis &x = axes_[parity.odd_x], &y = axes_[parity.odd_y];
  Rows outside = faded(table);
  outside.topLeftCorner(cells_, cells_).setZero();
  const Eigen::MatrixXd seen = y.seen * outside * x.seen.transpose();
  Eigen::MatrixXd parts = y.vectors.transpose() * seen * x.vectors;
  for (int j = 0; j < cells_; ++j) {
    for (int i = 0; i < cells_; ++i) {
      parts(j, i) /= std::max(1 - y.values[j] * x.values[i], min_value);
    }
  }
  const Rows found =
      y.per_unit.asDiagonal() * y.vectors * parts * x.vectors.transpose() * x.per_unit.asDiagonal();
  return {found.data(), found.data() + found.size()};
}

}  // namespace samcontact::operators
