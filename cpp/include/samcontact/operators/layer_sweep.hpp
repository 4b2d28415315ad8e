// SPDX-License-Identifier: GPL-3.0-or-later
// One block of wavenumbers of the fast residual stress: a sweep upwards over the layers, and one
// downwards, eqs. (23) to (25) of docs/theory.md.
#pragma once

#include "samcontact/operators/volume_transform.hpp"

namespace samcontact::operators::layers {

// Wavenumbers handled together: one AVX-512 register of doubles.
inline constexpr int width = VolumeTransform::lanes;
/// Numbers that are kept of each wavenumber.
inline constexpr int coefficients = 11;

/// Writes them, `step` apart. kx, ky: the wavevector [1/m]; h: the layers' thickness [m]; weight:
/// share of an alias in the operator.
void fill_mode(double kx, double ky, double h, double weight, double* mode, int step);

/// What depends on the material; lame and twice_mu carry the normalisation of the transforms.
struct Constants {
  double nu, kappa, ratio, lame, twice_mu;
};

/// Where the numbers of a tensor lie.
struct Layout {
  int nz;
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

/// What a sweep over nz layers needs for itself.
struct Scratch {
  Scratch(int nz, int parts);
  Field turned, below;  // [layer][part]
};

/// Stress of the strain of one block of wavenumbers, of parts (2: re and im, 1: real) numbers each;
/// target may be where the strain is. used: of each layer, whether it has strain; row: the
/// coefficients of the block, `step` apart; values: its row of component 0 and layer 0.
void sweep(int parts, const Layout& layout, const char* used, const double* row, int step,
           const Constants& constants, const double* values, const Target& target,
           Scratch& scratch);

}  // namespace samcontact::operators::layers
