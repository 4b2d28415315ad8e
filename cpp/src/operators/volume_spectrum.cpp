// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/volume_spectrum.hpp"

#include <algorithm>

#include "samcontact/base/interrupt.hpp"

namespace samcontact::operators {

using Threads = fft::PaddedTransform::Threads;

VolumeSpectrum::VolumeSpectrum(const fft::PaddedTransform& transform, int nz_, Tensor tensor_)
    : tensor(tensor_),
      components(count(tensor_)),
      mx(transform.mx()),
      mh(transform.mh()),
      nz(nz_),
      pitch(padded(transform.mx())),
      data(transform.mh() * stride()),
      used(nz_, 1) {}

void forward(const fft::PaddedTransform& transform, const double* tensor, VolumeSpectrum& out) {
  check_interrupt();
  const int nz = out.nz;
  const std::size_t plane = static_cast<std::size_t>(transform.nx()) * transform.ny();
  for (int k = 0; k < nz; ++k) {
    out.used[k] = 0;
    for (int c = 0; c < out.components && !out.used[k]; ++c) {
      const double* values = tensor + (static_cast<std::size_t>(c) * nz + k) * plane;
      out.used[k] = std::any_of(values, values + plane, [](double v) { return v != 0.0; });
    }
  }
#pragma omp parallel for schedule(dynamic)
  for (int ck = 0; ck < out.components * nz; ++ck) {
    if (!out.used[ck % nz]) continue;
    transform.forward(tensor + ck * plane, out.column(0, ck / nz, ck % nz), out.stride(),
                      Threads::one);
  }
}

void inverse(const fft::PaddedTransform& transform, VolumeSpectrum& spectrum, double* tensor) {
  check_interrupt();
  const int nz = spectrum.nz;
  const std::size_t plane = static_cast<std::size_t>(transform.nx()) * transform.ny();
#pragma omp parallel for schedule(dynamic)
  for (int ck = 0; ck < spectrum.components * nz; ++ck) {
    transform.inverse(spectrum.column(0, ck / nz, ck % nz), tensor + ck * plane, spectrum.stride(),
                      Threads::one);
  }
}

}  // namespace samcontact::operators
