// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fatigue/critical_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "samcontact/base/multiversion.hpp"
#include "samcontact/fatigue/plane_piece.hpp"
#include "samcontact/fatigue/smallest_ball.hpp"

namespace samcontact::fatigue {
namespace {

using std::numbers::pi;
constexpr double none = -std::numeric_limits<double>::infinity();
/// Angle between the initial normals, in both directions. The shear on a plane changes by 1 - cos
/// 2a over the angle a: 4 % if the nearest of them is 8 degrees off.
constexpr double spacing = pi / 16;
/// Relative to the largest amplitude: a plane whose value is lower than the best by less than this
/// may have a better one in its neighbourhood.
constexpr double margin = 0.08;
constexpr int max_starts = 8;  // no two of them neighbours
const double neighbours = std::cos(0.8 * spacing), same = std::cos(0.01);
constexpr double rounding = 1e-10;  // of the largest amplitude

using Six = std::array<double, 6>;

/// Factors of the components of a tensor in a . tensor . b.
Six factors(const Vector& a, const Vector& b) {
  return {a[0] * b[0],
          a[1] * b[1],
          a[2] * b[2],
          a[1] * b[2] + a[2] * b[1],
          a[0] * b[2] + a[2] * b[0],
          a[0] * b[1] + a[1] * b[0]};
}

/// Plane as factors of the shear along both its directions, and of the normal stress.
struct Factors {
  Vector normal;
  Six u, v, n;

  explicit Factors(const Plane& plane)
      : normal(plane.n),
        u(factors(plane.u, plane.n)),
        v(factors(plane.v, plane.n)),
        n(factors(plane.n, plane.n)) {}
};

/// Half of all directions, evenly spaced, including the axes.
std::vector<Factors> first_planes() {
  std::vector<Factors> planes;
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
      planes.emplace_back(Plane(unit({std::sin(polar) * std::cos(azimuth),
                                      std::sin(polar) * std::sin(azimuth), std::cos(polar)})));
    }
  }
  return planes;
}

struct Box {
  std::array<double, 2> centre;
  double half_diagonal;
};

/// Path of two components, and the box around it.
SAMCONTACT_MULTIVERSION
Box project(const double* path, std::size_t row, const Six u, const Six v, double* along,
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
  const double width = high - low, length = right - left;
  return {{(low + high) / 2, (left + right) / 2}, std::sqrt(width * width + length * length) / 2};
}

/// Normal stress at all moments, and its maximum.
SAMCONTACT_MULTIVERSION
double largest(const double* path, std::size_t row, const Six n, double* normal) {
  double maximum = none;
#pragma omp simd reduction(max : maximum)
  for (std::size_t t = 0; t < row; ++t) {
    const double x = n[0] * path[t] + n[1] * path[row + t] + n[2] * path[2 * row + t] +
                     n[3] * path[3 * row + t] + n[4] * path[4 * row + t] + n[5] * path[5 * row + t];
    normal[t] = x;
    maximum = x > maximum ? x : maximum;
  }
  return maximum;
}

struct Found {
  double value;
  Vector normal;
  Holders holders;
};

/// Whether the angle between two planes is less than the angle with the given cosine.
bool are_near(const Vector& a, const Vector& b, double cosine) {
  return std::fabs(dot(a, b)) > cosine;
}

/// Best initial planes in descending order; of neighbouring planes only the best.
class Starts {
 public:
  double best() const { return count_ == 0 ? none : found_[0].value; }
  std::span<const Found> found() const { return {found_.data(), static_cast<std::size_t>(count_)}; }

  /// Whether a plane with this value would be among the best.
  bool accepts(const Vector& normal, double value) const {
    for (const Found& one : found()) {
      if (are_near(one.normal, normal, neighbours)) return one.value < value;
    }
    return count_ < max_starts || found_[max_starts - 1].value < value;
  }

  void insert(const Found& one) {
    if (!accepts(one.normal, one.value)) return;
    int at = 0;
    while (at < count_ && !are_near(found_[at].normal, one.normal, neighbours)) ++at;
    if (at == count_ && count_ < max_starts) ++count_;
    at = std::min(at, count_ - 1);
    found_[at] = one;
    for (; at > 0 && found_[at].value > found_[at - 1].value; --at) {
      std::swap(found_[at], found_[at - 1]);
    }
  }

 private:
  std::array<Found, max_starts> found_{};
  int count_ = 0;
};

/// Search in one cell; `Law` combines the shear amplitude and the maximum normal stress, and
/// increases with both.
template <class Law>
class Search {
 public:
  Search(const std::array<const double*, 2>& path, std::size_t row, double* work, const Law& law)
      : shear_(path[0]), stress_(path[1]), row_(row), work_(work), law_(law) {}

  /// Maximum over all planes; bounds: space for one number for each initial plane.
  Found highest(const std::vector<Factors>& first, std::vector<std::pair<double, int>>& bounds) {
    const Starts starts = scan(first, bounds);
    Found top = starts.found()[0];
    for (const Found& start : starts.found()) {
      if (start.value + reserve() < top.value) break;
      const Found climbed = climb(start, top.value);
      if (climbed.value > top.value) top = climbed;
    }
    return top;
  }

 private:
  /// Margin by which a plane near an initial one may be better.
  double reserve() const { return margin * scale_; }

