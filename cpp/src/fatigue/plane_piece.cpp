// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fatigue/plane_piece.hpp"

#include "samcontact/base/multiversion.hpp"

namespace samcontact::fatigue {
namespace {

/// Squares of the shear of a tensor on planes.
SAMCONTACT_MULTIVERSION
void squared_shear(const double* t, const Piece::Planes* n, double* square) {
#pragma omp simd
  for (int p = 0; p < Piece::planes; ++p) {
    const double x = n[0][p], y = n[1][p], z = n[2][p];
    const double a = t[0] * x + t[5] * y + t[4] * z;
    const double b = t[5] * x + t[1] * y + t[3] * z;
    const double c = t[4] * x + t[3] * y + t[2] * z;
    const double normal = a * x + b * y + c * z;
    const double left = a * a + b * b + c * c - normal * normal;
    square[p] = left > 0 ? left : 0.0;
  }
}

/// Radius of the smallest circle around three points whose distances have these squares.
double radius_of(double a, double b, double c) {
  const double longest = std::max({a, b, c}), others = a + b + c - longest;
  if (longest >= others) return std::sqrt(longest) / 2;
  const double area = 4 * (a * b + b * c + c * a) - (a + b + c) * (a + b + c);
  return std::sqrt(a * b * c / area);  // area: sixteen times its square
}

}  // namespace

// T. Duff et al. (2017), J. Comput. Graph. Tech. 6(1), 1-8: without a square root.
Plane::Plane(const Vector& normal) : n(normal) {
  const double sign = std::copysign(1.0, n[2]), a = -1 / (sign + n[2]), b = n[0] * n[1] * a;
  u = {1 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]};
  v = {b, sign + n[1] * n[1] * a, -n[1]};
}

Piece::Piece(const Holders& holders, const double* shear, const double* stress, std::size_t row)
    : count_(holders.count) {
  for (std::size_t c = 0; c < 6; ++c) {
    const double* part = shear + c * row;
    for (std::size_t e = 0; e < 3; ++e) {
      edges_[e][c] = part[holders.points[e]] - part[holders.points[(e + 1) % 3]];
    }
    stress_[c] = stress[c * row + holders.moment];
  }
}

void Piece::evaluate(const std::array<Planes, 3>& normals, Planes& amplitude,
                     Planes& normal) const {
  const std::size_t edges = count_ == 3 ? 3 : count_ - 1;
  Planes squares[3]{};
  for (std::size_t e = 0; e < edges; ++e) {
    squared_shear(edges_[e].data(), normals.data(), squares[e].data());
  }
  for (int p = 0; p < planes; ++p) {
    const double x = normals[0][p], y = normals[1][p], z = normals[2][p];
    normal[p] = x * (stress_[0] * x + 2 * (stress_[5] * y + stress_[4] * z)) +
                y * (stress_[1] * y + 2 * stress_[3] * z) + z * stress_[2] * z;
    amplitude[p] = edges == 3 ? radius_of(squares[0][p], squares[1][p], squares[2][p])
                              : std::sqrt(squares[0][p]) / 2;
  }
}

std::array<double, 2> step_to_top(const Piece::Planes& values, double distance, double reach) {
  double mean = 0.0, slope[2] = {}, bend[2] = {};
  for (int side = 0; side < 6; ++side) {
    const double gain = values[side] - values[6];
    mean += gain / 6;
    for (int d = 0; d < 2; ++d) {
      slope[d] += gain * hexagon[side][d] / 3;
      bend[d] += gain * hexagon[2 * side % 6][d] / 3;  // at twice the angle
    }
  }
  // gain = slope . r + r . curvature . r, curvature = [[mean + bend0, bend1], [.., mean - bend0]]
  const double determinant = mean * mean - bend[0] * bend[0] - bend[1] * bend[1];
  const bool has_top = mean < 0 && determinant > 0;
  std::array<double, 2> step{slope[0], slope[1]};
  if (has_top) {
    step = {-(slope[0] * (mean - bend[0]) - slope[1] * bend[1]) / (2 * determinant),
            -(slope[1] * (mean + bend[0]) - slope[0] * bend[1]) / (2 * determinant)};
  }
  const double length = std::hypot(step[0], step[1]) * distance;
  const double scale = has_top && length <= reach ? distance
                       : length > 0               ? distance * reach / length
                                                  : 0.0;
  return {step[0] * scale, step[1] * scale};
}

}  // namespace samcontact::fatigue
