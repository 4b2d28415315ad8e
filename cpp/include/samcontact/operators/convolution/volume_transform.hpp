// SPDX-License-Identifier: GPL-3.0-or-later
// Plane transforms of a box: of whole planes, or of the half or quarter on one side of the mirror
// planes. The kind of transform determines the storage of a spectrum.
#pragma once

#include <memory>

#include "samcontact/base/grid.hpp"
#include "samcontact/fft/mirrored_transform.hpp"
#include "samcontact/fft/padded_transform.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {

using fft::Symmetry;

class VolumeTransform {
 public:
  /// For the whole planes of a grid, even if only a part is stored; padded sizes are at least the
  /// given ones.
  VolumeTransform(const Grid& grid, Symmetry symmetry, int min_mx = 0, int min_my = 0);

  Symmetry symmetry() const { return symmetry_; }
  /// Stored cells of a plane.
  int nx() const { return fft::stored_cells(nx_, symmetry_ == Symmetry::xy); }
  int ny() const { return fft::stored_cells(ny_, symmetry_ != Symmetry::none); }
  std::size_t plane_size() const { return static_cast<std::size_t>(nx()) * ny(); }
  /// Padded sizes, and the stored wavenumbers: ky = 0..my/2, kx = 0..mx-1 or 0..mx/2.
  int mx() const { return mx_; }
  int my() const { return my_; }
  int mh() const { return my_ / 2 + 1; }
  int modes() const { return symmetry_ == Symmetry::none ? mx_ : mx_ / 2 + 1; }
  /// 2 for complex spectra, 1 for real ones.
  int parts() const { return symmetry_ == Symmetry::xy ? 1 : 2; }
  /// Rows of a spectrum are padded to whole blocks of `lanes` wavenumbers.
  static constexpr int lanes = 8;
  int pitch() const { return (modes() + lanes - 1) / lanes * lanes; }
  std::size_t row_size() const { return static_cast<std::size_t>(pitch()) * parts(); }

  /// Planes of the components of one layer. Spectra in rows `stride` doubles apart; on one thread.
  using Plane = fft::MirroredTransform::Plane;
  void forward(std::span<const Plane> planes, std::size_t stride) const;
  /// rows: stored rows i of the planes that are transformed back; none: all.
  void inverse(std::span<const Plane> planes, std::size_t stride,
               std::span<const fft::RowRun> rows = {}) const;

  /// One plane, even or odd in mirrored directions; the spectrum [ky][kx] in rows of row_size().
  /// Uses threads for whole planes.
  Field forward(const double* plane, kernels::Parity parity = {}) const;
  void inverse(Field& spectrum, double* plane, kernels::Parity parity = {}) const;

 private:
  int nx_, ny_;
  Symmetry symmetry_;
  fft::PaddedTransform whole_;
  int mx_, my_;
  std::unique_ptr<fft::MirroredTransform> mirrored_;
};

}  // namespace samcontact::operators
