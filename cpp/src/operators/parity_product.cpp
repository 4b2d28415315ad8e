// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/parity_product.hpp"

#include <algorithm>

namespace samcontact::operators {
namespace {

template <int Turns>
Complex times_minus_i(Complex z) {
  if constexpr (Turns == 0) return z;
  if constexpr (Turns == 1) return {z.imag(), -z.real()};
  return -z;
}

template <int Turns>
void add_product(const double* quarter, double scale, const Complex* in, Complex* out, int count) {
  for (int k = 0; k < count; ++k) out[k] += scale * quarter[k] * times_minus_i<Turns>(in[k]);
}

template <int Turns>
void add_mirrored_product(const double* quarter, double scale, double mirrored, const Complex* in,
                          Complex* out, int mx) {
  add_product<Turns>(quarter, scale, in, out, mx / 2 + 1);
  const double s = scale * mirrored;
  for (int k = mx / 2 + 1; k < mx; ++k) {
    out[k] += s * quarter[mx - k] * times_minus_i<Turns>(in[k]);
  }
}

}  // namespace

void add_parity_product(const double* quarter, kernels::Parity parity, double scale,
                        const Complex* in, Complex* out, int mx) {
  const double mirrored = parity.odd_x ? -1.0 : 1.0;
  switch (parity.odd_x + parity.odd_y) {
    case 0:
      return add_mirrored_product<0>(quarter, scale, mirrored, in, out, mx);
    case 1:
      return add_mirrored_product<1>(quarter, scale, mirrored, in, out, mx);
    default:
      return add_mirrored_product<2>(quarter, scale, mirrored, in, out, mx);
  }
}

void add_parity_product(const double* quarter, kernels::Parity parity, double scale,
                        const double* in, double* out, const VolumeTransform& transform) {
  const int modes = transform.modes();
  const auto* from = reinterpret_cast<const Complex*>(in);
  auto* to = reinterpret_cast<Complex*>(out);
  switch (transform.symmetry()) {
    case Symmetry::none:
      return add_parity_product(quarter, parity, scale, from, to, transform.mx());
    case Symmetry::y:
      return parity.odd_x ? add_product<1>(quarter, scale, from, to, modes)
                          : add_product<0>(quarter, scale, from, to, modes);
    default:
      for (int k = 0; k < modes; ++k) out[k] += scale * quarter[k] * in[k];
  }
}

void copy_layers(const Field& from, int from_layers, Field& to, int to_layers, int hx) {
  const std::size_t row = static_cast<std::size_t>(from_layers) * hx;
  const std::size_t step = static_cast<std::size_t>(to_layers) * hx;
  auto out = to.begin();
  for (auto in = from.begin(); in != from.end(); in += row, out += step) {
    std::copy_n(in, row, out);
  }
}

double mirror_sign(Symmetry symmetry, kernels::Parity kernel, kernels::Parity input) {
  const bool y = symmetry != Symmetry::none && kernel.odd_y && input.odd_y;
  const bool x = symmetry == Symmetry::xy && kernel.odd_x && input.odd_x;
  return x != y ? -1.0 : 1.0;
}

}  // namespace samcontact::operators
