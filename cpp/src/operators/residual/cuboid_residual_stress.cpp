// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/residual/cuboid_residual_stress.hpp"

#include <algorithm>
#include <cassert>
#include <numbers>

#include "samcontact/base/multiversion.hpp"
#include "samcontact/fft/parity_spectrum.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/kernels/eigenstrain_terms.hpp"
#include "samcontact/operators/influence/influence_lattice.hpp"
#include "samcontact/operators/influence/layer_differences.hpp"

namespace samcontact::operators {
namespace {

// Offsets within the tensors of one chunk of wavenumbers, a few MB.
// NOLINTBEGIN(bugprone-implicit-widening-of-multiplication-result)

// Wavenumbers handled together: one AVX-512 register of doubles.
constexpr int lane_count = 8;
using Lanes [[gnu::vector_size(lane_count * sizeof(double)), gnu::may_alias]] = double;

constexpr int tensor_pairs = 36;  // out * 6 + in
constexpr int columns = 4;        // Re, Im at +kx; Re, Im at -kx

/// With yz and xz multiplied by i, in strain and in stress, every spectral tensor is real.
Complex phase_factor(int component) {
  return component == 3 || component == 4 ? Complex(0, 1) : Complex(1, 0);
}

/// Sign of a component under kx -> -kx: A(-kx) = D A(kx) D.
double mirror_sign(int component) { return component >= 4 ? -1.0 : 1.0; }

/// Factor of the real quarter spectrum of a kernel in the real tensor.
double real_factor(kernels::Parity parity, int out, int in) {
  Complex factor = phase_factor(out) / phase_factor(in);
  for (int n = parity.odd_x + parity.odd_y; n > 0; --n) factor *= Complex(0, -1);
  assert(factor.imag() == 0);
  return factor.real();
}

/// Layer sums of one block of wavenumbers. full: [z - z' + nz - 1][pair], image: [z + z'][pair][m],
/// strain and stress: [layer][component][column], all with `lane_count` lanes innermost.
SAMCONTACT_MULTIVERSION
void layer_products(int nz, double dz, const char* used, const Lanes* full, const Lanes* image,
                    const Lanes* strain, Lanes* stress) {
  for (int j = 0; j < nz; ++j) {
    const double z = (j + 0.5) * dz;
    for (int out = 0; out < 6; ++out) {
      Lanes sum0{}, sum1{}, sum2{}, sum3{};
      for (int source = 0; source < nz; ++source) {
        if (!used[source]) continue;
        const Lanes* f = full + (j - source + nz - 1) * tensor_pairs + out * 6;
        const Lanes* g = image + ((j + source) * tensor_pairs + out * 6) * 3;
        const Lanes* e = strain + source * 6 * columns;
        for (int in = 0; in < 6; ++in) {
          const Lanes t = f[in] + (g[3 * in] + z * (g[3 * in + 1] + z * g[3 * in + 2]));
          sum0 += t * e[in * columns];
          sum1 += t * e[in * columns + 1];
          sum2 += t * e[in * columns + 2];
          sum3 += t * e[in * columns + 3];
        }
      }
      Lanes* s = stress + (j * 6 + out) * columns;
      s[0] = sum0;
      s[1] = sum1;
      s[2] = sum2;
      s[3] = sum3;
    }
  }
}

/// to[n * to_step] += coefficient from[n * from_step] for n < count, in steps of Lanes.
SAMCONTACT_MULTIVERSION
void accumulate(int count, double coefficient, const Lanes* from, int from_step, Lanes* to,
                int to_step) {
  for (int n = 0; n < count; ++n) to[n * to_step] += coefficient * from[n * from_step];
}

}  // namespace

CuboidResidualStress::CuboidResidualStress(const Grid& grid, const VolumeTransform& transform,
                                           const Elastic& elastic)
    : transform_(&transform),
      nz_(grid.nz),
      lanes_((transform.mx() / 2 + lane_count) / lane_count * lane_count),
      dz_(grid.dz / grid.dx) {
  build_terms(elastic.nu, elastic.shear_modulus());
  build_spectra(grid);
}

void CuboidResidualStress::build_terms(double nu, double shear_modulus) {
  const double factor = shear_modulus / (8 * std::numbers::pi * (1 - nu));
  for (const auto& term : kernels::full_space_terms) {
    const double sign = real_factor(kernels::full_space_parity(term.kernel), term.out, term.in);
    full_terms_.push_back(
        {term.kernel, term.out * 6 + term.in, factor * sign * term.coefficient(nu)});
  }
  for (const auto& term : kernels::image_terms) {
    const double sign = real_factor(kernels::image_parity(term.kernel), term.out, term.in);
    image_terms_[term.power].push_back(
        {term.kernel, term.out * 6 + term.in, factor * sign * term.coefficient(nu)});
  }
  const double unit_cell = 1.0 / (static_cast<double>(transform_->mx()) * transform_->my());
  for (int out = 0; out < 6; ++out) {
    for (int in = 0; in < 6; ++in) {
      const bool odd_z =
          kernels::component_parity(out).odd_z != kernels::component_parity(in).odd_z;
      full_signs_.push_back(odd_z ? -1.0 : 1.0);
      inside_.push_back(shear_modulus * kernels::inside_stress(out, in, nu) * unit_cell);
    }
  }
}

void CuboidResidualStress::build_spectra(const Grid& grid) {
  const fft::ParitySpectrum spectrum(transform_->mx(), transform_->my());
  const CornerLattice lattice{grid.nx, grid.ny, grid.dy / grid.dx};
  const int hx = spectrum.hx(), hy = spectrum.hy();
  const double dz = dz_;
  const auto keep = [&](const double* differences, int kernel, kernels::Parity parity,
                        Field& quarter, Field& to, int count, int layers, int layer) {
    lattice.corner_sums(differences + kernel * lattice.size(), quarter.data(), hx, hy);
    spectrum.transform(quarter.data(), parity.odd_x, parity.odd_y);
    for (int ky = 0; ky < hy; ++ky) {
      std::copy_n(
          quarter.data() + static_cast<std::size_t>(ky) * hx, hx,
          to.data() + ((static_cast<std::size_t>(ky) * count + kernel) * layers + layer) * lanes_);
    }
  };
  full_.assign(static_cast<std::size_t>(hy) * kernels::full_space_count * nz_ * lanes_, 0.0);
  for_each_layer_difference<kernels::full_space_count>(
      lattice, nz_, [dz](int level) { return (level - 0.5) * dz; }, kernels::full_space_scalars,
      [&](int n, const double* differences) {
        Field quarter(spectrum.size());
        for (int m = 0; m < kernels::full_space_count; ++m) {
          keep(differences, m, kernels::full_space_parity(m), quarter, full_,
               kernels::full_space_count, nz_, n);
        }
      });
  const int sums = 2 * nz_ - 1;
  image_.assign(static_cast<std::size_t>(hy) * kernels::image_count * sums * lanes_, 0.0);
  for_each_layer_difference<kernels::image_count>(
      lattice, sums, [dz](int level) { return (level + 0.5) * dz; }, kernels::image_scalars,
      [&](int n, const double* differences) {
        Field quarter(spectrum.size());
        for (int m = 0; m < kernels::image_count; ++m) {
          keep(differences, m, kernels::image_parity(m), quarter, image_, kernels::image_count,
               sums, n);
        }
      });
}

void CuboidResidualStress::load(int ky, int block, const VolumeSpectrum& strain,
                                double* values) const {
  const int mx = strain.mx;
  const auto places = components(strain.tensor);
  for (int k = 0; k < nz_; ++k) {
    if (!strain.used[k]) continue;
    for (int n = 0; n < strain.components; ++n) {
      const int c = places[n];
      const auto* column = reinterpret_cast<const Complex*>(strain.row(ky, n, k));
      double* to = values + (k * 6 + c) * columns * lane_count;
      for (int lane = 0; lane < lane_count; ++lane) {
        const int kx = std::min(block * lane_count + lane, mx / 2);
        const Complex plus = phase_factor(c) * column[kx];
        const Complex minus = mirror_sign(c) * phase_factor(c) * column[(mx - kx) % mx];
        to[lane] = plus.real();
        to[lane_count + lane] = plus.imag();
        to[2 * lane_count + lane] = minus.real();
        to[3 * lane_count + lane] = minus.imag();
      }
    }
    if (strain.tensor == Tensor::full) continue;
    double* xx = values + k * 6 * columns * lane_count;
    const double* yy = xx + columns * lane_count;
    double* zz = xx + 2 * columns * lane_count;
    for (int n = 0; n < columns * lane_count; ++n) zz[n] = -(xx[n] + yy[n]);
  }
}

void CuboidResidualStress::store(int ky, int block, double* values, VolumeSpectrum& stress) const {
  const int mx = stress.mx;
  const auto places = components(stress.tensor);
  for (int k = 0; k < nz_; ++k) {
    if (stress.tensor == Tensor::deviator) {
      double* xx = values + k * 6 * columns * lane_count;
      double* yy = xx + columns * lane_count;
      const double* zz = yy + columns * lane_count;
      for (int n = 0; n < columns * lane_count; ++n) {
        const double mean = (xx[n] + yy[n] + zz[n]) / 3;
        xx[n] -= mean;
        yy[n] -= mean;
      }
    }
    for (int n = 0; n < stress.components; ++n) {
      const int c = places[n];
      auto* column = reinterpret_cast<Complex*>(stress.row(ky, n, k));
      const double* from = values + (k * 6 + c) * columns * lane_count;
      const Complex back = std::conj(phase_factor(c));
      for (int lane = 0; lane < lane_count && block * lane_count + lane <= mx / 2; ++lane) {
        const int kx = block * lane_count + lane;
        column[kx] = back * Complex(from[lane], from[lane_count + lane]);
        if (kx > 0 && kx < mx / 2) {
          column[mx - kx] = mirror_sign(c) * back *
                            Complex(from[2 * lane_count + lane], from[3 * lane_count + lane]);
        }
      }
    }
  }
}

void CuboidResidualStress::mode_block(int ky, int block, const VolumeSpectrum& strain,
                                      double* tensors, double* values) const {
  const int sums = 2 * nz_ - 1;
  auto* full = reinterpret_cast<Lanes*>(tensors);
  Lanes* image = full + sums * tensor_pairs;
  std::fill(tensors, tensors + static_cast<std::size_t>(sums) * tensor_pairs * 4 * lane_count, 0.0);

  const double* scalars =
      full_.data() + static_cast<std::size_t>(ky) * kernels::full_space_count * nz_ * lanes_;
  const int step = lanes_ / lane_count;
  Lanes* same_layer = full + (nz_ - 1) * tensor_pairs;
  for (const Term& term : full_terms_) {
    const auto* from =
        reinterpret_cast<const Lanes*>(scalars + term.kernel * nz_ * lanes_ + block * lane_count);
    Lanes* to = same_layer + term.pair;
    accumulate(nz_, term.coefficient, from, step, to, tensor_pairs);
    accumulate(nz_ - 1, term.coefficient * full_signs_[term.pair], from + step, step,
               to - tensor_pairs, -tensor_pairs);
  }
  for (int pair = 0; pair < tensor_pairs; ++pair) same_layer[pair] -= inside_[pair];

  scalars = image_.data() + static_cast<std::size_t>(ky) * kernels::image_count * sums * lanes_;
  for (int power = 0; power < 3; ++power) {
    for (const Term& term : image_terms_[power]) {
      const auto* from = reinterpret_cast<const Lanes*>(scalars + term.kernel * sums * lanes_ +
                                                        block * lane_count);
      accumulate(sums, term.coefficient, from, step, image + term.pair * 3 + power,
                 tensor_pairs * 3);
    }
  }

  load(ky, block, strain, values);
  const auto* in = reinterpret_cast<const Lanes*>(values);
  auto* out = reinterpret_cast<Lanes*>(values) + nz_ * 6 * columns;
  layer_products(nz_, dz_, strain.used.data(), full, image, in, out);
}

void CuboidResidualStress::apply(VolumeSpectrum& spectrum) const {
  const std::size_t value_size = static_cast<std::size_t>(nz_) * 6 * columns * lane_count;
  const int blocks = lanes_ / lane_count;
#pragma omp parallel
  {
    Field tensors(static_cast<std::size_t>(2 * nz_ - 1) * tensor_pairs * 4 * lane_count);
    Field values(2 * value_size);
#pragma omp for schedule(dynamic)
    for (int ky = 0; ky < spectrum.mh; ++ky) {
      for (int block = 0; block < blocks; ++block) {
        mode_block(ky, block, spectrum, tensors.data(), values.data());
        store(ky, block, values.data() + value_size, spectrum);
      }
    }
  }
  spectrum.used.assign(nz_, 1);
}

// NOLINTEND(bugprone-implicit-widening-of-multiplication-result)

}  // namespace samcontact::operators
