// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/face_pair.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

namespace samcontact::operators {
namespace {

using SlabMatrix = Eigen::MatrixXd;

/// Product of wavenumber and distance of the faces above which the reflections vanish: exp(-8) of
/// the load of one face reaches the other. Gauss-Legendre points and weights of [-1, 1].
constexpr double longest_slab_wave = 8.0;
constexpr int wave_count = 6;
constexpr std::array<double, 3> wave_points{0.2386191860831969, 0.6612093864662645,
                                            0.9324695142031521};
constexpr std::array<double, 3> wave_weights{0.4679139345726910, 0.3607615730481386,
                                             0.1713244923791704};
/// Elements: length at the edges over the distance of the faces, element_growth over the face and
/// beyond.
constexpr double first_element = 0.01, element_growth = 1.18, element_growth_beyond = 1.25,
                 element_growth_deep = 1.15;
constexpr int equal_slab_layers = 8;
/// Half-spaces end where a wave has decayed by exp(-8), within these multiples of the distance.
constexpr double least_extent = 2.0, most_extent = 40.0;

std::vector<double> nodes_between_faces() {
  std::vector<double> half{0.0};
  for (double h = first_element; half.back() < 0.5; h *= element_growth)
    half.push_back(half.back() + h);
  const double scale = 0.5 / half.back();
  for (double& y : half) y *= scale;
  std::vector<double> nodes = half;
  for (auto y = half.rbegin() + 1; y != half.rend(); ++y) nodes.push_back(1.0 - *y);
  return nodes;
}

void extend_nodes(std::vector<double>& nodes, double end, double ratio) {
  double h = nodes.back() - nodes[nodes.size() - 2];
  while (nodes.back() < end) nodes.push_back(nodes.back() + (h *= ratio));
}

/// Stiffness of a bilinear element of E = 1 for displacements that are waves along x:
/// u_x sin(q x), u_y cos(q x), u_z cos(q x).
Eigen::Matrix<double, 12, 12> slab_element(double hy, double hz, double q, double nu) {
  Eigen::Matrix<double, 6, 6> law = Eigen::Matrix<double, 6, 6>::Zero();
  const double shear = 0.5 / (1 + nu);
  law.topLeftCorner<3, 3>().setConstant(nu / ((1 + nu) * (1 - 2 * nu)));
  for (int k = 0; k < 3; ++k) {
    law(k, k) += 2 * shear;
    law(k + 3, k + 3) = shear;
  }
  Eigen::Matrix<double, 12, 12> sum = Eigen::Matrix<double, 12, 12>::Zero();
  const double g = 1 / std::numbers::sqrt3;
  for (const double a : {-g, g}) {
    for (const double b : {-g, g}) {
      Eigen::Matrix<double, 6, 12> strain = Eigen::Matrix<double, 6, 12>::Zero();
      for (int n = 0; n < 4; ++n) {
        const double s = n < 2 ? -1 : 1, t = n % 2 == 0 ? -1 : 1;
        const double shape = q * (1 + s * a) * (1 + t * b) / 4;
        const double dy = s * (1 + t * b) / (2 * hy), dz = t * (1 + s * a) / (2 * hz);
        const int x = 3 * n, y = x + 1, z = x + 2;
        strain(0, x) = shape;
        strain(1, y) = dy;
        strain(2, z) = dz;
        strain(3, y) = dz;
        strain(3, z) = dy;
        strain(4, x) = dz;
        strain(4, z) = -shape;
        strain(5, x) = dy;
        strain(5, y) = -shape;
      }
      sum += strain.transpose() * law * strain * (hy * hz / 4);
    }
  }
  return sum;
}

/// Displacement of the nodes [first, first + count) of the top, due to unit forces on them.
SlabMatrix slab_compliance(const std::vector<double>& y, const std::vector<double>& z, int first,
                           int count, bool low_free, bool high_free, double q, double nu) {
  const int ny = static_cast<int>(y.size()), nz = static_cast<int>(z.size());
  const auto fixed = [&](int i, int j) {
    return j == nz - 1 || (i == 0 && !low_free) || (i == ny - 1 && !high_free);
  };
  std::vector<int> number(static_cast<std::size_t>(ny) * nz, -1);
  int unknowns = 0;
  for (int i = 0; i < ny; ++i) {
    for (int j = 0; j < nz; ++j) {
      if (!fixed(i, j)) number[i * nz + j] = 3 * unknowns++;
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i + 1 < ny; ++i) {
    for (int j = 0; j + 1 < nz; ++j) {
      const auto stiffness = slab_element(y[i + 1] - y[i], z[j + 1] - z[j], q, nu);
      std::array<int, 4> at{};
      for (int n = 0; n < 4; ++n) at[n] = number[(i + n / 2) * nz + j + n % 2];
      for (int r = 0; r < 12; ++r) {
        for (int c = 0; c < 12; ++c) {
          if (at[r / 3] < 0 || at[c / 3] < 0) continue;
          entries.emplace_back(at[r / 3] + r % 3, at[c / 3] + c % 3, stiffness(r, c));
        }
      }
    }
  }
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(unknowns);
  Eigen::SparseMatrix<double> all(size, size);
  all.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(all);
  SlabMatrix forces = SlabMatrix::Zero(size, count), found(count, count);
  const auto top = [&](int n) { return number[static_cast<std::size_t>(first + n) * nz] + 2; };
  for (int n = 0; n < count; ++n) forces(top(n), n) = 1.0;
  const SlabMatrix moved = solver.solve(forces);
  for (int n = 0; n < count; ++n) found.row(n) = moved.row(top(n));
  return found;
}

/// Effect of the reflections on a wave of wavenumber q, between faces of unit distance.
SlabMatrix slab_reflections(const std::vector<double>& nodes, double q, double nu) {
  const double extent = std::clamp(8.0 / q, least_extent, most_extent);
  std::vector<double> z;
  for (int n = 0; n <= equal_slab_layers; ++n) z.push_back(n * first_element);
  extend_nodes(z, extent, element_growth_deep);
  std::vector<double> beyond = nodes;
  extend_nodes(beyond, 1.0 + extent, element_growth_beyond);
  const int count = static_cast<int>(nodes.size());
  const int more = static_cast<int>(beyond.size()) - count;
  std::vector<double> endless;
  for (int n = more; n > 0; --n) endless.push_back(1.0 - beyond[count + n - 1]);
  endless.insert(endless.end(), beyond.begin(), beyond.end());
  const SlabMatrix one = slab_compliance(beyond, z, 0, count, true, false, q, nu);
  SlabMatrix sum = slab_compliance(nodes, z, 0, count, true, true, q, nu) +
                   slab_compliance(endless, z, more, count, false, false, q, nu) - one -
                   one.reverse();  // the other face
  sum = 0.5 * (sum + sum.transpose()).eval();
  const Eigen::VectorXd arms = Eigen::Map<const Eigen::VectorXd>(nodes.data(), count).array() - 0.5;
  const double rotation = arms.dot(sum * arms) / std::pow(arms.squaredNorm(), 2);
  const double mean = sum.mean();
  sum -= rotation * arms * arms.transpose();
  return sum.array() - mean;
}

}  // namespace

struct FacePair::Waves {
  std::vector<double> nodes, wavenumbers;
  std::vector<SlabMatrix> effects;  // with the weights of the waves
};

std::shared_ptr<const FacePair::Waves> FacePair::waves_of(double nu) {
  static std::mutex access;
  static std::map<double, std::shared_ptr<const Waves>> known;
  const std::lock_guard lock(access);
  auto& found = known[nu];
  if (found) return found;
  Waves waves{nodes_between_faces(), std::vector<double>(wave_count),
              std::vector<SlabMatrix>(wave_count)};
#pragma omp parallel for schedule(dynamic)
  for (int n = 0; n < wave_count; ++n) {
    const double side = n % 2 == 0 ? -1.0 : 1.0;
    const double q = 0.5 * longest_slab_wave * (1 + side * wave_points[n / 2]);
    const double weight = 0.5 * longest_slab_wave * wave_weights[n / 2] / std::numbers::pi;
    waves.wavenumbers[n] = q;
    waves.effects[n] = weight * slab_reflections(waves.nodes, q, nu);
  }
  return found = std::make_shared<const Waves>(std::move(waves));
}

FacePair::FacePair(const Grid& grid, double low, double high, double nu, double softness)
    : nx_(grid.nx), ny_(grid.ny), waves_(waves_of(nu)) {
  const double length = high - low;
  factor_ = softness * grid.cell_area() / length;
  const std::vector<double>& nodes = waves_->nodes;
  const std::vector<double> y = grid.y(), x = grid.x();
  for (int j = 0; j < ny_; ++j) {
    const double at = (y[j] - low) / length;
    if (at <= 0 || at >= 1) continue;
    const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, at);
    const int node = static_cast<int>(above - nodes.begin()) - 1;
    places_.push_back({j, node, (at - nodes[node]) / (nodes[node + 1] - nodes[node])});
  }
  for (const double q : waves_->wavenumbers) {
    for (const double& place : x) harmonics_.push_back(std::cos(q * place / length));
    for (const double& place : x) harmonics_.push_back(std::sin(q * place / length));
  }
}

void FacePair::add(const double* pressure, double* displacement) const {
  const int count = static_cast<int>(waves_->nodes.size()), waves = 2 * wave_count;
  const Eigen::Map<const SlabMatrix> harmonics(harmonics_.data(), nx_, waves);
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Rows> load(pressure, nx_, ny_);
  Eigen::Map<Rows> moved(displacement, nx_, ny_);
  const SlabMatrix lines = load.transpose() * harmonics;  // [row][wave]
  SlabMatrix forces = SlabMatrix::Zero(count, waves), rows = SlabMatrix::Zero(ny_, waves);
  for (const auto& [row, node, share] : places_) {
    forces.row(node) += (1 - share) * lines.row(row);
    forces.row(node + 1) += share * lines.row(row);
  }
  for (int n = 0; n < wave_count; ++n) {
    const Eigen::Index pair = 2 * static_cast<Eigen::Index>(n);
    forces.middleCols(pair, 2) = (factor_ * waves_->effects[n] * forces.middleCols(pair, 2)).eval();
  }
  for (const auto& [row, node, share] : places_) {
    rows.row(row) = (1 - share) * forces.row(node) + share * forces.row(node + 1);
  }
  moved.noalias() += harmonics * rows.transpose();
}

double FacePair::cost() const { return 4.0 * wave_count * nx_ * ny_; }

}  // namespace samcontact::operators
