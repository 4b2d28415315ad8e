// SPDX-License-Identifier: GPL-3.0-or-later
// Plastic history of one body: strain, equivalent plastic strain and backstress of its cells.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/simulation/cells/mirror.hpp"
#include "samcontact/simulation/cells/zones.hpp"
#include "samcontact/simulation/strain/strain_tiles.hpp"

namespace samcontact::simulation {

/// Fields of zones, [..][cell]: strain by component, equivalent plastic strain, and backstress by
/// term and five components of the deviator (empty: no kinematic hardening).
struct PlasticFields {
  Zones zones;
  Field strain, equivalent, backstress;
};

/// Position of the lattice of a body in the grid.
struct Lattice {
  std::array<int, 2> origin{};  // of the first cell, along x and y
  int period = 0;               // along x, in cells; 0: the lattice extends beyond the grid
  bool operator==(const Lattice&) const = default;

  /// Boxes of the lattice that have cells in common with a box in the grid: one or, if periodic,
  /// several, each as long as the box.
  std::vector<Box> of_body(const Box& box) const;
  /// Parts in the grid of a box of the lattice.
  std::vector<Box> of_grid(const Box& box) const;
};

/// Immutable. Stored in tiles of the lattice of the body, which the states of a rolling contact
/// share: each tile keeps the box of its cells that have a history. The lattice extends beyond the
/// grid, or has its period along x. With mirror planes it is the part on one side of them.
class PlasticState {
 public:
  /// `fields` in their zones, and the values of `before` elsewhere, with equal symmetry and tensor;
  /// null: zero. around: part of the box of the history, like the zones. lattice: in which tiles
  /// are counted if there is no previous history.
  PlasticState(const PlasticState* before, fft::Symmetry symmetry, operators::Tensor tensor,
               const PlasticFields& fields, const Box& around = {}, const Lattice& lattice = {});

  /// Box of all zones so far.
  const Box& box() const { return box_; }
  const Lattice& lattice() const { return lattice_; }
  /// Zones that contain all cells with a history: one for each tile with such cells, or two at the
  /// ends of a period.
  Zones zones() const;
  fft::Symmetry symmetry() const { return symmetry_; }
  operators::Tensor tensor() const { return tensor_; }

  /// Strain over any zones; zero in cells without history.
  Field strain(const Zones& zones) const;
  Field equivalent(const Zones& zones) const;
  Field backstress(const Zones& zones) const;
  PlasticFields fields(Zones zones) const;
  Field strain(const Box& box) const { return strain(Zones({box})); }
  Field equivalent(const Box& box) const { return equivalent(Zones({box})); }
  Field backstress(const Box& box) const { return backstress(Zones({box})); }

  /// Boxes around all strain outside the given zones.
  std::vector<Box> boxes_beyond(const Zones& zones) const;
  bool reaches_beyond(const Zones& zones) const { return !boxes_beyond(zones).empty(); }
  /// Fields; with mirror planes the stored part.
  const StrainTiles& tiles() const { return tiles_; }

  /// Copy moved by some cells along x and y.
  std::shared_ptr<const PlasticState> moved(int along_x, int along_y) const;
  /// Copy with fewer mirror planes.
  PlasticState unfolded(const Grid& grid, fft::Symmetry symmetry) const;

  bool operator==(const PlasticState& other) const;

 private:
  std::size_t strain_parts() const { return tiles_.strain_parts(); }
  std::size_t parts() const { return strain_parts() + 1 + backstress_parts_; }
  void put(const Box& box, const std::vector<const double*>& fields);
  Field gather(std::size_t first, std::size_t count, const Zones& zones) const;
  /// Adds the mirror image of a part of the history, all fields over a box, across x, y or both.
  void put_image(const Box& from, const Field& of_part, bool across_x, bool across_y,
                 const Grid& grid);

  Box box_;
  fft::Symmetry symmetry_;
  operators::Tensor tensor_;
  std::size_t backstress_parts_ = 0;
  Lattice lattice_;
  StrainTiles tiles_;
};

/// Whether two histories are equal, or both are absent.
bool same(const std::shared_ptr<const PlasticState>& a,
          const std::shared_ptr<const PlasticState>& b);

/// Copy of a history with fewer mirror planes, or the history itself if it has no others.
std::shared_ptr<const PlasticState> unfolded(const std::shared_ptr<const PlasticState>& history,
                                             const Grid& grid, fft::Symmetry symmetry);

}  // namespace samcontact::simulation
