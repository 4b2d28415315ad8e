// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/periodic/lattice_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "samcontact/kernels/gauss.hpp"

namespace samcontact::operators {
namespace {

using std::numbers::pi;

/// Sum over the cell and its images that are added one by one, relative to the cell.
double of_images(double k, const LatticeAxis& axis) {
  double sum = 1.0;
  for (int n = 1; n <= axis.near_images; ++n) sum += 2 * std::cos(k * n * axis.period);
  return sum;
}

/// Transform of a cell of length d.
double of_cell(double k, double d) { return k == 0 ? d : 2 * std::sin(0.5 * k * d) / k; }

}  // namespace

LatticeWindow LatticeWindow::within(double tol) {
  // exp(-(reach/2)^2), and erfc of both ends.
  const double reach = 2 * std::sqrt(-std::log(tol)), steepness = 2 / reach;
  return {steepness, reach, 1 + 0.5 * reach * steepness};
}

double LatticeWindow::at(double q) const { return 0.5 * std::erfc((q - 1) / steepness); }

void LatticeModes::push(double x, double y, double w) {
  if (w == 0) return;
  kx.push_back(x);
  ky.push_back(y);
  weight.push_back(w);
}

void LatticeModes::add_lattice(const LatticeAxis& x, const LatticeAxis& y,
                               const LatticeWindow& window, double q1) {
  // Without a period along x, modes that vary along y decay with the distance from the load along
  // x.
  const double clearance = std::max(8 * y.period, 1.1 * y.distance()) + x.d;
  const double period_x = x.period > 0 ? x.period : x.extent() + clearance;
  const int nx = static_cast<int>(window.end * q1 * period_x / (2 * pi));
  const int ny = static_cast<int>(window.end * q1 * y.period / (2 * pi));
  for (int n = x.period > 0 ? 0 : 1; n <= ny; ++n) {
    for (int m = n == 0 ? 1 : 0; m <= nx; ++m) {
      const double k_x = 2 * pi * m / period_x, k_y = 2 * pi * n / y.period;
      const double multiplicity = (m > 0 ? 2.0 : 1.0) * (n > 0 ? 2.0 : 1.0);
      push(k_x, k_y,
           multiplicity / (period_x * y.period) * window.at(std::hypot(k_x, k_y) / q1) *
               of_cell(k_x, x.length) * of_cell(k_y, y.length));
    }
  }
}

void LatticeModes::subtract_integral(const LatticeAxis& x, const LatticeAxis& y,
                                     const LatticeWindow& window, double q1) {
  const double last = window.end * q1;
  const double farthest = std::hypot(x.extent() + x.near_images * x.period + x.edge(),
                                     y.extent() + y.near_images * y.period + y.edge());
  const auto radial = kernels::gauss_legendre(static_cast<int>(0.5 * last * farthest) +
                                              static_cast<int>(2.9 * window.reach));
  const int angles =
      static_cast<int>(0.25 * last * farthest) + static_cast<int>(1.43 * window.reach);
  for (const auto& [at, share] : radial) {
    const double q = last * at;
    for (int a = 0; a < angles; ++a) {
      const double angle = (a + 0.5) * pi / (2 * angles);
      const double k_x = q * std::cos(angle), k_y = q * std::sin(angle);
      push(k_x, k_y,
           -share * last * q / (2 * pi * angles) * window.at(q / q1) * of_cell(k_x, x.length) *
               of_cell(k_y, y.length) * of_images(k_x, x) * of_images(k_y, y));
    }
  }
}

LatticeModes LatticeModes::of_cells(const LatticeAxis& x, const LatticeAxis& y,
                                    const LatticeWindow& window) {
  // Distance to the nearest edge of an image.
  double distance = y.distance() - y.edge();
  if (x.period > 0) distance = std::min(distance, x.distance() - x.edge());
  const double q1 = window.split(distance);
  LatticeModes modes;
  modes.add_lattice(x, y, window, q1);
  modes.subtract_integral(x, y, window, q1);
  return modes;
}

LatticeModes LatticeModes::of_strips(const LatticeAxis& x) {
  const LatticeWindow window;
  const double q1 = window.split(std::max(x.distance() - 0.5 * x.d, 0.25 * x.distance()));
  const double last = window.end * q1;
  LatticeModes modes;
  for (int m = 1; 2 * pi * m / x.period <= last; ++m) {
    const double k = 2 * pi * m / x.period;
    modes.push(k, 0.0, 2 / x.period * window.at(k / q1) * of_cell(k, x.length));
  }
  const auto rule = kernels::gauss_legendre(static_cast<int>(0.5 * last * (x.extent() + x.d)) + 40);
  for (const auto& [at, share] : rule) {
    const double k = last * at;
    modes.push(k, 0.0, -share * last / pi * window.at(k / q1) * of_cell(k, x.length));
  }
  return modes;
}

}  // namespace samcontact::operators
