// SPDX-License-Identifier: GPL-3.0-or-later
// One block of wavenumbers of the fast residual stress: sweeps upwards and downwards through the
// cells of each layer of the body, and the waves between its interfaces, eqs. (25), (26) and (44)
// to (46) of docs/theory/layers.md.
#pragma once

#include "samcontact/operators/convolution/volume_transform.hpp"
#include "samcontact/operators/residual/swept_stack.hpp"

namespace samcontact::operators::layers {

// Wavenumbers handled together: one AVX-512 register of doubles.
inline constexpr int width = VolumeTransform::lanes;

/// Where the numbers of a tensor lie.
struct Layout {
  int nz;  // layers of cells, at most those of the body; below there is no strain
  bool deviator;
  /// By how many quarter turns the stored xx, yy, zz, yz, xz, xy differ from the turned ones.
  int turns[6];
  std::size_t component_step, layer_step;  // of the spectrum, in doubles
};

/// Where the stress of a block goes, and what is added to it.
struct Target {
  Layout layout;
  double* values;
  Layout more_layout;
  const double* more;  // may be null
};

/// What a sweep needs for itself.
struct Scratch {
  Scratch(const SweptStack& stack, int parts);
  Field turned, below;      // [layer of cells][part]
  Field interfaces, waves;  // [layer of the body], with [part]
};

/// Stress of the strain of one block of wavenumbers, of parts (2: re and im, 1: real) numbers each;
/// target may be where the strain is. used: of each layer of cells, whether it has strain; row: the
/// numbers of the block, `step` apart; values: its row of component 0 and layer 0.
void sweep(const SweptStack& stack, int parts, const Layout& layout, const char* used,
           const double* row, int step, const double* values, const Target& target,
           Scratch& scratch);

}  // namespace samcontact::operators::layers
