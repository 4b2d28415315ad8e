// SPDX-License-Identifier: GPL-3.0-or-later
// Product of a spectrum with the real quarter spectrum of a kernel of known parity.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {

/// out += scale (-i)^(odd_x + odd_y) quarter in over one column ky of length mx; quarter holds kx =
/// 0..mx/2, negative kx follow from the parity in x.
void add_parity_product(const double* quarter, kernels::Parity parity, double scale,
                        const Complex* in, Complex* out, int mx);

}  // namespace samcontact::operators
