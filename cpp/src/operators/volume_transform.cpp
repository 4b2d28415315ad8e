// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/volume_transform.hpp"

#include <algorithm>

namespace samcontact::operators {

using Threads = fft::PaddedTransform::Threads;

namespace {

/// A plane's spectrum, one for each thread, kept between calls.
ComplexField& plane_buffer(const fft::PaddedTransform& transform) {
  static thread_local ComplexField buffer;
  buffer.resize(transform.spectrum_size());
  return buffer;
}

}  // namespace

VolumeTransform::VolumeTransform(const Grid& grid, Symmetry symmetry, int least_mx, int least_my)
    : nx_(grid.nx),
      ny_(grid.ny),
      symmetry_(symmetry),
      whole_(nx_, ny_, fft::convolution_size(nx_, grid.period.x, least_mx),
             fft::convolution_size(ny_, grid.period.y, least_my)),
      mx_(whole_.mx()),
      my_(whole_.my()) {
  if (symmetry != Symmetry::none) {
    mirrored_ =
        std::make_unique<fft::MirroredTransform>(nx_, ny_, mx_, my_, symmetry == Symmetry::xy);
  }
}

void VolumeTransform::forward(std::span<const Plane> planes, std::size_t stride) const {
  if (mirrored_) return mirrored_->forward(planes, stride);
  // In a plane of its own: the volume's rows lie far apart, and what is transposed into them one
  // piece at a time misses the address cache each time.
  ComplexField& one = plane_buffer(whole_);
  for (const Plane& plane : planes) {
    whole_.forward(plane.values, one.data(), mx_, Threads::one);
    for (int ky = 0; ky < mh(); ++ky) {
      std::copy_n(one.data() + static_cast<std::size_t>(ky) * mx_, mx_,
                  reinterpret_cast<Complex*>(plane.spectrum + ky * stride));
    }
  }
}

void VolumeTransform::inverse(std::span<const Plane> planes, std::size_t stride) const {
  if (mirrored_) return mirrored_->inverse(planes, stride);
  ComplexField& one = plane_buffer(whole_);
  for (const Plane& plane : planes) {
    for (int ky = 0; ky < mh(); ++ky) {
      std::copy_n(reinterpret_cast<const Complex*>(plane.spectrum + ky * stride), mx_,
                  one.data() + static_cast<std::size_t>(ky) * mx_);
    }
    whole_.inverse(one.data(), plane.values, mx_, Threads::one);
  }
}

Field VolumeTransform::forward(const double* plane, kernels::Parity parity) const {
  Field spectrum(mh() * row_size());
  if (mirrored_) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): the values are only read.
    const Plane one{const_cast<double*>(plane), spectrum.data(), parity.odd_x, parity.odd_y};
    mirrored_->forward({&one, 1}, row_size());
  } else {
    whole_.forward(plane, reinterpret_cast<Complex*>(spectrum.data()), pitch(), Threads::many);
  }
  return spectrum;
}

void VolumeTransform::inverse(Field& spectrum, double* plane, kernels::Parity parity) const {
  if (mirrored_) {
    const Plane one{plane, spectrum.data(), parity.odd_x, parity.odd_y};
    mirrored_->inverse({&one, 1}, row_size());
  } else {
    whole_.inverse(reinterpret_cast<Complex*>(spectrum.data()), plane, pitch(), Threads::many);
  }
}

}  // namespace samcontact::operators
