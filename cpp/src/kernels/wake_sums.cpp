// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/wake_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "samcontact/kernels/ring_axis.hpp"
#include "samcontact/kernels/wake_nodes.hpp"

namespace samcontact::kernels {
namespace {

using WakeMatrix = Eigen::MatrixXd;
using WakeValue = std::complex<double>;

class WakeSum {
 public:
  WakeSum(const WakeWaves& waves, double dx, double dy, std::span<const double> x,
          std::span<const double> y)
      : waves_(waves),
        dx_(dx),
        dy_(dy),
        x_(x),
        y_(y),
        extent_(std::max({std::ranges::max(x), std::ranges::max(y), waves.longest})),
        sums_(2 * waves.parities.size() * x.size() * y.size(), 0.0) {}

  Field all() {
    double outer = waves_.highest;
    for (; outer * extent_ >= ring::last; outer *= 0.5) add_ring(outer);
    add_disc(outer);
    return std::move(sums_);
  }

 private:
  std::size_t count() const { return waves_.parities.size(); }

  void add_ring(double outer) {
    const double inner = 0.5 * outer;
    const double support = ring::reach / (ring::edge * inner);
    const double scale = ring::wake_scale(waves_.speed, ring::edge * outer);
    const double along = support + ring::wake_lengths / scale;
    if (along < 0.5 * std::min(dx_, dy_)) return;
    const ring::Axis across(y_, dy_, support, outer, false);
    const double reached = std::min(std::ranges::max(x_), along) + 0.5 * dx_;
    const auto along_motion = wake::octaves(
        (1 + 5 * ring::edge) * outer,
        std::min(wake::wide_panel * outer, wake::long_phase / reached),
        std::min(wake::narrow_panel * outer, wake::short_phase / reached), 0.25 * scale);
    std::vector<wake::Node> nodes;
    for (const auto& octave : along_motion) {
      nodes.insert(nodes.end(), octave.nodes.begin(), octave.nodes.end());
    }
    const auto rows = static_cast<Eigen::Index>(nodes.size());
    const Eigen::Index columns = across.k.size();
    std::vector<WakeMatrix> real(count(), WakeMatrix::Zero(rows, columns)), imaginary = real;
    const auto evaluate = [&](const auto& at, std::vector<WakeValue>& values, Eigen::Index n) {
      Eigen::Index first = 0;
      for (const auto& octave : along_motion) {
        add_octave(octave, first, across.k[n], inner, outer, at, values,
                   [&](std::size_t c) { return std::pair{real[c].col(n), imaginary[c].col(n)}; });
        first += static_cast<Eigen::Index>(octave.nodes.size());
      }
    };
#pragma omp parallel
    {
      const auto at = waves_.at;
      std::vector<WakeValue> values(count());
#pragma omp for schedule(dynamic)
      for (Eigen::Index n = 0; n < columns; ++n) evaluate(at, values, n);
    }
    const auto near = std::ranges::count_if(x_, [&](double x) { return x <= along + 0.5 * dx_; });
    WakeMatrix even(near, rows), odd(near, rows);
    for (Eigen::Index m = 0; m < rows; ++m) {
      const auto [k, width] = nodes[m];
      const double weight = width * dx_ / std::numbers::pi * ring::sinc(0.5 * k * dx_);
      for (Eigen::Index i = 0; i < near; ++i) {
        even(i, m) = weight * std::cos(k * x_[i]);
        odd(i, m) = weight * std::sin(k * x_[i]);
      }
    }
    for (std::size_t c = 0; c < count(); ++c) {
      const auto& [odd_x, odd_y, odd_z] = waves_.parities[c];
      const WakeMatrix side = (odd_y ? across.odd : across.even).transpose();
      if (odd_x) {
        add(c, 0, odd * real[c] * side, across.places);
        add(c, 1, even * imaginary[c] * side, across.places);
      } else {
        add(c, 0, even * real[c] * side, across.places);
        add(c, 1, -odd * imaginary[c] * side, across.places);
      }
    }
  }

