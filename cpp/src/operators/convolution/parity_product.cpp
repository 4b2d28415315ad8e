// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/convolution/parity_product.hpp"

#include <algorithm>
#include <cstddef>

#include "samcontact/base/multiversion.hpp"

namespace samcontact::operators {
namespace {

SAMCONTACT_MULTIVERSION
void add_real_product(const double* quarter, double scale, const double* in, double* out,
                      int count) {
  for (int k = 0; k < count; ++k) out[k] += scale * quarter[k] * in[k];
}

/// out += scale quarter in, complex numbers interleaved, and the product times -i; quarters in
/// ascending or descending order from the given one.
SAMCONTACT_MULTIVERSION
void add_product(const double* quarter, double scale, const double* in, double* out, int count) {
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const double factor = scale * quarter[k];
    out[2 * k] += factor * in[2 * k];
    out[2 * k + 1] += factor * in[2 * k + 1];
  }
}

SAMCONTACT_MULTIVERSION
void add_rotated_product(const double* quarter, double scale, const double* in, double* out,
                         int count) {
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const double factor = scale * quarter[k];
    out[2 * k] += factor * in[2 * k + 1];
    out[2 * k + 1] -= factor * in[2 * k];
  }
}

SAMCONTACT_MULTIVERSION
void add_product_down(const double* quarter, double scale, const double* in, double* out,
                      int count) {
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const double factor = scale * quarter[-k];
    out[2 * k] += factor * in[2 * k];
    out[2 * k + 1] += factor * in[2 * k + 1];
  }
}

SAMCONTACT_MULTIVERSION
void add_rotated_product_down(const double* quarter, double scale, const double* in, double* out,
                              int count) {
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const double factor = scale * quarter[-k];
    out[2 * k] += factor * in[2 * k + 1];
    out[2 * k + 1] -= factor * in[2 * k];
  }
}

}  // namespace

void add_parity_product(const double* quarter, kernels::Parity parity, double scale,
                        const Complex* in, Complex* out, int mx) {
  const bool rotated = parity.odd_x != parity.odd_y;
  if (parity.odd_x && parity.odd_y) scale = -scale;
  const double mirrored = parity.odd_x ? -scale : scale;
  const auto* from = reinterpret_cast<const double*>(in);
  auto* to = reinterpret_cast<double*>(out);
  const int first = mx / 2 + 1, rest = mx - first;
  const std::ptrdiff_t mirror = 2 * static_cast<std::ptrdiff_t>(first);
  const auto up = rotated ? add_rotated_product : add_product;
  const auto down = rotated ? add_rotated_product_down : add_product_down;
  up(quarter, scale, from, to, first);
  down(quarter + rest, mirrored, from + mirror, to + mirror, rest);
}

void add_parity_product(const double* quarter, kernels::Parity parity, double scale,
                        const double* in, double* out, const VolumeTransform& transform) {
  const int modes = transform.modes();
  switch (transform.symmetry()) {
    case Symmetry::none:
      return add_parity_product(quarter, parity, scale, reinterpret_cast<const Complex*>(in),
                                reinterpret_cast<Complex*>(out), transform.mx());
    case Symmetry::y:
      return parity.odd_x ? add_rotated_product(quarter, scale, in, out, modes)
                          : add_product(quarter, scale, in, out, modes);
    default:
      return add_real_product(quarter, scale, in, out, modes);
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
