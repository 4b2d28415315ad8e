// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/fft/periodic_transform.hpp"

#include <cmath>

#include "samcontact/base/multiversion.hpp"
#include "samcontact/fft/parity_spectrum.hpp"

namespace samcontact::fft {
namespace {

/// Complex numbers interleaved; the factors of the later half are those of the earlier one.
SAMCONTACT_MULTIVERSION
void multiply(const double* factors, std::ptrdiff_t mx, const double* in, double* out) {
  for (std::ptrdiff_t k = 0; k <= mx / 2; ++k) {
    out[2 * k] = factors[k] * in[2 * k];
    out[2 * k + 1] = factors[k] * in[2 * k + 1];
  }
  for (std::ptrdiff_t k = mx / 2 + 1; k < mx; ++k) {
    out[2 * k] = factors[mx - k] * in[2 * k];
    out[2 * k + 1] = factors[mx - k] * in[2 * k + 1];
  }
}

}  // namespace

double filter_cost(int nx, int mx, int my) {
  return 0.5 * nx * my * std::log2(my) + (0.5 * my + 1) * mx * std::log2(mx);
}

double PeriodicTransform::cost() const { return filter_cost(nx(), mx(), my()); }

void PeriodicTransform::spectrum(double* quarter) const {
  ParitySpectrum(mx(), my()).transform(quarter, false, false);
}

void PeriodicTransform::filter(const double* in, const double* quarter, double* out,
                               ComplexField& work) const {
  const auto product = [&](int ky, const Complex* from, Complex* to) {
    multiply(quarter + static_cast<std::size_t>(ky) * hx(), mx(),
             reinterpret_cast<const double*>(from), reinterpret_cast<double*>(to));
  };
  plane_.filter(in, 1, product, 1, out, work);
}

}  // namespace samcontact::fft
