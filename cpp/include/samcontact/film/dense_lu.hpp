// SPDX-License-Identifier: GPL-3.0-or-later
// LU decomposition of the first columns of a dense matrix in single precision.
#pragma once

#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/film/dense_products.hpp"

namespace samcontact::film {

using Singles = std::vector<float, AlignedAllocator<float>>;

/// Eliminates the first columns of a square matrix, as many as there are pivots: L and U are in
/// place of these columns and rows, the Schur complement in place of the rest. Pivots are on the
/// diagonal as far as possible; the first rows that are free may exchange places, if their largest
/// coefficients are near one. pivots: becomes the row that each row is exchanged with. Returns
/// whether the pivots of the other rows differ from zero.
bool eliminate(const DenseView& matrix, const char* free, std::vector<int>& pivots);

}  // namespace samcontact::film
