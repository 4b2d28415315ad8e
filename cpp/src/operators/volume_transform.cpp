// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/volume_transform.hpp"

namespace samcontact::operators {

using Threads = fft::PaddedTransform::Threads;

VolumeTransform::VolumeTransform(int nx, int ny, Symmetry symmetry, int least_mx, int least_my)
    : nx_(nx),
      ny_(ny),
      symmetry_(symmetry),
      whole_(nx, ny, least_mx, least_my),
      mx_(whole_.mx()),
      my_(whole_.my()) {
  if (symmetry != Symmetry::none) {
    mirrored_ =
        std::make_unique<fft::MirroredTransform>(nx, ny, mx_, my_, symmetry == Symmetry::xy);
  }
}

void VolumeTransform::forward(std::span<const Plane> planes, std::size_t stride) const {
  if (mirrored_) return mirrored_->forward(planes, stride);
  for (const Plane& plane : planes) {
    whole_.forward(plane.values, reinterpret_cast<Complex*>(plane.spectrum), stride / 2,
                   Threads::one);
  }
}

void VolumeTransform::inverse(std::span<const Plane> planes, std::size_t stride) const {
  if (mirrored_) return mirrored_->inverse(planes, stride);
  for (const Plane& plane : planes) {
    whole_.inverse(reinterpret_cast<Complex*>(plane.spectrum), plane.values, stride / 2,
                   Threads::one);
  }
}

Field VolumeTransform::forward(const double* plane) const {
  Field spectrum(mh() * row_size());
  if (mirrored_) {
    // The values are only read.
    const Plane one{const_cast<double*>(plane), spectrum.data(), false, false};
    mirrored_->forward({&one, 1}, row_size());
  } else {
    whole_.forward(plane, reinterpret_cast<Complex*>(spectrum.data()), pitch(), Threads::many);
  }
  return spectrum;
}

void VolumeTransform::inverse(Field& spectrum, double* plane) const {
  if (mirrored_) {
    const Plane one{plane, spectrum.data(), false, false};
    mirrored_->inverse({&one, 1}, row_size());
  } else {
    whole_.inverse(reinterpret_cast<Complex*>(spectrum.data()), plane, pitch(), Threads::many);
  }
}

}  // namespace samcontact::operators
