// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth pieces of a critical-plane criterion, and the maximum of a piece.
//
// The smallest circle around a path is the largest of the circles around two or three of its
// points. A criterion is therefore the maximum of smooth pieces: one for each choice of these
// points and of the moment of the normal stress. A piece nowhere exceeds the criterion.
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

/// A plane, given by its normal and two directions in the plane.
struct Plane {
  Vector n, u{}, v{};

  explicit Plane(const Vector& normal);

  /// Normal of the plane at the given distances along u and v.
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

/// Points that determine the circle around the shear in a plane, the weights of these points in the
/// centre of the circle, and the moment of the maximum normal stress.
struct Holders {
  std::array<std::size_t, 3> points{};
  std::array<double, 3> weights{};
  std::size_t count = 0, moment = 0;
};

/// Shear amplitude and normal stress of planes, as determined by the holders alone.
class Piece {
 public:
  static constexpr int planes = 8;  // evaluated at once
  using Planes = std::array<double, planes>;

  /// Paths [component][row].
  Piece(const Holders& holders, const double* shear, const double* stress, std::size_t row);

  void evaluate(const std::array<Planes, 3>& normals, Planes& amplitude, Planes& normal) const;

 private:
  std::size_t count_;
  std::array<std::array<double, 6>, 3> edges_{};
  std::array<double, 6> stress_{};
};

/// Step along u and v, of at most `reach`, to the maximum of a parabola through the values in a
/// plane and in six planes at a distance around it; if the parabola has no maximum, a step uphill.
std::array<double, 2> step_to_top(const Piece::Planes& values, double distance, double reach);

struct Top {
  double value;
  Vector normal;
};

/// Maximum near n of a piece, which `law` combines from shear amplitude and normal stress.
template <class Law>
Top top_of(const Piece& piece, const Law& law, const Vector& n, double reach) {
  constexpr double distance = 2e-3;  // between planes for slope and curvature [rad]
  constexpr double settled = 1e-5;   // step that counts as zero [rad]
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
    if (!(values[6] > best)) {  // the step was too long
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
