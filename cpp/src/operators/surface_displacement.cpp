// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface_displacement.hpp"

#include <algorithm>
#include <numbers>

#include "samcontact/base/threads.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/fft/periodic_transform.hpp"
#include "samcontact/kernels/surface_traction.hpp"
#include "samcontact/operators/influence_lattice.hpp"
#include "samcontact/operators/parity_product.hpp"

namespace samcontact::operators {
namespace {

/// Influence of one cell on the offsets >= 0, in units of dx, times factor.
Field influence(const Grid& grid, const fft::ParitySpectrum& spectrum,
                double (*corner)(double, double), double factor) {
  const CornerLattice lattice{grid.nx, grid.ny, grid.dy / grid.dx};
  Field corners(lattice.size());
  lattice.evaluate<1>([&](double x, double y) { return std::array{corner(x, y)}; }, corners.data());
  Field quarter(spectrum.size());
  lattice.corner_sums(corners.data(), quarter.data(), spectrum.hx(), spectrum.hy());
  for (double& value : quarter) value *= factor;
  return quarter;
}

/// out = convolution of `in` with the kernel whose real quarter spectrum is given.
void convolve(const fft::PaddedTransform& transform, const Field& quarter, kernels::Parity parity,
              const double* in, double* out, ComplexField& spectrum) {
  const int mx = transform.mx(), mh = transform.mh(), hx = mx / 2 + 1;
  spectrum.resize(transform.spectrum_size());
  transform.forward(in, spectrum.data(), mx, fft::PaddedTransform::Threads::many);
#pragma omp parallel if (spectrum.size() >= worth_threads_cells)
  {
    ComplexField column(mx);
#pragma omp for schedule(static)
    for (int ky = 0; ky < mh; ++ky) {
      Complex* values = spectrum.data() + static_cast<std::size_t>(ky) * mx;
      std::fill(column.begin(), column.end(), Complex{});
      add_parity_product(quarter.data() + static_cast<std::size_t>(ky) * hx, parity, 1.0, values,
                         column.data(), mx);
      std::copy(column.begin(), column.end(), values);
    }
  }
  transform.inverse(spectrum.data(), out, mx, fft::PaddedTransform::Threads::many);
}

constexpr kernels::Parity even{false, false, false};
constexpr kernels::Parity odd_in_x{true, false, false};
constexpr kernels::Parity odd_in_y{false, true, false};

}  // namespace

SurfaceDisplacement::SurfaceDisplacement(const Grid& grid, double normal_compliance,
                                         double coupling_compliance)
    : transform_(grid.nx, grid.ny) {
  const fft::ParitySpectrum spectrum(transform_);
  normal_ = influence(grid, spectrum, kernels::pressure_displacement,
                      normal_compliance * grid.dx / std::numbers::pi);
  self_influence_ = normal_[0];
  spectrum.transform(normal_.data(), false, false);
  if (coupling_compliance != 0) {
    coupling_ = influence(grid, spectrum, kernels::shear_displacement,
                          coupling_compliance * grid.dx / (2 * std::numbers::pi));
    spectrum.transform(coupling_.data(), true, false);
  }
}

void SurfaceDisplacement::pressure(const double* pressure, double* displacement,
                                   ComplexField& work) const {
  convolve(transform_, normal_, even, pressure, displacement, work);
}

void SurfaceDisplacement::shear(const double* shear, double* displacement,
                                ComplexField& work) const {
  if (has_coupling()) {
    convolve(transform_, coupling_, odd_in_x, shear, displacement, work);
  } else {
    std::fill(displacement, displacement + transform_.nx() * transform_.ny(), 0.0);
  }
}

double SurfaceDisplacement::cost() const {
  return fft::filter_cost(transform_.nx(), transform_.mx(), transform_.my());
}

Field surface_displacement(const Grid& grid, double normal_compliance, double coupling_compliance,
                           const double* pressure, const double* shear_x, const double* shear_y) {
  const fft::PaddedTransform transform(grid.nx, grid.ny);
  const fft::ParitySpectrum spectrum(transform);
  Field total(grid.surface_size(), 0.0), part(grid.surface_size());
  ComplexField work;
  const auto add = [&](const double* traction, double (*corner)(double, double), double factor,
                       kernels::Parity parity) {
    if (traction == nullptr || factor == 0) return;
    Field quarter = influence(grid, spectrum, corner, factor * grid.dx / std::numbers::pi);
    spectrum.transform(quarter.data(), parity.odd_x, parity.odd_y);
    convolve(transform, quarter, parity, traction, part.data(), work);
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += part[i];
  };
  add(pressure, kernels::pressure_displacement, normal_compliance, even);
  add(shear_x, kernels::shear_displacement, 0.5 * coupling_compliance, odd_in_x);
  add(
      shear_y, [](double x, double y) { return kernels::shear_displacement(y, x); },
      0.5 * coupling_compliance, odd_in_y);
  return total;
}

}  // namespace samcontact::operators
