// SPDX-License-Identifier: GPL-3.0-or-later
// Stress at given depths due to pressure, the proportional heat, and shear on the surface: exact
// coefficients by DC-FFT.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/operators/heat/heat_stress.hpp"
#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// Quarter spectra per component and depth of each part of the stress; those of a depth are built
/// on first use. Thread-safe.
class TractionStress {
 public:
  /// heat: proportional to the pressure; null: none.
  TractionStress(const Grid& grid, const VolumeTransform& transform, SharedMedium medium,
                 std::shared_ptr<const HeatStress> heat, std::vector<double> depths, Tensor tensor);

  /// out += stress due to tractions [i][j], their shear multiplied by shear_sign, at the first
  /// out.nz depths; their parities in mirrors are those of the components of a vector
  /// (vector_parity()). All layers of `out` are then marked as used. shallower: operator of the
  /// first depths whose spectra are shared; null: no such operator. first: layers above it are left
  /// out.
  void add(const Tractions& tractions, double shear_sign, VolumeSpectrum& out,
           const TractionStress* shallower = nullptr, int first = 0) const;

  /// Spectra of tractions by kind, empty for those that are absent.
  using Spectra = std::array<Field, all_tractions.size()>;
  Spectra spectra(const Tractions& tractions) const;
  /// Builds the missing kernels of tractions with these spectra at depths given by their indices.
  void prepare(const Spectra& tractions, std::span<const int> depths,
               const TractionStress* shallower = nullptr) const;
  /// out += stress at one depth, in the only layer of `out`.
  void add_depth(const Spectra& tractions, double shear_sign, int depth, VolumeSpectrum& out) const;

  int layers() const { return static_cast<int>(depths_.size()); }
  std::size_t bytes() const;

 private:
  /// Parts with spectra of their own. Heat at rest is included in those of the pressure; heat of a
  /// moving source has further parts with the opposite parity in x, in y, or in both.
  enum class Part { pressure, heat_x, heat_y, heat_xy, shear_x, shear_y };
  static constexpr int part_count = 6;
  static kernels::Parity parity(Part part, int component);
  std::vector<Part> parts(Traction traction) const;

  /// Depths first..last-1.
  struct Depths {
    int first, last;
  };

  /// Builds the missing kernels of a traction.
  void prepare(Traction traction, std::span<const int> depths,
               const TractionStress* shallower) const;
  /// heat: at the depth, empty without heat.
  Field build(Part part, int k, const std::vector<ParityParts>& heat,
              const fft::ParitySpectrum& spectrum) const;
  /// Adds the stress due to the spectrum of a traction with the given parity in mirrored
  /// directions; the first depth becomes layer `to`.
  void add(Part part, kernels::Parity input, const Field& traction, double scale, Depths depths,
           VolumeSpectrum& out, int to) const;
  void add(const Spectra& tractions, double shear_sign, Depths depths, VolumeSpectrum& out,
           int to) const;

  Grid grid_;
  const VolumeTransform* transform_;
  SharedMedium medium_;
  std::shared_ptr<const HeatStress> heat_;
  std::vector<double> depths_;
  Tensor tensor_;
  mutable std::mutex mutex_;
  /// By part and depth, [ky][component][kx <= mx/2]; null: not built.
  using Kernels = std::vector<std::shared_ptr<const Field>>;
  mutable std::array<Kernels, part_count> kernels_;
};

/// Stress [component][depth][i][j] [Pa] due to tractions at any depths.
Field traction_stress(const Grid& grid, const SharedMedium& medium, const Heating& heating,
                      std::span<const double> depths, const Tractions& tractions);

}  // namespace samcontact::operators
