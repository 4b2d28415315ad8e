// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fatigue/critical_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "samcontact/base/multiversion.hpp"
#include "samcontact/fatigue/smallest_ball.hpp"

namespace samcontact::fatigue {
namespace {

using Vector = std::array<double, 3>;
constexpr double pi = std::numbers::pi;
/// Between normals of the first look, along both angles. The shear on a plane changes by 1 - cos 2a
/// over the angle a: 4 % where the nearest of them is 8 degrees off.
constexpr double spacing = pi / 16;
/// Of the largest amplitude: how far below the best a plane may be whose neighbourhood has a better
/// one.
constexpr double margin = 0.08;
constexpr double finest = 4e-4;  // last step of the search [rad]
constexpr int most_starts = 8;

/// A plane: its normal and two directions in it.
struct Plane {
  Vector n, u, v;
};

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector unit(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

Plane plane_of(const Vector& n) {
  const int least = static_cast<int>(
      std::min_element(n.begin(), n.end(),
                       [](double a, double b) { return std::fabs(a) < std::fabs(b); }) -
      n.begin());
  Vector axis{};
  axis[least] = 1.0;
  const Vector u = unit(cross(n, axis));
  return {n, u, cross(n, u)};
}

/// The same plane with its directions turned in it.
Plane turned(const Plane& plane, double angle) {
  Plane out = plane;
  const double c = std::cos(angle), s = std::sin(angle);
  for (int d = 0; d < 3; ++d) {
    out.u[d] = c * plane.u[d] + s * plane.v[d];
    out.v[d] = c * plane.v[d] - s * plane.u[d];
  }
  return out;
}

/// Half of all directions, evenly; the axes are among them.
std::vector<Plane> first_planes() {
  std::vector<Plane> planes;
  const int rings = static_cast<int>(std::lround(pi / 2 / spacing));
  for (int r = 0; r <= rings; ++r) {
    const double polar = r * pi / 2 / rings;
    const bool equator = r == rings;
    // a multiple of four has both axes
    const int whole =
        std::max(1, 4 * static_cast<int>(std::ceil(pi / 2 * std::sin(polar) / spacing)));
    const int count = r == 0 ? 1 : equator ? whole / 2 : whole;
    for (int a = 0; a < count; ++a) {
      const double azimuth = 2 * pi * a / whole;
      planes.push_back(plane_of(unit({std::sin(polar) * std::cos(azimuth),
                                      std::sin(polar) * std::sin(azimuth), std::cos(polar)})));
    }
  }
  return planes;
}

/// Factors of the components of a tensor in a . tensor . b.
std::array<double, 6> factors(const Vector& a, const Vector& b) {
  return {a[0] * b[0],
          a[1] * b[1],
          a[2] * b[2],
          a[1] * b[2] + a[2] * b[1],
          a[0] * b[2] + a[2] * b[0],
          a[0] * b[1] + a[1] * b[0]};
}

struct Box {
  std::array<double, 2> centre;
  double half_diagonal;
};

/// The path of two numbers, and the box around it.
SAMCONTACT_MULTIVERSION
Box project(const double* path, std::size_t row, const double* u, const double* v, double* along,
            double* across) {
  double low = std::numeric_limits<double>::infinity(), high = -low, left = low, right = -low;
#pragma omp simd reduction(min : low, left) reduction(max : high, right)
  for (std::size_t t = 0; t < row; ++t) {
    const double a = path[t], b = path[row + t], c = path[2 * row + t];
    const double d = path[3 * row + t], e = path[4 * row + t], f = path[5 * row + t];
    const double x = u[0] * a + u[1] * b + u[2] * c + u[3] * d + u[4] * e + u[5] * f;
    const double y = v[0] * a + v[1] * b + v[2] * c + v[3] * d + v[4] * e + v[5] * f;
    along[t] = x;
    across[t] = y;
    low = x < low ? x : low;
    high = x > high ? x : high;
    left = y < left ? y : left;
    right = y > right ? y : right;
  }
  return {{(low + high) / 2, (left + right) / 2}, std::hypot(high - low, right - left) / 2};
}

SAMCONTACT_MULTIVERSION
double largest(const double* path, std::size_t row, const double* n) {
  double most = -std::numeric_limits<double>::infinity();
#pragma omp simd reduction(max : most)
  for (std::size_t t = 0; t < row; ++t) {
    const double x = n[0] * path[t] + n[1] * path[row + t] + n[2] * path[2 * row + t] +
                     n[3] * path[3 * row + t] + n[4] * path[4 * row + t] + n[5] * path[5 * row + t];
    most = x > most ? x : most;
  }
  return most;
}

/// What the search asks of one cell; `Law` makes a value of the amplitude of shear and the largest
/// normal stress, and grows with the amplitude.
template <class Law>
class Search {
 public:
  Search(const double* shear, const double* stress, std::size_t row, double* work, const Law& law)
      : shear_(shear), stress_(stress), row_(row), work_(work), law_(law) {}

  /// The value on a plane; where it is not above `least` only what it is at most.
  double value(const Plane& plane, double least) {
    const auto u = factors(plane.u, plane.n), v = factors(plane.v, plane.n);
    const auto n = factors(plane.n, plane.n);
    const Box box = project(shear_, row_, u.data(), v.data(), work_, work_ + row_);
    const double normal = largest(stress_, row_, n.data());
    double most = law_(box.half_diagonal, normal);
    scale_ = std::max(scale_, law_(box.half_diagonal, std::max(normal, 0.0)));
    if (most <= least) return most;
    double* squares = work_ + 2 * row_;
    const double square = squared_distances(work_, row_, 2, box.centre.data(), squares);
    most = law_(std::sqrt(square), normal);
    if (most <= least) return most;
    const std::size_t first = std::find(squares, squares + row_, square) - squares;
    const SmallestBall<2> circle(work_, row_, squares, first);
    return law_(circle.radius(), normal);
  }

  /// How much better one near a plane of the first look may be.
  double reserve() const { return margin * scale_; }

 private:
  const double *shear_, *stress_;
  std::size_t row_;
  double* work_;
  Law law_;
  double scale_ = 0.0;
};

struct Found {
  double value;
  Vector normal;
};

/// The plane where a parabola through the values around another one is highest, not much further
/// than they are; along u and v in their distance.
std::array<double, 2> top_of(double middle, const std::array<double, 6>& around) {
  double mean = 0.0, slope[2] = {}, bend[2] = {};
  for (int side = 0; side < 6; ++side) {
    const double angle = pi / 3 * side, gain = around[side] - middle;
    mean += gain / 6;
    slope[0] += gain * std::cos(angle) / 3;
    slope[1] += gain * std::sin(angle) / 3;
    bend[0] += gain * std::cos(2 * angle) / 3;
    bend[1] += gain * std::sin(2 * angle) / 3;
  }
  // gain = slope . r + r . curvature . r, curvature = [[mean + bend0, bend1], [.., mean - bend0]]
  const double determinant = mean * mean - bend[0] * bend[0] - bend[1] * bend[1];
  if (!(mean < 0 && determinant > 0)) return {0.0, 0.0};
  std::array<double, 2> top{
      -(slope[0] * (mean - bend[0]) - slope[1] * bend[1]) / (2 * determinant),
      -(slope[1] * (mean + bend[0]) - slope[0] * bend[1]) / (2 * determinant)};
  const double length = std::hypot(top[0], top[1]);
  for (double& part : top) part /= std::max(length / 1.5, 1.0);
  return top;
}

/// Uphill from a plane in steps that become shorter; it ends early where it does not come near
/// `least`.
template <class Law>
Found climb(Search<Law>& search, Found at, double least) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  double turn = 0.0;  // of the hexagon: a ridge between two of its planes lies near one of the next
  for (double step = spacing / 2; step > finest; step /= 3, turn += pi / 6) {
    for (int tries = 0; tries < 4; ++tries) {
      const Plane plane = turned(plane_of(at.normal), turn);
      Found best = at;
      const auto look = [&](double x, double y, double enough) {
        Vector n;
        for (int d = 0; d < 3; ++d) n[d] = plane.n[d] + step * (x * plane.u[d] + y * plane.v[d]);
        const Plane next = plane_of(unit(n));
        const double value = search.value(next, enough);
        if (value > best.value) best = {value, next.n};
        return value;
      };
      std::array<double, 6> around;
      for (int side = 0; side < 6; ++side) {
        around[side] = look(std::cos(pi / 3 * side), std::sin(pi / 3 * side), none);
      }
      const bool beside = best.value > at.value;
      const auto [x, y] = top_of(at.value, around);
      if (x != 0 || y != 0) look(x, y, best.value);
      at = best;
      if (!beside) break;
    }
    // what is left to gain shrinks with the step, at a kink too
    if (at.value + search.reserve() * step / spacing < least) break;
  }
  return at;
}

/// The best of the planes looked at first, of neighbours one, in descending order.
class Starts {
 public:
  double best() const {
    return count_ == 0 ? -std::numeric_limits<double>::infinity() : found_[0].value;
  }
  std::span<const Found> found() const { return {found_.data(), static_cast<std::size_t>(count_)}; }

