// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/periodic/lattice_images.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace samcontact::operators {
namespace {

using std::numbers::pi;

/// Relative error of the interpolation.
constexpr double digits = 28.0;

/// Growth of the error of polynomials over -1..1 for a function whose nearest singularities are at
/// x on the real line and at y off it.
double growth(double x, double y) {
  const double beyond = std::max(x, 1.0 + 1e-6);
  return std::min(beyond + std::sqrt(beyond * beyond - 1), y + std::sqrt(1 + y * y));
}

}  // namespace

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

LatticeImages::LatticeImages(LatticeModes modes, Points x, Points y, double subtracted,
                             const LatticeImages* like)
    : modes_(std::move(modes)), x_(std::move(x)), y_(std::move(y)) {
  if (like && like->x_.nodes == x_.nodes && like->modes_.kx == modes_.kx) {
    along_x_ = like->along_x_;
  } else {
    along_x_ = std::make_shared<const Factors>(x_.nodes, modes_.kx, subtracted);
  }
  if (like && like->y_.nodes == y_.nodes && like->modes_.ky == modes_.ky) {
    along_y_ = like->along_y_;
  } else {
    along_y_ = std::make_shared<const Factors>(y_.nodes, modes_.ky, 0.0);
  }
}

LatticeImages LatticeImages::of_cells(const LatticeAxis& x, const LatticeAxis& y,
                                      const LatticeImages* like) {
  const double to_y = (y.near_images + 1) * y.period - y.edge();
  const double to_x = x.period > 0 ? (x.near_images + 1) * x.period - x.edge() : INFINITY;
  const auto beyond = [](double path, double extent) {
    return extent > 0 ? path / extent : INFINITY;
  };
  const double ratio_x = growth(beyond(to_x, x.extent()), beyond(to_y - y.extent(), x.extent()));
  const double ratio_y = growth(beyond(to_y, y.extent()), beyond(to_x - x.extent(), y.extent()));
  return {LatticeModes::of_cells(x, y), Points(x, ratio_x), Points(y, ratio_y), 0.0, like};
}

LatticeImages LatticeImages::of_strips(const LatticeAxis& x) {
  const double ratio = growth(
      ((x.near_images + 1) * x.period - 0.5 * x.d) / std::max(x.extent(), 0.5 * x.d), INFINITY);
  // The singularity of a mode at k = 0 contributes only a constant.
  return {LatticeModes::of_strips(x), Points(x, ratio), Points({}, ratio), 1.0};
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
    const Eigen::MatrixXd at_nodes = (odd_x ? along_x_->odd : along_x_->even) *
                                     waves.row(c).transpose().asDiagonal() *
                                     (odd_y ? along_y_->odd : along_y_->even).transpose();
    Eigen::Map<Eigen::MatrixXd>(table.data() + c * nx * ny, nx, ny) +=
        (odd_x ? x_.odd : x_.even) * at_nodes * (odd_y ? y_.odd : y_.even).transpose();
  }
}

}  // namespace samcontact::operators
