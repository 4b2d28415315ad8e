// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/parity_product.hpp"

namespace samcontact::operators {
namespace {

template <int Turns>
Complex times_minus_i(Complex z) {
  if constexpr (Turns == 0) return z;
  if constexpr (Turns == 1) return {z.imag(), -z.real()};
  return -z;
}

template <int Turns>
void add_product(const double* quarter, double scale, double mirrored, const Complex* in,
                 Complex* out, int mx) {
  const int half = mx / 2;
  for (int k = 0; k <= half; ++k) out[k] += scale * quarter[k] * times_minus_i<Turns>(in[k]);
  const double s = scale * mirrored;
  for (int k = half + 1; k < mx; ++k) out[k] += s * quarter[mx - k] * times_minus_i<Turns>(in[k]);
}

}  // namespace

void add_parity_product(const double* quarter, kernels::Parity parity, double scale,
                        const Complex* in, Complex* out, int mx) {
  const double mirrored = parity.odd_x ? -1.0 : 1.0;
  switch (parity.odd_x + parity.odd_y) {
    case 0:
      return add_product<0>(quarter, scale, mirrored, in, out, mx);
    case 1:
      return add_product<1>(quarter, scale, mirrored, in, out, mx);
    default:
      return add_product<2>(quarter, scale, mirrored, in, out, mx);
  }
}

}  // namespace samcontact::operators