  void offer(const Found& one) {
    int at = 0;
    while (at < count_ && !are_near(found_[at].normal, one.normal)) ++at;
    if (at == count_ && count_ < most_starts) {
      ++count_;
    } else {
      at = std::min(at, most_starts - 1);
      if (found_[at].value >= one.value) return;
    }
    found_[at] = one;
    for (; at > 0 && found_[at].value > found_[at - 1].value; --at) {
      std::swap(found_[at], found_[at - 1]);
    }
  }

 private:
  static bool are_near(const Vector& a, const Vector& b) {
    static const double least = std::cos(1.2 * spacing);
    return std::fabs(dot(a, b)) > least;
  }
  std::array<Found, most_starts> found_{};
  int count_ = 0;
};

template <class Law>
Found highest(Search<Law>& search, const std::vector<Plane>& planes) {
  Starts starts;
  for (const Plane& plane : planes) {
    const double least = starts.best() - search.reserve();
    const double value = search.value(plane, least);
    if (value > least) starts.offer({value, plane.n});
  }
  Found top = starts.found()[0];
  for (const Found& start : starts.found()) {
    if (start.value + search.reserve() < top.value) break;
    const Found climbed = climb(search, start, top.value);
    if (climbed.value > top.value) top = climbed;
  }
  return top;
}

template <class Law>
CriticalPlane over_cells(const Paths& shear, const Paths& stress, const Law& law) {
  const std::size_t cells = stress.cells, row = row_length(stress.moments);
  const std::vector<Plane> planes = first_planes();
  CriticalPlane out{Field(cells), Field(3 * cells)};
  for_each_path<2>({shear, stress}, 3, [&](std::size_t cell, const auto& path, double* work) {
    Search search(path[0], path[1], row, work, law);
    const Found found = highest(search, planes);
    out.value[cell] = found.value;
    for (int d = 0; d < 3; ++d) out.normal[d * cells + cell] = found.normal[d];
  });
  return out;
}

}  // namespace

CriticalPlane findley(const Paths& stress, double k) {
  return over_cells(stress, stress,
                    [k](double amplitude, double normal) { return amplitude + k * normal; });
}

CriticalPlane fatemi_socie(const Paths& shear, const Paths& stress, double k) {
  // The shear strain of engineers is twice that of the tensor.
  return over_cells(shear, stress, [k](double amplitude, double normal) {
    return 2 * amplitude * std::max(1 + k * normal, 0.0);
  });
}

}  // namespace samcontact::fatigue
