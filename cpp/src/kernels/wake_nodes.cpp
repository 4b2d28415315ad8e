// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/wake_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "samcontact/kernels/gauss.hpp"

namespace samcontact::kernels::wake {
namespace {

constexpr int many_nodes = 16, few_nodes = 8;
/// Points of an octave: the error is 5.8 to minus this power for a singularity at zero.
constexpr int octave_points = 16;

/// Interpolates an octave from Chebyshev points if it has more nodes than these.
void sample(Octave& octave, double bottom, double top) {
  if (octave.nodes.size() <= octave_points) {
    for (const Node& node : octave.nodes) octave.points.push_back(node.k);
    return;
  }
  std::vector<double> weights;
  for (int p = 0; p < octave_points; ++p) {
    const double angle = std::numbers::pi * (p + 0.5) / octave_points;
    octave.points.push_back(0.5 * (bottom + top) + 0.5 * (top - bottom) * std::cos(angle));
    weights.push_back((p % 2 == 0 ? 1.0 : -1.0) * std::sin(angle));
  }
  octave.basis.setZero(static_cast<Eigen::Index>(octave.nodes.size()), octave_points);
  for (Eigen::Index n = 0; n < octave.basis.rows(); ++n) {
    auto row = octave.basis.row(n);
    for (int p = 0; p < octave_points; ++p) {
      const double distance = octave.nodes[n].k - octave.points[p];
      if (distance == 0) {
        row.setZero();
        row[p] = 1.0;
        break;
      }
      row[p] = weights[p] / distance;
    }
    row /= row.sum();
  }
}

}  // namespace

std::vector<Node> graded_nodes(double highest, double widest, double narrow, double finest) {
  static const auto many = gauss_legendre(many_nodes), few = gauss_legendre(few_nodes);
  std::vector<Node> nodes;
  for (double top = highest; top > 0;) {
    const double bottom = std::max(top > finest ? 0.5 * top : 0.0, top - widest);
    const double width = top - bottom;
    for (const auto& [at, weight] : width > narrow ? many : few) {
      nodes.push_back({bottom + width * at, width * weight});
    }
    top = bottom;
  }
  return nodes;
}

std::vector<Octave> octaves(double highest, double widest, double narrow, double finest) {
  auto nodes = graded_nodes(highest, widest, narrow, finest);
  std::ranges::stable_sort(nodes, std::ranges::greater{}, &Node::k);
  std::vector<Octave> all;
  double top = highest;
  for (std::size_t n = 0; n < nodes.size(); top *= 0.5) {
    const double bottom = top > finest ? 0.5 * top : 0.0;
    Octave octave;
    for (; n < nodes.size() && nodes[n].k >= bottom; ++n) octave.nodes.push_back(nodes[n]);
    if (octave.nodes.empty()) continue;
    sample(octave, bottom, top);
    all.push_back(std::move(octave));
  }
  return all;
}

Eigen::MatrixXd power_table(const std::vector<double>& offsets, double extent, int first) {
  // Real parts of i^n (cosine, sine) times powers: signs alternate in pairs.
  Eigen::MatrixXd all =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(offsets.size()), power_count);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    for (int n = first; n < power_count; n += 2) {
      const double sign = n % 4 < 2 ? 1.0 : -1.0;
      all(static_cast<Eigen::Index>(i), n) = sign * std::pow(offsets[i] / extent, n);
    }
  }
  return all;
}

}  // namespace samcontact::kernels::wake