  /// Sets the modes at the nodes of an octave, with their window; into(c): columns of real and
  /// imaginary parts, which begin at `first`.
  template <class At, class Into>
  void add_octave(const wake::Octave& octave, Eigen::Index first, double across, double inner,
                  double outer, const At& at, std::vector<WakeValue>& values,
                  const Into& into) const {
    const auto size = static_cast<Eigen::Index>(octave.nodes.size());
    Eigen::VectorXd shares(size);
    for (Eigen::Index m = 0; m < size; ++m) {
      shares[m] = ring::share(std::hypot(octave.nodes[m].k, across), inner, outer);
      if (std::fabs(shares[m]) < ring::negligible) shares[m] = 0.0;
    }
    if ((shares.array() == 0.0).all()) return;
    const bool is_exact = octave.basis.size() == 0;
    const auto points = static_cast<Eigen::Index>(octave.points.size());
    Eigen::MatrixXcd found = Eigen::MatrixXcd::Zero(points, static_cast<Eigen::Index>(count()));
    for (Eigen::Index p = 0; p < points; ++p) {
      if (is_exact && shares[p] == 0.0) continue;
      at(octave.points[p], across, values.data());
      for (std::size_t c = 0; c < count(); ++c) found(p, static_cast<Eigen::Index>(c)) = values[c];
    }
    for (std::size_t c = 0; c < count(); ++c) {
      auto [real, imaginary] = into(c);
      const auto own = found.col(static_cast<Eigen::Index>(c));
      const Eigen::VectorXd re = own.real(), im = own.imag();
      real.segment(first, size) =
          shares.cwiseProduct(is_exact ? re : Eigen::VectorXd(octave.basis * re));
      imaginary.segment(first, size) =
          shares.cwiseProduct(is_exact ? im : Eigen::VectorXd(octave.basis * im));
    }
  }

  /// Adds a table [i][j] at the first offsets along x and given ones along y.
  void add(std::size_t component, int part, const WakeMatrix& table,
           const std::vector<int>& places) {
    double* sums = sums_.data() + (2 * component + part) * x_.size() * y_.size();
    for (std::size_t n = 0; n < places.size(); ++n) {
      double* row = sums + places[n] * x_.size();
      for (Eigen::Index i = 0; i < table.rows(); ++i) {
        row[i] += table(i, static_cast<Eigen::Index>(n));
      }
    }
  }

  /// Disc of wavenumbers so small that the field is a polynomial in x and y.
  void add_disc(double outer) {
    constexpr int power_count = wake::power_count;
    using Powers = std::array<double, power_count>;
    std::vector<WakeMatrix> real(count(), WakeMatrix::Zero(power_count, power_count));
    std::vector<WakeMatrix> imaginary = real;
    std::vector<WakeValue> values(count());
    const auto powers = [](double x) {  // x^n/n!
      Powers all{1.0};
      for (int n = 1; n < power_count; ++n) all[n] = all[n - 1] * x / n;
      return all;
    };
    const auto radii =
        wake::graded_nodes((1 + 5 * ring::edge) * outer, wake::wide_panel * outer,
                           wake::narrow_panel * outer, wake::smallest_wave / extent_);
    for (const auto& [q, width] : radii) {
      // The angle from the direction across the motion, graded like kx.
      const double right = 0.5 * std::numbers::pi;
      const double finest = std::min(0.25, 0.25 * ring::wake_scale(waves_.speed, q) / q);
      for (const auto& [angle, turn] : wake::graded_nodes(right, right, right / 8, finest)) {
        const double kx = q * std::sin(angle), ky = q * std::cos(angle);
        waves_.at(kx, ky, values.data());
        const double weight = ring::share(q, 0.0, outer) * q * width * turn * dx_ * dy_ /
                              (std::numbers::pi * std::numbers::pi) * ring::sinc(0.5 * kx * dx_) *
                              ring::sinc(0.5 * ky * dy_);
        const Powers x = powers(kx * extent_), y = powers(ky * extent_);
        for (std::size_t c = 0; c < count(); ++c) {
          for (int b = waves_.parities[c].odd_y ? 1 : 0; b < power_count; b += 2) {
            for (int a = 0; a < power_count; ++a) {
              real[c](a, b) += weight * values[c].real() * x[a] * y[b];
              imaginary[c](a, b) += weight * values[c].imag() * x[a] * y[b];
            }
          }
        }
      }
    }
    add_polynomials(real, imaginary);
  }

  void add_polynomials(const std::vector<WakeMatrix>& real,
                       const std::vector<WakeMatrix>& imaginary) {
    const auto powers = [&](std::span<const double> offsets, int first) {
      return wake::power_table({offsets.begin(), offsets.end()}, extent_, first);
    };
    std::vector<int> places(y_.size());
    for (std::size_t n = 0; n < places.size(); ++n) places[n] = static_cast<int>(n);
    const WakeMatrix even = powers(x_, 0), odd = powers(x_, 1);
    for (std::size_t c = 0; c < count(); ++c) {
      const auto& [odd_x, odd_y, odd_z] = waves_.parities[c];
      const WakeMatrix side = powers(y_, odd_y ? 1 : 0).transpose();
      add(c, 0, (odd_x ? odd : even) * real[c] * side, places);
      add(c, 1,
          odd_x ? WakeMatrix(even * imaginary[c] * side) : WakeMatrix(-odd * imaginary[c] * side),
          places);
    }
  }

  const WakeWaves& waves_;
  double dx_, dy_;
  std::span<const double> x_, y_;
  double extent_;
  Field sums_;
};

}  // namespace

Field wake_sums(const WakeWaves& waves, double dx, double dy, std::span<const double> x,
                std::span<const double> y) {
  return WakeSum(waves, dx, dy, x, y).all();
}

}  // namespace samcontact::kernels
