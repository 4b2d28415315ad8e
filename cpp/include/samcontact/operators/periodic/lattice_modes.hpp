// SPDX-License-Identifier: GPL-3.0-or-later
// The waves of all images that a lattice repeats without end. A window divides the wavenumbers. Of
// short waves nothing of these images arrives; of the long ones, which their symbol gives, all
// images are the sum over the waves of the lattice less the integral over all waves, the cell
// itself.
#pragma once

#include <algorithm>
#include <vector>

namespace samcontact::operators {

/// Offsets 0, d, .. (cells - 1) d along one axis, of a lattice that repeats after `period` [m].
struct LatticeAxis {
  double d = 1.0;
  int cells = 1;
  double period = 0.0;  // 0: none
  double length = d;    // of the cell that acts
  int apart = 0;        // images up to this one are added one by one

  double extent() const { return (cells - 1) * d; }
  /// From the middle of a cell to beyond its edge: the same for all cells that are not large, so
  /// that finer and coarser grids of a period have the same wavenumbers and points.
  double edge() const { return std::max(0.5 * d, period / 64); }
  /// From the farthest offset to the first image that is not added.
  double distance() const { return (apart + 1) * period - extent(); }
};

/// The window g = erfc((q/q_1 - 1)/s)/2. Its steps are Gaussians: what lies above it reaches as far
/// as reach/(s q_1) and no farther.
struct LatticeWindow {
  double steepness = 0.2, reach = 10.5, end = 1 + 5.6 * 0.2;

  /// What is neglected, relative to the whole; 1e-12 by default.
  static LatticeWindow within(double tol);
  double at(double q) const;
  /// First wavenumber of short waves, for images at this distance.
  double split(double distance) const { return reach / (steepness * distance); }
};

/// Wavenumbers >= 0 and the weights of their sum, that of the other quadrants included.
struct LatticeModes {
  std::vector<double> kx, ky, weight;

  /// Of cells, y periodic; without a period along x, waves that are uniform along y are left out.
  static LatticeModes of_cells(const LatticeAxis& x, const LatticeAxis& y,
                               const LatticeWindow& window = {});
  /// Of strips that are uniform along y, x periodic. One row of offsets.
  static LatticeModes of_strips(const LatticeAxis& x);

 private:
  void push(double x, double y, double w);
  /// The sum over the waves of a lattice, windowed at q1.
  void add_lattice(const LatticeAxis& x, const LatticeAxis& y, const LatticeWindow& window,
                   double q1);
  /// Less the integral over all waves, for a cell and the images that are added one by one.
  void subtract_integral(const LatticeAxis& x, const LatticeAxis& y, const LatticeWindow& window,
                         double q1);
};

}  // namespace samcontact::operators
