// SPDX-License-Identifier: GPL-3.0-or-later
// Influence of the images of coarse cells on coarse cells, for any body: from its Fourier modes, as
// the sum over the modes of the lattice minus the integral over all modes.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/operators/periodic/lattice_modes.hpp"
#include "samcontact/operators/residual/swept_stack.hpp"

namespace samcontact::operators {

/// Stress components are padded to whole registers.
inline constexpr int image_row = 8;

/// Mean stress over the depth of each coarse layer at the centres of cells due to unit eigenstrain
/// in the images of each cell [Pa]: [field layer][source layer][y offset][x offset][in][out,
/// padded], offsets from -(cells - 1) on. tol: relative to the largest stress of a cell due to its
/// own eigenstrain.
Field image_influence(const layers::SweptStack& coarse, const LatticeAxis& x, const LatticeAxis& y,
                      double tol);

}  // namespace samcontact::operators
