// SPDX-License-Identifier: GPL-3.0-or-later
// Smallest ball around points in a few dimensions, exact to rounding.
//
// The point farthest from the centre is included until no point is outside, as in Welzl (1991,
// doi:10.1007/BFb0038202) with the pivots of Gaertner (1999, doi:10.1007/3-540-48481-7_29).
// Including a point is a step of the dual active set method of Goldfarb and Idnani (1983,
// doi:10.1007/BF02591962): the centre moves perpendicular to the flat through the points that
// determine the ball, and releases points whose weight in it becomes zero. The radius grows with
// every point, which ends the search; coincident or coplanar points need no special treatment.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace samcontact::fatigue {

/// Squares of the distances of points [dimensions][count] from a centre; returns the largest.
double squared_distances(const double* points, std::size_t count, int dimensions,
                         const double* centre, double* squares);

template <int D>
class SmallestBall {
 public:
  using Point = std::array<double, D>;

  /// points: [D][count], count >= 1; work: `count` numbers; first: initial point, preferably one on
  /// the boundary.
  SmallestBall(const double* points, std::size_t count, double* work, std::size_t first = 0)
      : points_(points), count_(count), squares_(work) {
    take(first);
    double largest = squared_distances(points, count, D, centre_.data(), squares_);
    // With exact arithmetic the search would end earlier; rounding could make it cycle.
    for (int round = 0; round < 200; ++round) {
      const double held = std::sqrt(square(held_[0], centre_));
      if (!(std::sqrt(largest) > held * (1 + 1e-14) + rounding())) break;
      const std::size_t far = std::find(squares_, squares_ + count_, largest) - squares_;
      const bool taken = take_in(far);
      largest = squared_distances(points, count, D, centre_.data(), squares_);
      if (!taken) break;
    }
    radius_ = std::sqrt(largest);
  }

  const Point& centre() const { return centre_; }
  /// Radius of the ball; all points are within it.
  double radius() const { return radius_; }
  /// Number of points on the boundary that determine the ball, indices of these points, and their
  /// weights in the centre.
  std::size_t held() const { return static_cast<std::size_t>(size_); }
  std::size_t holder(std::size_t m) const { return holders_[m]; }
  double weight(std::size_t m) const { return weight_[m]; }

 private:
  /// Starts from a ball of one point.
  void take(std::size_t n) {
    held_[0] = centre_ = point(n);
    holders_[0] = n;
    weight_[0] = 1.0;
    size_ = 1;
  }

  /// Rounding error of distances, for points far from the origin.
  double rounding() const {
    double size = 0.0;
    for (const double c : centre_) size = std::max(size, std::fabs(c));
    return 4 * std::numeric_limits<double>::epsilon() * size;
  }

  Point point(std::size_t n) const {
    Point p;
    for (int d = 0; d < D; ++d) p[d] = points_[d * count_ + n];
    return p;
  }

  static double dot(const Point& a, const Point& b) {
    double sum = 0.0;
    for (int d = 0; d < D; ++d) sum += a[d] * b[d];
    return sum;
  }
  static Point minus(const Point& a, const Point& b) {
    Point c;
    for (int d = 0; d < D; ++d) c[d] = a[d] - b[d];
    return c;
  }
  static double square(const Point& a, const Point& b) {
    const Point c = minus(a, b);
    return dot(c, c);
  }

  struct Foot {
    Point normal;                     // from the flat through the holders to q
    std::array<double, D + 2> share;  // of each holder in the foot of q on the flat
  };
  /// Orthogonalised twice: the remainder of a nearly dependent vector is then perpendicular too.
  Foot foot_of(const Point& q) const {
    Foot foot{};
    std::array<Point, D + 1> basis;
    std::array<std::array<double, D + 2>, D + 2> triangle{};
    for (int m = 1; m <= size_; ++m) {
      Point left = minus(m < size_ ? held_[m] : q, held_[0]);
      for (int pass = 0; pass < 2; ++pass) {
        for (int b = 1; b < m; ++b) {
          const double part = dot(basis[b - 1], left);
          triangle[b][m] += part;
          for (int d = 0; d < D; ++d) left[d] -= part * basis[b - 1][d];
        }
      }
      if (m == size_) {
        foot.normal = left;
        break;
      }
      const double norm = std::sqrt(dot(left, left));
      triangle[m][m] = norm;
      for (int d = 0; d < D; ++d) basis[m - 1][d] = norm > 0 ? left[d] / norm : 0.0;
    }
    foot.share[0] = 1.0;
    for (int b = size_ - 1; b > 0; --b) {
      double left = triangle[b][size_];
      for (int m = b + 1; m < size_; ++m) left -= triangle[b][m] * foot.share[m];
      foot.share[b] = triangle[b][b] > 0 ? left / triangle[b][b] : 0.0;
      foot.share[0] -= foot.share[b];
    }
    return foot;
  }

  /// Makes the ball the smallest that also contains point n; false if rounding prevents any
  /// progress.
  bool take_in(std::size_t n) {
    const Point q = point(n);
    double weight = 0.0;
    const double reach = square(q, held_[0]);
    for (int round = 0; round < D + 2; ++round) {
      const Foot foot = foot_of(q);
      const double height = dot(foot.normal, foot.normal);
      // in the flat, the holders change without a move of the centre
      const bool inside = size_ > D || height <= 1e-26 * reach;
      double step = std::numeric_limits<double>::infinity();
      if (!inside) {
        const double missing = square(q, centre_) - square(held_[0], centre_);
        step = std::max(missing / (2 * height), 0.0);
      }
      int dropped = -1;
      for (int m = 0; m < size_ && size_ > 1; ++m) {
        if (foot.share[m] > 0 && weight_[m] < step * foot.share[m]) {
          step = weight_[m] / foot.share[m];
          dropped = m;
        }
      }
      if (inside && dropped < 0) return false;
      for (int d = 0; d < D && !inside; ++d) centre_[d] += step * foot.normal[d];
      for (int m = 0; m < size_; ++m) weight_[m] -= step * foot.share[m];
      weight += step;
      if (dropped < 0) {
        held_[size_] = q;
        holders_[size_] = n;
        weight_[size_++] = weight;
        return true;
      }
      --size_;
      held_[dropped] = held_[size_];
      holders_[dropped] = holders_[size_];
      weight_[dropped] = weight_[size_];
    }
    return false;
  }

  const double* points_;
  std::size_t count_;
  double* squares_;
  std::array<Point, D + 2> held_;
  std::array<std::size_t, D + 2> holders_;
  std::array<double, D + 2> weight_{};
  int size_ = 0;
  Point centre_{};
  double radius_ = 0.0;
};

}  // namespace samcontact::fatigue
