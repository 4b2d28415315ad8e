// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/convolution/volume_transform.hpp"

namespace samcontact::operators {

using Threads = fft::PaddedTransform::Threads;

namespace {

/// Spectrum of a plane, one per thread, kept between calls.
ComplexField& plane_buffer() {
  static thread_local ComplexField buffer;
  return buffer;
}

}  // namespace

VolumeTransform::VolumeTransform(const Grid& grid, Symmetry symmetry, int min_mx, int min_my)
    : nx_(grid.nx),
      ny_(grid.ny),
      symmetry_(symmetry),
      whole_(nx_, ny_, fft::convolution_size(nx_, grid.period.x, min_mx),
             fft::convolution_size(ny_, grid.period.y, min_my)),
      mx_(whole_.mx()),
      my_(whole_.my()) {
  if (symmetry != Symmetry::none) {
    mirrored_ =
        std::make_unique<fft::MirroredTransform>(nx_, ny_, mx_, my_, symmetry == Symmetry::xy);
  }
}

void VolumeTransform::forward(std::span<const Plane> planes, std::size_t stride) const {
  if (mirrored_) return mirrored_->forward(planes, stride);
  // Transposed in a separate plane: the rows of the volume are far apart, and writing them piece by
  // piece misses the address cache each time.
  ComplexField& lent = plane_buffer();
  for (const Plane& plane : planes) {
    whole_.forward(plane.values, lent, reinterpret_cast<Complex*>(plane.spectrum), stride / 2);
  }
}

void VolumeTransform::inverse(std::span<const Plane> planes, std::size_t stride,
                              std::span<const fft::RowRun> rows) const {
  if (mirrored_) return mirrored_->inverse(planes, stride, rows);
  const fft::RowRun all{0, nx_};
  if (rows.empty()) rows = {&all, 1};
  ComplexField& lent = plane_buffer();
  for (const Plane& plane : planes) {
    whole_.inverse(reinterpret_cast<const Complex*>(plane.spectrum), stride / 2, lent, rows,
                   plane.values);
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
