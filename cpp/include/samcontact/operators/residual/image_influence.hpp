// SPDX-License-Identifier: GPL-3.0-or-later
// What the images of coarse cells do to coarse cells, of any body: from its waves, those of the
// lattice of images less all others.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/operators/periodic/lattice_modes.hpp"
#include "samcontact/operators/residual/swept_stack.hpp"

namespace samcontact::operators {

/// Stress components are padded to whole registers.
inline constexpr int image_row = 8;

/// Mean stress over the depth of each coarse layer at the centres of cells under unit eigenstrain
/// in the images of each cell [Pa]: [field layer][source layer][y offset][x offset][in][out,
/// padded], offsets from -(cells - 1) on. tol: relative to the largest stress of a cell upon
/// itself.
Field image_influence(const layers::SweptStack& coarse, const LatticeAxis& x, const LatticeAxis& y,
                      double tol);

}  // namespace samcontact::operators
