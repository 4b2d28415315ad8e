// SPDX-License-Identifier: GPL-3.0-or-later
// Fast residual stress of one block of wavenumbers: sweeps upwards and downwards through the cells
// of each layer of the body, and modes between its interfaces, eqs. (25), (26) and (44) to (46) of
// docs/theory/layers.md.
#pragma once

#include "samcontact/operators/convolution/volume_transform.hpp"
#include "samcontact/operators/residual/swept_stack.hpp"

namespace samcontact::operators::layers {

/// Wavenumbers handled together: one AVX2 register of doubles. Compilers keep wider vectors in
/// memory on machines without AVX-512.
inline constexpr int width = 4;
static_assert(VolumeTransform::lanes % width == 0);

/// Storage of a tensor in a spectrum.
struct Layout {
  int nz;  // layers of cells, at most those of the body; there is no strain below
  bool deviator;
  /// Number of quarter turns by which the stored xx, yy, zz, yz, xz, xy differ from the rotated
  /// ones.
  int turns[6];
  std::size_t component_step, layer_step;  // of the spectrum, in doubles
};

/// Destination of the stress of a block, and the stress that is added to it.
struct Target {
  Layout layout;
  double* values;
  Layout more_layout;
  const double* more;  // may be null
};

/// Work space of a sweep.
struct Scratch {
  Scratch(const SweptStack& stack, int parts);
  Field rotated, below;     // [layer of cells][part]
  Field interfaces, waves;  // [layer of the body], with [part]
};

/// Stress due to the strain of one block of wavenumbers, with `parts` numbers each (2: re and im,
/// 1: real); target may be where the strain is. used: whether each layer of cells has strain; row:
/// the coefficients of the block, `step` apart; values: its row of component 0 and layer 0.
void sweep(const SweptStack& stack, int parts, const Layout& layout, const char* used,
           const double* row, int step, const double* values, const Target& target,
           Scratch& scratch);

}  // namespace samcontact::operators::layers
