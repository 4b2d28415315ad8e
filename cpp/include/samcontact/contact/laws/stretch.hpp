// SPDX-License-Identifier: GPL-3.0-or-later
// Ellipse of the admissible shears of a cell, as the image of a circle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::contact {

/// Symmetric, positive matrix M with the largest eigenvalue 1. The shear of a cell is M t with
/// |t| <= bound. Its work on a slip w is t . M w, so that in the coordinates t and M w friction has
/// the same strength in all directions, and slip along t is slip along the normal of the ellipse.
struct Stretch {
  double xx = 1.0, xy = 0.0, yy = 1.0;

  /// Ellipse with half-axes in the ratio first : second (both > 0), the first at an angle from x.
  static Stretch ellipse(double first, double second, double angle) {
    const double largest = std::max(first, second);
    const double mean = 0.5 * (first / largest + second / largest);
    const double half = 0.5 * (first / largest - second / largest);
    return {mean + half * std::cos(2 * angle), half * std::sin(2 * angle),
            mean - half * std::cos(2 * angle)};
  }
  /// Whether the ellipse is not a circle.
  bool is_on() const { return *this != Stretch{}; }
  /// Whether the axes of the ellipse are not along x and y.
  bool is_turned() const { return xy != 0; }
  Stretch inverse() const {
    const double determinant = xx * yy - xy * xy;
    return {yy / determinant, -xy / determinant, xx / determinant};
  }
  double x(double vx, double vy) const { return xx * vx + xy * vy; }
  double y(double vx, double vy) const { return xy * vx + yy * vy; }
  /// Length of M v.
  double length(double vx, double vy) const { return std::hypot(x(vx, vy), y(vx, vy)); }

  /// Multiplies the n vectors with these components.
  void apply(double* vx, double* vy, std::size_t n) const {
    if (!is_on()) return;
    for_each_cell(n, [&](std::size_t i) {
      const double turned = x(vx[i], vy[i]);
      vy[i] = y(vx[i], vy[i]);
      vx[i] = turned;
    });
  }
  /// Multiplies all vectors of a field [2][cell].
  void apply(Field& v) const {
    const std::size_t n = v.size() / 2;
    apply(v.data(), v.data() + n, n);
  }

  bool operator==(const Stretch&) const = default;
};

/// Coordinates in which the admissible shears of all cells are circles whose radius is the same
/// function of the pressure.
struct CircleCoordinates {
  Stretch stretch = {};
  Field factor = {};  // of the bound of each cell, > 0; empty: 1

  bool is_on() const { return stretch.is_on() || !factor.empty(); }
  /// Changes shears of these coordinates to shears, and slips to those of these coordinates;
  /// vectors [2][n].
  void apply(double* vectors, std::size_t n) const { multiply(stretch, vectors, n, false); }
  /// Inverse.
  void undo(double* vectors, std::size_t n) const { multiply(stretch.inverse(), vectors, n, true); }

 private:
  void multiply(const Stretch& matrix, double* vectors, std::size_t n, bool divides) const {
    matrix.apply(vectors, vectors + n, n);
    if (factor.empty()) return;
    for_each_cell(n, [&](std::size_t i) {
      const double scale = divides ? 1 / factor[i] : factor[i];
      vectors[i] *= scale;
      vectors[n + i] *= scale;
    });
  }
};

}  // namespace samcontact::contact
