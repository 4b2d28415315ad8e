// SPDX-License-Identifier: GPL-3.0-or-later
// The regular grid on which every field lives.
#pragma once

#include <cstddef>
#include <vector>

namespace samcontact {

/// Which directions repeat themselves for ever, and after how many cells of the grid.
struct Period {
  int x = 0, y = 0;  // cells; 0: the surface goes on beyond the grid, without traction
  /// Where one direction is periodic: distance from a load at which its displacement, which has no
  /// limit far away, counts as zero [m].
  double reference = 0.0;

  bool is_on() const { return x > 0 || y > 0; }
  bool operator==(const Period&) const = default;
};

/// Cell-centred grid. x_i = (i - (nx-1)/2) dx [m], y likewise; layer k spans [k dz, (k+1) dz] with
/// z into the body. Without nz the volume has no bottom; without dz there is the surface only.
///
/// Index orders in the core: a surface field is [i][j] (y fastest); a volume field is depth-major,
/// [k][i][j]; a tensor field is [component][k][i][j] with components xx, yy, zz, yz, xz, xy.
struct Grid {
  int nx, ny, nz;
  double dx, dy, dz;
  Period period;  // a part of a grid has the period of the whole

  /// Throws std::invalid_argument when a count is not positive (nz: negative) or a size is not a
  /// positive finite number (dz: 0 where nz is).
  Grid(int nx, int ny, double dx, double dy, int nz = 0, double dz = 0.0);

  /// The same, its ends joined along x, y or both. Throws std::invalid_argument unless there is an
  /// even number of cells along such a direction, or one, and more than one cell in all, and unless
  /// cells are shorter than eight of the periods that they lie across.
  Grid joined(bool along_x, bool along_y) const;
  /// Whether cells `factor` times as long fit into the period.
  bool can_be_coarsened(int factor = 2) const;

  std::size_t surface_size() const { return static_cast<std::size_t>(nx) * ny; }
  std::size_t volume_size() const { return surface_size() * nz; }
  bool has_volume() const { return dz > 0; }
  double cell_area() const { return dx * dy; }

  std::vector<double> x() const;
  std::vector<double> y() const;
  /// Mid-depths of its layers, or of the first ones [m].
  std::vector<double> z() const { return z(nz); }
  std::vector<double> z(int layers) const;
};

}  // namespace samcontact