  Starts scan(const std::vector<Factors>& first, std::vector<std::pair<double, int>>& bounds) {
    bounds.clear();
    for (const Factors& plane : first) {
      bounds.emplace_back(at_most(plane, none), static_cast<int>(bounds.size()));
      scale_ = std::max(scale_, law_(radius_, std::max(normal_, 0.0)));
    }
    std::make_heap(bounds.begin(), bounds.end());
    Starts starts;
    for (auto end = bounds.end(); end != bounds.begin(); --end) {
      const auto [bound, number] = bounds.front();
      const Factors& plane = first[number];
      if (bound < starts.best() - reserve()) break;
      if (starts.accepts(plane.normal, bound)) starts.insert(evaluate(plane, none));
      std::pop_heap(bounds.begin(), end);
    }
    return starts;
  }

  /// Upper bound of the value of a plane. If it is above `threshold`, a closer bound is computed
  /// from the centre that the holders of a nearby plane determine.
  double at_most(const Factors& plane, double threshold, const Holders& near = {}) {
    const Box box = project(shear_, row_, plane.u, plane.v, work_, work_ + row_);
    normal_ = largest(stress_, row_, plane.n, work_ + 3 * row_);
    radius_ = box.half_diagonal;
    if (law_(radius_, normal_) > threshold) {
      std::array<double, 2> centre = near.count == 0 ? box.centre : std::array<double, 2>{};
      for (std::size_t m = 0; m < near.count; ++m) {
        for (std::size_t d = 0; d < 2; ++d) {
          centre[d] += near.weights[m] * work_[d * row_ + near.points[m]];
        }
      }
      square_ = squared_distances(work_, row_, 2, centre.data(), work_ + 2 * row_);
      radius_ = std::sqrt(square_);
    }
    return law_(radius_, normal_);
  }

  /// Value of a plane with its holders; only its upper bound if that is not above `threshold`.
  Found evaluate(const Factors& plane, double threshold, const Holders& near = {}) {
    Found found{at_most(plane, threshold, near), plane.normal, {}};
    if (found.value <= threshold) return found;
    double *squares = work_ + 2 * row_, *normals = work_ + 3 * row_;
    const std::size_t far = std::find(squares, squares + row_, square_) - squares;
    const SmallestBall<2> circle(work_, row_, squares, far);
    found.value = law_(circle.radius(), normal_);
    Holders& holders = found.holders;
    holders.count = circle.held();
    for (std::size_t m = 0; m < holders.count; ++m) {
      holders.points[m] = circle.holder(m);
      holders.weights[m] = circle.weight(m);
    }
    holders.moment = std::find(normals, normals + row_, normal_) - normals;
    return found;
  }

  /// Ascent from the maximum of one piece to the maximum of the next, until a piece contains its
  /// own maximum.
  Found climb_pieces(Found at) {
    for (int round = 0; round < 20; ++round) {
      const Piece piece(at.holders, shear_, stress_, row_);
      const Top top = top_of(piece, law_, at.normal, spacing / 2);
      const Found next = evaluate(Factors(Plane(top.normal)), at.value, at.holders);
      if (!(next.value > at.value)) break;
      at = next;
      if (at.value <= top.value + rounding * scale_) break;
    }
    return at;
  }

  /// Ascent to a maximum. There are many local maxima at the boundaries of pieces: planes around
  /// each are evaluated at decreasing distances.
  Found climb(Found at, double threshold) {
    at = climb_pieces(at);
    if (is_known(at.normal)) return at;
    double rotation = 0.0;  // angle of the hexagon: each lies between the corners of the last one
    for (double step = spacing / 2; step > spacing / 40; step /= 3, rotation += pi / 6) {
      for (int tries = 0; tries < 4; ++tries) {
        if (at.value + reserve() * step / spacing < threshold) return at;
        const Found better = around(at, step, rotation);
        if (!(better.value > at.value)) break;
        at = climb_pieces(better);
        if (is_known(at.normal)) return at;
      }
    }
    tops_[count_++] = at.normal;
    return at;
  }

  /// Whether an earlier ascent has ended at this plane.
  bool is_known(const Vector& normal) const {
    return std::any_of(tops_.begin(), tops_.begin() + count_,
                       [&](const Vector& top) { return are_near(top, normal, same); });
  }

  /// Best of a plane and the six planes around it, in a hexagon rotated by an angle.
  Found around(const Found& at, double step, double rotation) {
    const Plane plane(at.normal);
    const double c = step * std::cos(rotation), s = step * std::sin(rotation);
    Found best = at;
    for (const auto& [x, y] : hexagon) {
      const Factors next(Plane(plane.normal_at(c * x - s * y, s * x + c * y)));
      const Found found = evaluate(next, best.value, at.holders);
      if (found.value > best.value) best = found;
    }
    return best;
  }

  const double *shear_, *stress_;
  std::size_t row_;
  double* work_;
  Law law_;
  double scale_ = 0.0;
  std::array<Vector, max_starts> tops_{};
  int count_ = 0;
  // of the last plane
  double normal_ = 0.0, radius_ = 0.0, square_ = 0.0;
};

template <class Law>
CriticalPlane over_cells(const Paths& shear, const Paths& stress, const Law& law) {
  const std::size_t cells = stress.cells, row = row_length(stress.moments);
  const std::vector<Factors> planes = first_planes();
  CriticalPlane out{Field(cells), Field(3 * cells)};
  for_each_path<2>({shear, stress}, 4, [&](std::size_t cell, const auto& path, double* work) {
    thread_local std::vector<std::pair<double, int>> bounds;
    const Found found = Search(path, row, work, law).highest(planes, bounds);
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
  // The engineering shear strain is twice that of the tensor.
  return over_cells(shear, stress, [k](double amplitude, double normal) {
    return 2 * amplitude * std::max(1 + k * normal, 0.0);
  });
}

}  // namespace samcontact::fatigue
