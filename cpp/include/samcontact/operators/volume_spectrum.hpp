// SPDX-License-Identifier: GPL-3.0-or-later
// Tensor fields of a layered box in the plane's wavenumber space.
#pragma once

#include <vector>

#include "samcontact/fft/padded_transform.hpp"

namespace samcontact::operators {

/// Spectra of the six components on nz layers, [ky][component][layer][kx]: all that one wavenumber
/// ky needs lies together.
struct VolumeSpectrum {
  int mx, mh, nz;
  ComplexField data;
  /// Layers that may be non-zero; the others are skipped by transforms and products.
  std::vector<char> used;

  VolumeSpectrum(const fft::PaddedTransform& transform, int nz);

  std::size_t stride() const { return static_cast<std::size_t>(6) * nz * mx; }
  Complex* column(int ky, int component, int layer) {
    return data.data() + ky * stride() + (static_cast<std::size_t>(component) * nz + layer) * mx;
  }
  const Complex* column(int ky, int component, int layer) const {
    return const_cast<VolumeSpectrum*>(this)->column(ky, component, layer);
  }
};

/// tensor: [component][k][i][j]. Finds the layers that are all zero and skips them.
void forward(const fft::PaddedTransform& transform, const double* tensor, VolumeSpectrum& out);

/// Back to real space, all layers; destroys the spectrum.
void inverse(const fft::PaddedTransform& transform, VolumeSpectrum& spectrum, double* tensor);

}  // namespace samcontact::operators
