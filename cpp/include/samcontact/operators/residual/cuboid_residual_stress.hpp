// SPDX-License-Identifier: GPL-3.0-or-later
// Exact residual stress due to eigenstrain (plastic strain) in a layered box: every cuboid acts on
// every cell centre through closed-form influence coefficients.
//
// In x and y the sum is a convolution, evaluated by zero-padded transforms. Over the layers the
// full-space part depends on z - z' and the image part is sum_m z^m K_m(z + z'), m = 0, 1, 2; it is
// summed directly for each wavenumber: the tensors of a wavenumber fit into the cache and the sum
// is a product of real matrices.
#pragma once

#include <vector>

#include "samcontact/base/elastic.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/operators/residual/residual_stress.hpp"

namespace samcontact::operators {

class CuboidResidualStress : public ResidualStress {
 public:
  /// The layers of the grid start at the surface. The transform has no symmetry.
  CuboidResidualStress(const Grid& grid, const VolumeTransform& transform, const Elastic& elastic);

  void apply(VolumeSpectrum& spectrum) const override;
  Field far_field(Tensor, const double*) const override { return {}; }
  void correct(Tensor, const Field&, int, double*) const override {}

  std::size_t bytes() const override { return (full_.size() + image_.size()) * sizeof(double); }

 private:
  /// One product of the assembly: tensor[pair] += coefficient scalar[kernel].
  struct Term {
    int kernel, pair;
    double coefficient;
  };

  void build_terms(double nu, double shear_modulus);
  void build_spectra(const Grid& grid);
  void mode_block(int ky, int block, const VolumeSpectrum& strain, double* tensors,
                  double* values) const;
  void load(int ky, int block, const VolumeSpectrum& strain, double* values) const;
  void store(int ky, int block, double* values, VolumeSpectrum& stress) const;

  const VolumeTransform* transform_;
  int nz_, lanes_;  // lanes_: mx/2 + 1 rounded up to whole blocks
  double dz_;       // in units of dx
  std::vector<Term> full_terms_, image_terms_[3];
  std::vector<double> full_signs_;  // per pair: its sign if z - z' changes sign
  std::vector<double> inside_;      // per pair: term subtracted inside the source
  Field full_;                      // [ky][kernel][z - z' >= 0][lane]
  Field image_;                     // [ky][kernel][z + z'][lane]
};

}  // namespace samcontact::operators
