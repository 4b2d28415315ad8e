// SPDX-License-Identifier: GPL-3.0-or-later
// What the value of a plane hangs on, and where that alone is largest.
//
// The smallest circle around a path is the largest of those around two or three of its points, so
// that a criterion is the largest of smooth pieces: one for each choice of these points and of the
// moment whose normal stress counts. The top of a piece is nowhere above the criterion.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace samcontact::fatigue {

using Vector = std::array<double, 3>;

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector unit(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

/// A plane: its normal and two directions in it.
struct Plane {
  Vector n, u{}, v{};

  explicit Plane(const Vector& normal);

  /// The normal that lies this far along u and v.
  Vector beside(double x, double y) const {
    Vector out;
    for (int d = 0; d < 3; ++d) out[d] = n[d] + x * u[d] + y * v[d];
    return unit(out);
  }
};

/// Directions 60 degrees apart.
inline constexpr std::array<std::array<double, 2>, 6> hexagon{{{1.0, 0.0},
                                                               {0.5, std::numbers::sqrt3 / 2},
                                                               {-0.5, std::numbers::sqrt3 / 2},
                                                               {-1.0, 0.0},
                                                               {-0.5, -std::numbers::sqrt3 / 2},
                                                               {0.5, -std::numbers::sqrt3 / 2}}};

/// The points that hold the circle around the shear of a plane, their weights in its centre, and
/// the moment of its largest normal stress.
struct Holders {
  std::array<std::size_t, 3> points{};
  std::array<double, 3> weights{};
  std::size_t count = 0, moment = 0;
};

/// Amplitude of the shear and normal stress that holders alone give planes.
class Piece {
 public:
  static constexpr int planes = 8;  // at once
  using Planes = std::array<double, planes>;

  /// Paths [component][row].
  Piece(const Holders& holders, const double* shear, const double* stress, std::size_t row);

  void evaluate(const std::array<Planes, 3>& normals, Planes& amplitude, Planes& normal) const;

 private:
  std::size_t count_;
  std::array<std::array<double, 6>, 3> edges_{};
  std::array<double, 6> stress_{};
};

/// The step, along u and v and up to `reach`, to where a parabola through values of a plane and of
/// six at a distance around it is highest; uphill where it has no top.
std::array<double, 2> step_to_top(const Piece::Planes& values, double distance, double reach);

struct Top {
  double value;
  Vector normal;
};

/// The largest value of a piece near n, which `law` makes of both.
template <class Law>
Top top_of(const Piece& piece, const Law& law, const Vector& n, double reach) {
  constexpr double distance = 2e-3;  // of planes that tell slope and bend [rad]
  constexpr double settled = 1e-5;   // a step that is none [rad]
  double best = -std::numeric_limits<double>::infinity();
  Vector at = n, next = n;
  for (int round = 0; round < 30 && reach > settled; ++round) {
    const Plane plane(next);
    std::array<Piece::Planes, 3> normals;
    Piece::Planes amplitude, normal, values;
    for (int p = 0; p < Piece::planes; ++p) {
      const double far = p < 6 ? distance : 0.0;
      const auto [x, y] = hexagon[p % 6];
      const Vector one = plane.beside(far * x, far * y);
      for (int d = 0; d < 3; ++d) normals[d][p] = one[d];
    }
    piece.evaluate(normals, amplitude, normal);
    for (int p = 0; p < Piece::planes; ++p) values[p] = law(amplitude[p], normal[p]);
    if (!(values[6] > best)) {  // too far
      reach /= 4;
      for (int d = 0; d < 3; ++d) next[d] = 0.75 * at[d] + 0.25 * next[d];
      next = unit(next);
      continue;
    }
    best = values[6];
    at = next;
    const auto [x, y] = step_to_top(values, distance, reach);
    if (std::hypot(x, y) < settled) break;
    next = plane.beside(x, y);
  }
  return {best, at};
}

}  // namespace samcontact::fatigue
