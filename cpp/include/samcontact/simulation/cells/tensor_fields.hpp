// SPDX-License-Identifier: GPL-3.0-or-later
// Tensor fields of a state: parts of them, and deviators with all their components.
#pragma once

#include <cstddef>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/simulation/cells/mirror.hpp"

namespace samcontact::simulation {

/// The part of a tensor field over a box that lies in its own.
Field cut(const Field& tensor, const Box& from, const Box& to);
/// All six components of the deviator of n cells.
void complete(const double* deviator, std::size_t n, double* full);
/// All six components of a strain with those of `tensor`.
Field six_components(Field strain, operators::Tensor tensor);

/// Puts one of a stored box into that of a region, where the whole box is in it.
void put_unfolded(const Field& part, const Box& stored, fft::Symmetry symmetry, const Grid& grid,
                  const Box& region, Field& out);

}  // namespace samcontact::simulation
