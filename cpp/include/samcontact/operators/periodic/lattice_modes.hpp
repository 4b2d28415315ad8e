// SPDX-License-Identifier: GPL-3.0-or-later
// Fourier modes of all images of an infinite lattice. A window divides the wavenumbers. Short waves
// of these images do not reach the cells; for long waves, which are known from their symbol, the
// sum of all images is the sum over the modes of the lattice less the integral over all modes,
// which is the cell itself.
#pragma once

#include <algorithm>
#include <vector>

namespace samcontact::operators {

/// Offsets 0, d, .. (cells - 1) d along one axis, of a lattice with the period `period` [m].
struct LatticeAxis {
  double d = 1.0;
  int cells = 1;
  double period = 0.0;  // 0: none
  double length = d;    // of the acting cell
  int near_images = 0;  // images up to this one are added one by one

  double extent() const { return (cells - 1) * d; }
  /// Distance from the middle of a cell to beyond its edge: equal for all cells that are not large,
  /// so that finer and coarser grids of a period have the same wavenumbers and points.
  double edge() const { return std::max(0.5 * d, period / 64); }
  /// Distance from the farthest offset to the first image that is not added individually.
  double distance() const { return (near_images + 1) * period - extent(); }
};

/// Window g = erfc((q/q_1 - 1)/s)/2. Its steps are Gaussians: the part above it has a range of
/// reach/(s q_1).
struct LatticeWindow {
  double steepness = 0.2, reach = 10.5, end = 1 + 5.6 * 0.2;

  /// Window with the given truncation error relative to the whole; 1e-12 by default.
  static LatticeWindow within(double tol);
  double at(double q) const;
  /// First wavenumber of short waves, for images at this distance.
  double split(double distance) const { return reach / (steepness * distance); }
};

/// Wavenumbers >= 0 and the weights of their sum, that of the other quadrants included.
struct LatticeModes {
  std::vector<double> kx, ky, weight;

  /// For cells, y periodic; without a period along x, modes that are uniform along y are omitted.
  static LatticeModes of_cells(const LatticeAxis& x, const LatticeAxis& y,
                               const LatticeWindow& window = {});
  /// For strips that are uniform along y, x periodic. One row of offsets.
  static LatticeModes of_strips(const LatticeAxis& x);

 private:
  void push(double x, double y, double w);
  /// Adds the sum over the modes of a lattice, windowed at q1.
  void add_lattice(const LatticeAxis& x, const LatticeAxis& y, const LatticeWindow& window,
                   double q1);
  /// Subtracts the integral over all modes, for a cell and the images that are added one by one.
  void subtract_integral(const LatticeAxis& x, const LatticeAxis& y, const LatticeWindow& window,
                         double q1);
};

}  // namespace samcontact::operators
