// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/oblique_wake_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "samcontact/kernels/ring_axis.hpp"
#include "samcontact/kernels/wake_nodes.hpp"

namespace samcontact::kernels {
namespace {

using Table = Eigen::MatrixXd;
using std::numbers::pi;

/// One axis of the rectangle: along u, the body moves at least as fast as along w.
struct Side {
  double size, speed;
  std::vector<double> offsets;

  double farthest() const { return *std::ranges::max_element(offsets); }
  /// Number of offsets up to a distance; they increase.
  Eigen::Index within(double distance) const {
    return std::ranges::count_if(offsets, [&](double x) { return x <= distance; });
  }
  /// Weight of a wavenumber, of a width of the quadrature.
  double weight(double k, double width) const {
    return width * size / pi * ring::sinc(0.5 * k * size);
  }
};

class ObliqueSum {
 public:
  ObliqueSum(const ObliqueWaves& waves, Side u, Side w, bool is_exchanged)
      : waves_(waves),
        u_(std::move(u)),
        w_(std::move(w)),
        is_exchanged_(is_exchanged),
        slope_(std::fabs(w_.speed / u_.speed)),
        speed_(std::hypot(u_.speed, w_.speed)),
        extent_(std::max({u_.farthest(), w_.farthest(), waves.longest})),
        sums_(waves.parities.size(), Table::Zero(u_.offsets.size(), w_.offsets.size())) {}

  std::vector<Table> all() {
    double outer = waves_.highest;
    for (; outer * extent_ >= ring::last; outer *= 0.5) add_ring(outer);
    add_disc(outer);
    return std::move(sums_);
  }

 private:
  std::size_t count() const { return waves_.parities.size(); }
  bool odd_u(std::size_t c) const {
    return is_exchanged_ ? waves_.parities[c].odd_y : waves_.parities[c].odd_x;
  }
  bool odd_w(std::size_t c) const {
    return is_exchanged_ ? waves_.parities[c].odd_x : waves_.parities[c].odd_y;
  }
  void at(double ku, double kw, double* values) const {
    is_exchanged_ ? waves_.at(kw, ku, values) : waves_.at(ku, kw, values);
  }

  /// Window in wavenumber, and where its kernel extends to.
  struct Ring {
    double inner, outer, top;  // top: no wavenumber is higher
    double reached_u, reached_w;
    Eigen::Index near_u, near_w;  // numbers of offsets
  };

  void add_ring(double outer) {
    const double inner = 0.5 * outer;
    const double scale = ring::wake_scale(speed_, ring::edge * outer);
    const double along = ring::reach / (ring::edge * inner) + ring::wake_lengths / scale;
    if (along < 0.5 * std::min(u_.size, w_.size)) return;
    const Ring ring{inner,
                    outer,
                    (1 + 5 * ring::edge) * outer,
                    std::min(u_.farthest(), along) + 0.5 * u_.size,
                    std::min(w_.farthest(), along) + 0.5 * w_.size,
                    u_.within(along + 0.5 * u_.size),
                    w_.within(along + 0.5 * w_.size)};
    // After the sum over ku, the rapid modes have the phase of kw in both directions.
    const double reached = ring.reached_w + slope_ * ring.reached_u;
    const auto nodes = wake::graded_nodes(
        ring.top, std::min(wake::wide_panel * outer, wake::long_phase / reached),
        std::min(wake::narrow_panel * outer, wake::short_phase / reached), ring.top);
    const auto columns = static_cast<Eigen::Index>(nodes.size());
    std::vector<Table> strips(count(), Table::Zero(ring.near_u, columns));
    for (Eigen::Index n = 0; n < columns; ++n) {
      const Table strip = strip_of(ring, nodes[n].k);
      for (std::size_t c = 0; c < count(); ++c) strips[c].col(n) = strip.col(c);
    }
    std::array<Table, 2> waves{Table(columns, ring.near_w), Table(columns, ring.near_w)};
    for (Eigen::Index n = 0; n < columns; ++n) {
      const auto& [k, width] = nodes[n];
      const double weight = w_.weight(k, width);
      for (Eigen::Index j = 0; j < ring.near_w; ++j) {
        waves[0](n, j) = weight * std::cos(k * w_.offsets[j]);
        waves[1](n, j) = weight * std::sin(k * w_.offsets[j]);
      }
    }
    for (std::size_t c = 0; c < count(); ++c) {
      sums_[c].topLeftCorner(ring.near_u, ring.near_w) += strips[c] * waves[odd_w(c) ? 1 : 0];
    }
  }

  /// Sums over ku at the offsets along u, [offset][component].
  Table strip_of(const Ring& ring, double kw) const {
    Table strip = Table::Zero(ring.near_u, static_cast<Eigen::Index>(count()));
    // Graded on both sides of the wavenumber of the rapid modes.
    const double middle = slope_ * kw;
    const double finest =
        0.25 * ring::wake_scale(speed_, std::max(ring::edge * ring.outer, std::hypot(kw, middle)));
    for (const double side : {1.0, -1.0}) {
      const double length = side > 0 ? ring.top - middle : middle;
      if (length <= 0) continue;
      const auto octaves = wake::octaves(
          length, std::min(wake::wide_panel * ring.outer, wake::long_phase / ring.reached_u),
          std::min(wake::narrow_panel * ring.outer, wake::short_phase / ring.reached_u), finest);
      for (const auto& octave : octaves) add_octave(ring, kw, middle, side, octave, strip);
    }
    return strip;
  }

