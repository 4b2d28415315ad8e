// SPDX-License-Identifier: GPL-3.0-or-later
// Wavenumbers that represent the history of a heated half-space (heat_history.hpp).
//
// A body heated through its surface is the half z > 0 of an infinite body with sources 2 q on z =
// 0. Its modes exp(i w.x) cos(s z) are independent of each other and decay by exp(-(w^2 + i
// w.V/kappa + s^2) kappa t). The plane of w is divided among levels by smooth windows: rings that
// shrink by a factor of two from level to level and, last, a disc around w = 0. The part of a
// kernel in a ring vanishes within the period of the level, so that its sum over a lattice of
// wavenumbers has no images; the lattice of each level is twice as fine as that of the previous
// one. Greengard & Lin (2000), doi:10.1006/acha.2000.0310, treat the heat kernel likewise.
//
// A moving body carries its heat away; on a periodic lattice it would return. Each level therefore
// stores its heat in a few generations by age, and drops the oldest once it is farther away than
// the range of the kernels of the level. If the body moves along a path that may turn, nothing is
// dropped, and the periods contain the path.
//
// Wavenumbers far beyond the highest wavenumber of the grid matter only for heat younger than the
// time to diffuse across a cell. For a body at rest and such short time steps, they are left to
// NearHeat (heat_near.hpp).
//
// If the surface is periodic, the lattice along that direction is that of the period. Along both
// directions it is exact, and there are no rings.
//
// Modes of a layered body (layered_response.hpp) do not decay by such rates: blocks of similar w
// have real rates of their own, in a geometric row, instead of nodes in s. kappa is the smallest
// diffusivity of the layers.
//
// Lengths are in units of dx; times t stand for kappa t / dx^2.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/fft/padded_transform.hpp"

namespace samcontact::operators {

/// Along x and y.
using PlaneVector = std::array<double, 2>;

/// Wavenumber (w1, w2) of the lattice of a level, with indices (a, b), b >= 0.
struct HeatMode {
  int a, b;
  double w1, w2, w;
  Complex decay;  // w^2 + i w.V/kappa; without w^2 in layers
  double source;  // product of window, shape of a cell and weight of the lattice
};

/// Modes of similar w with their nodes: numbers are stored [node][mode] from `offset` on.
struct HeatBlock {
  std::size_t first, count, nodes, offset;
  std::size_t first_node;  // among the rates of the level
};

struct HeatLevel {
  double dw1 = 0.0, dw2 = 0.0;
  double clear = 0.0;            // distance beyond which kernels vanish
  double generation = 0.0;       // time over which heat is collected in one generation
  int reach_a = 0, reach_b = 0;  // largest |a|, b
  std::vector<HeatMode> modes;
  std::vector<HeatBlock> blocks;
  std::vector<double> s, weight;  // sum of weight f(s) = (2/pi) integral over s >= 0
  std::vector<double> rates;      // of decay of the nodes: s^2; in layers, those of each block
  // All levels but level 0: exp(i a dw1 x), [point][a + reach_a], and [b][point], at cells and at
  // the few points on which the fields of the level are computed before they are interpolated.
  ComplexField cells_x, cells_y, points_x, points_y;
  int points = 0;
  /// Interpolation from the points of this level to those of the previous one, or to the cells:
  /// [to][from].
  Field refine_x, refine_y;
};

struct HeatResolution {
  double shortest;  // minimum age of heat
  double longest;   // maximum age of heat
  double tolerance;
  bool in_depth;  // whether fields below the surface are required
  /// Lengths along x and y over which a body moves on a path that may turn; 0: it does not.
  PlaneVector track;
  /// Of layers: length over which they differ from the substrate, and largest over smallest
  /// diffusivity. 0 and 1: homogeneous.
  double layers = 0.0, contrast = 1.0;
  bool is_layered() const { return layers > 0; }
  bool follows() const { return track != PlaneVector{}; }
};

/// Periods of the surface [dx]; 0: not periodic.
struct HeatPeriods {
  double x = 0.0, y = 0.0;
  bool is_on() const { return x > 0 || y > 0; }
  bool is_double() const { return x > 0 && y > 0; }
};

/// Resolution of modes, and the part of them that is left to NearHeat.
struct HeatScales {
  double sharpness;  // sqrt(ln(1/tolerance))
  double cutoff;     // largest significant wavenumber
  bool is_split;     // whether a part is left to NearHeat
  double step;       // between nodes s = scale sinh(n step)

  /// is_whole: nothing is left to NearHeat.
  HeatScales(const HeatResolution& resolution, bool is_whole);
  /// Smallest wavenumber of which a part is left to NearHeat.
  static constexpr double split_begin = 0.4;
  /// Wavenumber beyond which everything is left to NearHeat.
  double split_end() const;
  /// Range of the kernels of the part left to NearHeat.
  double split_reach() const;
  /// Ratio of subsequent rates of a layered body, logarithm.
  double rate_step() const { return 4.1 / (sharpness * sharpness); }
  /// Part of a wavenumber that is represented by modes; 1 unless is_split.
  double split(double w) const;
  /// Weight of depth z in the sums over s: cos(s z), faded out at the highest s, which are not
  /// resolved.
  double fade(double sz) const;
};

class HeatModes {
 public:
  HeatModes(const Grid& grid, double speed_x, double speed_y, const HeatResolution& resolution);

  const std::vector<HeatLevel>& levels() const { return levels_; }
  const HeatResolution& resolution() const { return resolution_; }
  /// Number of complex numbers stored for all modes and nodes; number of modes.
  std::size_t size() const { return size_; }
  std::size_t mode_count() const { return mode_count_; }
  /// Number of generations of a level: a single one of all ages for a body at rest.
  int generations() const { return is_moving_ ? 3 : 1; }
  const HeatPeriods& periods() const { return periods_; }
  const fft::PaddedTransform& transform() const { return transform_; }

  /// Amplitudes of all modes, level by level, for a flux [i][j].
  void project(const double* flux, ComplexField& amplitudes) const;
  /// plane[i][j] += (or =) sum over the modes; amplitudes as in project(), without its factors.
  void evaluate(const Complex* amplitudes, double* plane) const;
  const HeatScales& scales() const { return scales_; }
  double cell_y() const { return cell_y_; }

 private:
  fft::PaddedTransform padded(const Grid& grid) const;
  void set_reach(HeatLevel& level, double shrink) const;
  void add_periodic(double spread);
  void add_level(int number, int last, double shrink);
  void finish(HeatLevel level, double scale);
  void add_depth_blocks(HeatLevel& level, double scale);
  void add_rate_blocks(HeatLevel& level);
  void require_memory_of(const HeatLevel& level, double scale) const;
  void add_points(HeatLevel& level) const;

  double cell_y_, speed_x_, speed_y_;
  bool is_moving_;
  HeatPeriods periods_;
  HeatResolution resolution_;
  HeatScales scales_;
  fft::PaddedTransform transform_;
  std::vector<HeatLevel> levels_;
  std::size_t size_ = 0, mode_count_ = 0;
};

}  // namespace samcontact::operators
