// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the tensor fields of a state, and conversion from deviators to all six components.
#pragma once

#include <cstddef>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/simulation/cells/mirror.hpp"

namespace samcontact::simulation {

/// Part of a tensor field over a box inside its own box.
Field cut(const Field& tensor, const Box& from, const Box& to);
/// All six components of the deviators of n cells.
void complete(const double* deviator, std::size_t n, double* full);
/// All six components of a strain that is stored with the components of `tensor`.
Field six_components(Field strain, operators::Tensor tensor);

/// Copies a field over a stored box, with its mirror images, into a field over a region.
void put_unfolded(const Field& part, const Box& stored, fft::Symmetry symmetry, const Grid& grid,
                  const Box& region, Field& out);

}  // namespace samcontact::simulation