  void add_octave(const Ring& ring, double kw, double middle, double side,
                  const wake::Octave& octave, Table& strip) const {
    const auto size = static_cast<Eigen::Index>(octave.nodes.size());
    Eigen::VectorXd weights(size), k(size);
    bool is_needed = false;
    for (Eigen::Index m = 0; m < size; ++m) {
      k[m] = middle + side * octave.nodes[m].k;
      const double share = ring::share(std::hypot(k[m], kw), ring.inner, ring.outer);
      is_needed |= std::fabs(share) >= ring::negligible;
      weights[m] = share * u_.weight(k[m], octave.nodes[m].weight);
    }
    if (!is_needed) return;
    const auto points = static_cast<Eigen::Index>(octave.points.size());
    Table values(points, static_cast<Eigen::Index>(count()));
    std::vector<double> wave(count());
    for (Eigen::Index p = 0; p < points; ++p) {
      at(middle + side * octave.points[p], kw, wave.data());
      for (std::size_t c = 0; c < count(); ++c) values(p, static_cast<Eigen::Index>(c)) = wave[c];
    }
    if (octave.basis.size() > 0) values = octave.basis * values;
    values = weights.asDiagonal() * values;
    Table cosines(ring.near_u, size), sines(ring.near_u, size);
    for (Eigen::Index m = 0; m < size; ++m) {
      for (Eigen::Index i = 0; i < ring.near_u; ++i) {
        cosines(i, m) = std::cos(k[m] * u_.offsets[i]);
        sines(i, m) = std::sin(k[m] * u_.offsets[i]);
      }
    }
    for (std::size_t c = 0; c < count(); ++c) {
      const auto column = static_cast<Eigen::Index>(c);
      strip.col(column) += (odd_u(c) ? sines : cosines) * values.col(column);
    }
  }

  /// Disc of wavenumbers so small that the field is a polynomial in x and y.
  void add_disc(double outer) {
    using Powers = std::array<double, wake::power_count>;
    std::vector<Table> terms(count(), Table::Zero(wake::power_count, wake::power_count));
    std::vector<double> wave(count());
    const auto powers = [](double x) {  // x^n/n!
      Powers all{1.0};
      for (int n = 1; n < wake::power_count; ++n) all[n] = all[n - 1] * x / n;
      return all;
    };
    const double middle = std::atan(slope_), quarter = 0.5 * pi;
    const auto radii =
        wake::graded_nodes((1 + 5 * ring::edge) * outer, wake::wide_panel * outer,
                           wake::narrow_panel * outer, wake::smallest_wave / extent_);
    for (const auto& [q, width] : radii) {
      const double finest = std::min(0.25, 0.25 * ring::wake_scale(speed_, q) / q);
      for (const double side : {1.0, -1.0}) {
        const double range = side > 0 ? quarter - middle : middle;
        for (const auto& [turn, part] :
             wake::graded_nodes(range, quarter, quarter / 8, std::min(finest, range))) {
          const double angle = middle + side * turn;  // from w
          const double ku = q * std::sin(angle), kw = q * std::cos(angle);
          at(ku, kw, wave.data());
          const double weight =
              ring::share(q, 0.0, outer) * q * u_.weight(ku, width) * w_.weight(kw, part);
          const Powers u = powers(ku * extent_), w = powers(kw * extent_);
          for (std::size_t c = 0; c < count(); ++c) {
            for (int b = odd_w(c) ? 1 : 0; b < wake::power_count; b += 2) {
              for (int a = odd_u(c) ? 1 : 0; a < wake::power_count; a += 2) {
                terms[c](a, b) += weight * wave[c] * u[a] * w[b];
              }
            }
          }
        }
      }
    }
    for (std::size_t c = 0; c < count(); ++c) {
      sums_[c] += wake::power_table(u_.offsets, extent_, odd_u(c) ? 1 : 0) * terms[c] *
                  wake::power_table(w_.offsets, extent_, odd_w(c) ? 1 : 0).transpose();
    }
  }

  const ObliqueWaves& waves_;
  Side u_, w_;
  bool is_exchanged_;
  double slope_, speed_, extent_;
  std::vector<Table> sums_;  // [component], [u][w]
};

}  // namespace

Field oblique_wake_sums(const ObliqueWaves& waves, double dx, double dy, std::span<const double> x,
                        std::span<const double> y) {
  const bool is_exchanged = std::fabs(waves.speed_y) > std::fabs(waves.speed_x);
  Side u{dx, waves.speed_x, {x.begin(), x.end()}}, w{dy, waves.speed_y, {y.begin(), y.end()}};
  if (is_exchanged) std::swap(u, w);
  Field out;
  out.reserve(waves.parities.size() * x.size() * y.size());
  for (const Table& sums : ObliqueSum(waves, std::move(u), std::move(w), is_exchanged).all()) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      for (std::size_t i = 0; i < x.size(); ++i) {
        out.push_back(is_exchanged ? sums(j, i) : sums(i, j));
      }
    }
  }
  return out;
}

}  // namespace samcontact::kernels
