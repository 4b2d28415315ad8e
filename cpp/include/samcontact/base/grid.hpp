// SPDX-License-Identifier: GPL-3.0-or-later
// Regular grid of all fields.
#pragma once

#include <cstddef>
#include <vector>

namespace samcontact {

/// Index of the cell within one period, [0, period), that repeats a cell.
constexpr int in_period(int index, int period) { return ((index % period) + period) % period; }

/// Periodic directions, with the period in cells of the grid.
struct Period {
  int x = 0, y = 0;  // cells; 0: not periodic, the surface extends beyond the grid without traction
  /// If one direction is periodic: distance from a load at which its displacement, which has no
  /// far-field limit, is taken as zero [m].
  double reference = 0.0;

  bool is_on() const { return x > 0 || y > 0; }
  bool operator==(const Period&) const = default;
};

/// Cell-centred grid. x_i = (i - (nx-1)/2) dx [m], y likewise; layer k spans [k dz, (k+1) dz] with
/// z into the body. Without nz the volume has no bottom; without dz there is the surface only. A
/// part of a grid may start below the surface, at layer k0.
///
/// Index orders in the core: a surface field is [i][j] (y fastest); a volume field is depth-major,
/// [k][i][j]; a tensor field is [component][k][i][j] with components xx, yy, zz, yz, xz, xy.
struct Grid {
  int nx, ny, nz;
  double dx, dy, dz;
  Period period;  // a part of a grid has the period of the whole grid
  int k0 = 0;     // layers of cells between the surface and the first layer

  /// Throws std::invalid_argument if a count is not positive (nz: negative) or a size is not a
  /// positive finite number (dz: 0 is allowed without layers).
  Grid(int nx, int ny, double dx, double dy, int nz = 0, double dz = 0.0);

  /// Copy that is periodic along x, y or both. Throws std::invalid_argument unless the number of
  /// cells along each periodic direction is even or 1, there is more than one cell in all, and
  /// cells are at most eight times as long as the period in the other direction.
  Grid made_periodic(bool along_x, bool along_y) const;
  /// Whether each period is an even number of cells `factor` times as long.
  bool can_be_coarsened(int factor = 2) const;

  std::size_t surface_size() const { return static_cast<std::size_t>(nx) * ny; }
  std::size_t volume_size() const { return surface_size() * nz; }
  bool has_volume() const { return dz > 0; }
  double cell_area() const { return dx * dy; }

  std::vector<double> x() const;
  std::vector<double> y() const;
  /// Mid-depths of all layers, or of the first `layers` layers [m].
  std::vector<double> z() const { return z(nz); }
  std::vector<double> z(int layers) const;
};

}  // namespace samcontact
