// SPDX-License-Identifier: GPL-3.0-or-later
// Product of a spectrum with the real quarter spectrum of a kernel of known parity.
#pragma once

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/convolution/volume_transform.hpp"

namespace samcontact::operators {

/// out += scale (-i)^(odd_x + odd_y) quarter in over one column ky of length mx; quarter holds kx =
/// 0..mx/2, negative kx follow from the parity in x.
void add_parity_product(const double* quarter, kernels::Parity parity, double scale,
                        const Complex* in, Complex* out, int mx);

/// Counterpart for one row of the spectra of a VolumeTransform: parity refers to the kernel; both
/// spectra are stored with a factor (-i) for each mirrored direction in which the field is odd. The
/// scale includes mirror_sign().
void add_parity_product(const double* quarter, kernels::Parity parity, double scale,
                        const double* in, double* out, const VolumeTransform& transform);

/// Factor -1 for each mirrored direction in which both kernel and input are odd.
double mirror_sign(Symmetry symmetry, kernels::Parity kernel, kernels::Parity input);

/// Copies spectra of kernels [..][layer][kx], of hx wavenumbers each, into spectra of more layers.
void copy_layers(const Field& from, int from_layers, Field& to, int to_layers, int hx);

}  // namespace samcontact::operators
