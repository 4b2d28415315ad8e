// SPDX-License-Identifier: GPL-3.0-or-later
// Discrete convolution of a surface field with kernels of known parity (DC-FFT, Liu, Wang & Liu
// 2000, doi:10.1016/S0043-1648(00)00427-0).
#pragma once

#include <span>

#include "samcontact/base/grid.hpp"
#include "samcontact/fft/padded_transform.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {

/// Offsets 0..nx-1, 0..ny-1 at which a convolution needs its kernels.
struct KernelOffsets {
  int nx, ny;
  /// For planes of a grid, transformed on mx x my points.
  KernelOffsets(const Grid& grid, int mx, int my);
  KernelOffsets(int nx_, int ny_) : nx(nx_), ny(ny_) {}
};

/// Kernel that is even or odd in x and in y: table [j][i] of offsets >= 0, or its spectrum.
struct ParityKernel {
  kernels::Parity parity;
  Field quarter;
};

/// Kernel from one component of the input field to one component of the output field.
struct MatrixKernel {
  int out = 0, in = 0;
  ParityKernel kernel;
};

/// The same with a kernel that is kept elsewhere.
struct MatrixKernelRef {
  int out, in;
  const ParityKernel* kernel;
};

class SurfaceConvolution {
 public:
  explicit SurfaceConvolution(const Grid& grid);
  /// Periodic on mx x my cells, even numbers not less than the grid. If they are less than full
  /// padding, each cell acts through its nearest image.
  SurfaceConvolution(const Grid& grid, int mx, int my);

  int mx() const { return transform_.mx(); }
  int my() const { return transform_.my(); }

  const KernelOffsets& offsets() const { return offsets_; }

  /// Replaces the table of offsets() by its real quarter spectrum.
  void transform(ParityKernel& kernel) const;

  /// out = convolution of `in` with the sum of transformed kernels, both [i][j]; `out` and `in` may
  /// be one array. `work` is scratch that the caller keeps from call to call.
  void apply(std::span<const ParityKernel> kernels, const double* in, double* out,
             ComplexField& work) const;
  /// Convolution of `inputs` consecutive fields to `outputs` fields.
  void apply(std::span<const MatrixKernel> kernels, int inputs, const double* in, int outputs,
             double* out, ComplexField& work) const;
  void apply(std::span<const MatrixKernelRef> kernels, int inputs, const double* in, int outputs,
             double* out, ComplexField& work) const;

  /// Operations of one application from one input to one output field, in units of
  /// fft::filter_cost.
  double cost() const;

 private:
  void multiply(const ParityKernel& kernel, int ky, const Complex* in, Complex* out) const;

  fft::PaddedTransform transform_;
  KernelOffsets offsets_;
};

}  // namespace samcontact::operators
