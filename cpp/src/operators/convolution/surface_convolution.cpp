// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/convolution/surface_convolution.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/fft/periodic_transform.hpp"
#include "samcontact/operators/convolution/parity_product.hpp"

namespace samcontact::operators {
namespace {

/// Half of a period to each side; a single cell that is repeated periodically has one offset.
int offsets_of(int cells, int period, int size) {
  if (size == period && period > 1) return period / 2 + 1;
  return size < 2 * cells - 1 ? size / 2 + 1 : cells;
}

}  // namespace

KernelOffsets::KernelOffsets(const Grid& grid, int mx, int my)
    : nx(offsets_of(grid.nx, grid.period.x, mx)), ny(offsets_of(grid.ny, grid.period.y, my)) {}

SurfaceConvolution::SurfaceConvolution(const Grid& grid)
    : SurfaceConvolution(grid, fft::convolution_size(grid.nx, grid.period.x),
                         fft::convolution_size(grid.ny, grid.period.y)) {}

SurfaceConvolution::SurfaceConvolution(const Grid& grid, int mx, int my)
    : transform_(grid.nx, grid.ny, mx, my), offsets_(grid, mx, my) {}

void SurfaceConvolution::transform(ParityKernel& kernel) const {
  const fft::ParitySpectrum spectrum(transform_);
  const auto [nx, ny] = offsets_;
  Field quarter(spectrum.size(), 0.0);
  for (int j = 0; j < ny; ++j) {
    std::copy_n(kernel.quarter.data() + static_cast<std::size_t>(j) * nx, nx,
                quarter.data() + static_cast<std::size_t>(j) * spectrum.hx());
  }
  spectrum.transform(quarter.data(), kernel.parity.odd_x, kernel.parity.odd_y);
  kernel.quarter = std::move(quarter);
}

void SurfaceConvolution::multiply(const ParityKernel& kernel, int ky, const Complex* in,
                                  Complex* out) const {
  const int mx = transform_.mx(), hx = mx / 2 + 1;
  add_parity_product(kernel.quarter.data() + static_cast<std::size_t>(ky) * hx, kernel.parity, 1.0,
                     in, out, mx);
}

void SurfaceConvolution::apply(std::span<const ParityKernel> kernels, const double* in, double* out,
                               ComplexField& work) const {
  const auto product = [&](int ky, const Complex* from, Complex* to) {
    std::fill_n(to, transform_.mx(), Complex{});
    for (const ParityKernel& kernel : kernels) multiply(kernel, ky, from, to);
  };
  transform_.filter(in, 1, product, 1, out, work);
}

void SurfaceConvolution::apply(std::span<const MatrixKernel> kernels, int inputs, const double* in,
                               int outputs, double* out, ComplexField& work) const {
  std::vector<MatrixKernelRef> refs;
  for (const MatrixKernel& own : kernels) refs.push_back({own.out, own.in, &own.kernel});
  apply(refs, inputs, in, outputs, out, work);
}

void SurfaceConvolution::apply(std::span<const MatrixKernelRef> kernels, int inputs,
                               const double* in, int outputs, double* out,
                               ComplexField& work) const {
  const std::ptrdiff_t mx = transform_.mx();
  const auto product = [&](int ky, const Complex* from, Complex* to) {
    std::fill_n(to, outputs * mx, Complex{});
    for (const auto& [at, of, kernel] : kernels) {
      multiply(*kernel, ky, from + of * mx, to + at * mx);
    }
  };
  transform_.filter(in, inputs, product, outputs, out, work);
}

double SurfaceConvolution::cost() const {
  return fft::filter_cost(transform_.nx(), transform_.mx(), transform_.my());
}

}  // namespace samcontact::operators
