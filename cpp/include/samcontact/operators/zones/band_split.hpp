// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of the band decomposition of operators: docs/theory/zones.md.
#pragma once

namespace samcontact::operators {

enum class Band { near, middle, far };

/// All simulations use the defaults; finer decompositions measure the error of the defaults.
struct BandSplit {
  /// Spacing of the middle and far nodes [cells]: even numbers, the second an even multiple of the
  /// first.
  int middle_spacing = 2, far_spacing = 8;
  /// Range of the near band, and extent of the tables of the middle band, which is larger [cells].
  int near_range = 6, middle_range = 18;
  /// Parameter a of the filter g for middle and far nodes: larger values mean less aliasing and a
  /// longer range.
  double middle_sharpness = 1.6, far_sharpness = 1.5;
  /// Filter of a lattice as fractions of its highest wavenumber: cutoff of the band of residual
  /// stress, and end of the passband in which tables are represented exactly.
  double cutoff_fraction = 0.9, passband_fraction = 0.8;
  /// Number of nodes of the spreading window: 4, 6, 8 or 10.
  int window_width = 6;
  /// Margin around a zone with other zones nearby [cells]; near_range for an isolated zone. Beyond
  /// it the near band is 1e-2 of its value at its range.
  int wide_margin = 10;
  /// Fraction of the margin beyond which the strain in it fades out.
  double margin_fade_fraction = 0.75;
  /// Number of nodes between the ends of the middle plane, and number of nodes at the end of the
  /// far lattice that must stay empty, where its tables fade out.
  int middle_gap = 10, fading_nodes = 6;
  /// Depths below which strain has no surface displacement by the near and middle bands [cells].
  double near_displacement_depth = 12.0, middle_displacement_depth = 30.0;
  /// Depths below which tractions cause no stress by the near and middle bands [cells].
  double near_stress_depth = 18.0, middle_stress_depth = 60.0;
  /// Depths below which the bound of the stress due to tractions omits these bands [cells].
  double near_bound_depth = 10.0, middle_bound_depth = 28.0;

  /// Spacing of the nodes of a band [cells].
  int spacing(Band band) const {
    return band == Band::near ? 1 : band == Band::middle ? middle_spacing : far_spacing;
  }
  bool operator==(const BandSplit&) const = default;
};

/// Throws std::invalid_argument.
void require_valid(const BandSplit& split);

}  // namespace samcontact::operators
