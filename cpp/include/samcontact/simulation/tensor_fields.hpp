// SPDX-License-Identifier: GPL-3.0-or-later
// Tensor fields of a state: parts of them, and deviators with all their components.
#pragma once

#include <cstddef>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/operators/volume_spectrum.hpp"

namespace samcontact::simulation {

/// The part of a tensor field over a box that lies in its own.
Field cut(const Field& tensor, const Box& from, const Box& to);
/// All six components of the deviator of n cells.
void complete(const double* deviator, std::size_t n, double* full);
/// All six components of a strain with those of `tensor`.
Field six_components(Field strain, operators::Tensor tensor);

}  // namespace samcontact::simulation
