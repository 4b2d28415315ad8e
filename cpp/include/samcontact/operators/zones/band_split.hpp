// SPDX-License-Identifier: GPL-3.0-or-later
// How operators are split in bands: docs/theory/zones.md.
#pragma once

namespace samcontact::operators {

enum class Band { near, middle, far };

/// The defaults are those of all simulations; finer splits tell what they leave out.
struct BandSplit {
  /// Cells between the nodes of middle and far lattices: even numbers, one times the other.
  int middle_spacing = 2, far_spacing = 8;
  /// Cells beyond which the near band has no influence, and where tables of the middle one end,
  /// which are more than those of the near one.
  int near_range = 6, middle_range = 18;
  /// a of g for middle and far nodes: the larger, the less aliases and the longer the range.
  double middle_sharpness = 1.6, far_sharpness = 1.5;
  /// Part of the highest wavenumber of a lattice where its band of residual stress is gone, and up
  /// to which it holds tables as they are.
  double gone_at = 0.9, clear_band = 0.8;
  /// Nodes that a cell reaches: 4, 6, 8 or 10.
  int window_width = 6;
  /// Cells of the ring around a zone, near_range of one that stands alone, where others are close:
  /// beyond, the near band is 1e-2 of what it is at its range.
  int wide_ring = 10;
  /// Part of the ring from which on the strain in it fades out.
  double ring_fades_from = 0.75;
  /// Nodes between the ends of the middle plane, and those at the end of the far lattice that must
  /// stay empty: there its tables fade out.
  int middle_ring = 10, fading_nodes = 6;
  /// Cells of depth below which strain does not move the surface by near and middle bands.
  double near_moves = 12.0, middle_moves = 30.0;
  /// Cells of depth below which tractions do not stress the body by near and middle bands.
  double near_stressed = 18.0, middle_stressed = 60.0;
  /// Cells of depth below which the bound of the stress of tractions goes without these bands.
  double near_bound = 10.0, middle_bound = 28.0;

  /// Cells between the nodes of a band.
  int spacing(Band band) const {
    return band == Band::near ? 1 : band == Band::middle ? middle_spacing : far_spacing;
  }
  bool operator==(const BandSplit&) const = default;
};

/// Throws std::invalid_argument.
void require_valid(const BandSplit& split);

}  // namespace samcontact::operators
