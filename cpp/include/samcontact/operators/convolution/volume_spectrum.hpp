// SPDX-License-Identifier: GPL-3.0-or-later
// Spectra over x and y of tensor fields in a layered box.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "samcontact/operators/convolution/volume_transform.hpp"

namespace samcontact::operators {

/// Components of a field: all six, or the five of a deviator, whose zz is -(xx + yy).
enum class Tensor { full, deviator };

/// Components in the order of the field, as indices of xx, yy, zz, yz, xz, xy.
inline std::span<const int> components(Tensor tensor) {
  static constexpr std::array<int, 6> full{0, 1, 2, 3, 4, 5};
  static constexpr std::array<int, 5> deviator{0, 1, 3, 4, 5};
  return tensor == Tensor::full ? std::span<const int>(full) : std::span<const int>(deviator);
}
inline int count(Tensor tensor) { return tensor == Tensor::full ? 6 : 5; }

/// Spectra of the components on nz layers, [ky][component][layer][kx], as the transform stores
/// them: all data of one wavenumber ky are adjacent.
struct VolumeSpectrum {
  Symmetry symmetry;
  Tensor tensor;
  int components, nz, mx, my, mh, modes, parts, pitch;
  Field data;
  /// Layers that may be non-zero; transforms and products skip the others.
  std::vector<char> used;

  /// A new spectrum is filled with zeros; a spectrum in lent memory keeps the content of the
  /// memory.
  VolumeSpectrum(const VolumeTransform& transform, int nz, Tensor tensor, Field memory = {});

  std::size_t row_size() const { return static_cast<std::size_t>(pitch) * parts; }
  std::size_t stride() const { return static_cast<std::size_t>(components) * nz * row_size(); }
  std::size_t place(int ky, int component, int layer) const {
    return ky * stride() + (static_cast<std::size_t>(component) * nz + layer) * row_size();
  }
  double* row(int ky, int component, int layer) {
    return data.data() + place(ky, component, layer);
  }
  const double* row(int ky, int component, int layer) const {
    return data.data() + place(ky, component, layer);
  }
};

/// tensor: [component][k][i][j], the components of the spectrum on the stored cells. Finds the
/// layers that are all zero and skips them.
void forward(const VolumeTransform& transform, const double* tensor, VolumeSpectrum& out);

/// One layer, [component][i][j]. Thread-safe for different layers.
void forward(const VolumeTransform& transform, const double* tensor, VolumeSpectrum& out,
             int layer);

/// One layer back to real space, [component][i][j]; destroys it in the spectrum. Thread-safe for
/// different layers. rows: as in VolumeTransform::inverse.
void inverse(const VolumeTransform& transform, VolumeSpectrum& spectrum, int layer, double* tensor,
             std::span<const fft::RowRun> rows = {});
/// All layers, [component][k][i][j].
void inverse(const VolumeTransform& transform, VolumeSpectrum& spectrum, double* tensor);

}  // namespace samcontact::operators
