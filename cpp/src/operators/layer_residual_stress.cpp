// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/layer_residual_stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "samcontact/base/flush_denormals.hpp"
#include "samcontact/base/multiversion.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {
namespace {

// Wavenumbers handled together: one AVX-512 register of doubles.
constexpr int width = VolumeTransform::lanes;
using Lanes [[gnu::vector_size(width * sizeof(double)), gnu::may_alias]] = double;

/// What a wavenumber q needs, x = q h with the layer thickness h, all means over a layer.
enum Coefficient {
  direction_x,     // kx / q
  direction_y,     // ky / q
  thickness,       // x
  decay,           // exp(-x)
  own,             // (q/2) exp(-q r) over the half of the own layer above or below
  own_linear,      // the same of q r exp(-q r)
  other,           // (q/2) exp(-q r) over a neighbouring layer
  other_shift,     // what q r exp(-q r) lacks of distance in layers times x, in units of other
  surface,         // exp(-q z) in the first layer
  surface_linear,  // q z exp(-q z) in the first layer
  coefficient_count
};

void fill_mode(double kx, double ky, double h, double* mode, int step) {
  const double q = std::hypot(kx, ky), x = q * h;
  const auto set = [&](Coefficient c, double value) { mode[c * step] = value; };
  if (q == 0) {
    set(direction_x, 1.0);
    set(decay, 1.0);
    set(surface, 1.0);
    return;
  }
  const double e = std::exp(-x), gone = -std::expm1(-x);
  set(direction_x, kx / q);
  set(direction_y, ky / q);
  set(thickness, x);
  set(decay, e);
  set(own, 0.5 * (1 - gone / x));
  set(own_linear, 0.5 * (1 - (2 * gone - x * e) / x));
  set(other, 0.5 * gone * gone / x);
  set(other_shift, x * (1 + e) / gone - 2);
  set(surface, gone / x);
  set(surface_linear, (gone - x * e) / x);
}

/// Eigenstress of a layer in the frame turned along the wavevector (1 along it, 2 across), with the
/// 13 and 23 components multiplied by i: then everything is real.
enum Turned { t11, t22, t33, t12, t13, t23, turned_count };
/// Sums over the layers on one side: of the combinations that act through exp(-q r), and of the one
/// that acts through q r exp(-q r).
enum Side { side_c, side_d, side_linear, side_antiplane, side_count };

struct Layout {
  int nz;
  bool deviator;
  /// By how many quarter turns the stored xx, yy, zz, yz, xz, xy differ from the turned ones.
  int turns[6];
  std::size_t component_step, layer_step;  // of the spectrum, in doubles
};

/// parts numbers (re + i im, or a real one) times i^turns.
template <int parts>
[[gnu::always_inline]] inline void rotate(Lanes* v, int turns) {
  if (turns & 2) {
    for (int p = 0; p < parts; ++p) v[p] = -v[p];
  }
  if constexpr (parts == 2) {
    if (turns & 1) {
      const Lanes re = v[0];
      v[0] = -v[1];
      v[1] = re;
    }
  }
}

/// Replaces the strain of one block of wavenumbers by its stress. values: the block's row of
/// component 0 and layer 0, complex numbers interleaved. turned: [layer][Turned][part], side:
/// [layer][Side][part], scratch.
template <int parts>
[[gnu::always_inline]] inline void sweep(const Layout& at, const char* used, const double* mode,
                                         int mode_step, double nu, double lame, double twice_mu,
                                         double* values, Lanes* turned, Lanes* side) {
  using Loose [[gnu::vector_size(width * sizeof(double)), gnu::may_alias, gnu::aligned(8)]] =
      double;
  Lanes of[coefficient_count];
  for (int n = 0; n < coefficient_count; ++n) {
    of[n] = *reinterpret_cast<const Loose*>(mode + n * mode_step);
  }
  const Lanes c = of[direction_x], s = of[direction_y], x = of[thickness], e = of[decay];
  const Lanes g0 = of[own], g1 = of[own_linear], g = of[other], shift = of[other_shift];
  const double kappa = 1 / (2 * (1 - nu)), ratio = nu / (1 - nu);
  const int nz = at.nz;
  constexpr int last = turned_count * parts;
  // Places of xx, yy, zz, yz, xz, xy in the spectrum; a deviator has no zz.
  const int after = at.deviator ? 0 : 1;
  const int places[6] = {0, 1, 2, 2 + after, 3 + after, 4 + after};

  // Eigenstress in the turned frame; the sums over the layers below, from the bottom upwards.
  Lanes r[side_count][parts] = {};
  for (int k = nz - 1; k >= 0; --k) {
    Lanes* t = turned + k * last;
    Lanes* below = side + k * side_count * parts;
    for (int p = 0; p < parts; ++p) {
      const Lanes linear = x * r[side_linear][p] - shift * (r[side_d][p] - r[side_c][p]);
      below[side_c * parts + p] = g * r[side_c][p];
      below[side_d * parts + p] = g * r[side_d][p];
      below[side_linear * parts + p] = g * linear;
      below[side_antiplane * parts + p] = g * r[side_antiplane][p];
      for (auto& sum : r) sum[p] *= e;
      r[side_linear][p] += r[side_d][p] - r[side_c][p];
    }
    if (!used[k]) {
      for (int n = 0; n < last; ++n) t[n] = Lanes{};
      continue;
    }
    Lanes v[6][parts];
    for (int m = 0; m < 6; ++m) {
      if (at.deviator && m == 2) {
        for (Lanes& part : v[m]) part = Lanes{};
        continue;
      }
      const double* from = values + places[m] * at.component_step + k * at.layer_step;
      const Loose a = *reinterpret_cast<const Loose*>(from);
      if constexpr (parts == 1) {
        v[m][0] = a;
      } else {
        const Loose b = *reinterpret_cast<const Loose*>(from + width);
        v[m][0] = __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14);
        v[m][1] = __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15);
      }
      rotate<parts>(v[m], at.turns[m]);
    }
    for (int p = 0; p < parts; ++p) {
      if (at.deviator) v[2][p] = -(v[0][p] + v[1][p]);
      const Lanes trace = lame * (v[0][p] + v[1][p] + v[2][p]);
      const Lanes xx = c * v[0][p] + s * v[5][p], xy = c * v[5][p] + s * v[1][p];
      const Lanes yx = c * v[5][p] - s * v[0][p], yy = c * v[1][p] - s * v[5][p];
      const Lanes a11 = trace + twice_mu * (c * xx + s * xy);
      const Lanes a22 = trace + twice_mu * (c * yy - s * yx);
      const Lanes a12 = twice_mu * (c * xy - s * xx);
      const Lanes a33 = trace + twice_mu * v[2][p];
      const Lanes a13 = twice_mu * (c * v[4][p] + s * v[3][p]);
      const Lanes a23 = twice_mu * (c * v[3][p] - s * v[4][p]);
      t[t11 * parts + p] = a11;
      t[t22 * parts + p] = a22;
      t[t33 * parts + p] = a33;
      t[t12 * parts + p] = a12;
      t[t13 * parts + p] = a13;
      t[t23 * parts + p] = a23;
      const Lanes cc = a11 - a13, dd = a33 + a13;
      r[side_c][p] += cc;
      r[side_d][p] += dd;
      r[side_linear][p] += dd - cc;
      r[side_antiplane][p] += a12 - a23;
    }
  }

  // The traction of the unbounded body on the surface is taken away: normal, along, across.
  Lanes t3[parts], s1[parts], s2[parts];
  for (int p = 0; p < parts; ++p) {
    const Lanes gone = 1.0 - e;
    const Lanes sc = 0.5 * gone * r[side_c][p], sd = 0.5 * gone * r[side_d][p];
    const Lanes w = r[side_d][p] - r[side_c][p];
    const Lanes linear = 0.5 * (x * gone * (r[side_linear][p] - w) + (gone - x * e) * w);
    t3[p] = (1 - kappa) * (sc + sd) + kappa * linear;
    s1[p] = -(sc + sd) + kappa * (2.0 * sd - linear);
    s2[p] = -0.5 * gone * r[side_antiplane][p];
  }

  // The sums over the layers above, downwards, and the stress.
  for (auto& sums : r) {
    for (auto& sum : sums) sum = Lanes{};
  }
  Lanes depth{};  // q z at the layer's top
  Lanes e0 = of[surface], e1 = of[surface_linear];
  for (int k = 0; k < nz; ++k) {
    const Lanes* t = turned + k * last;
    const Lanes* below = side + k * side_count * parts;
    Lanes v[6][parts];
    for (int p = 0; p < parts; ++p) {
      const Lanes a11 = t[t11 * parts + p], a22 = t[t22 * parts + p], a33 = t[t33 * parts + p];
      const Lanes a12 = t[t12 * parts + p], a13 = t[t13 * parts + p], a23 = t[t23 * parts + p];
      const Lanes linear = x * r[side_linear][p] - shift * (r[side_d][p] - r[side_c][p]);
      const Lanes c_down = g * r[side_c][p] + g0 * (a11 + a13);
      const Lanes d_down = g * r[side_d][p] + g0 * (a33 - a13);
      const Lanes w_down = g * linear + g1 * (a33 - a11 - 2.0 * a13);
      const Lanes o_down = g * r[side_antiplane][p] + g0 * (a12 + a23);
      const Lanes c_up = below[side_c * parts + p] + g0 * (a11 - a13);
      const Lanes d_up = below[side_d * parts + p] + g0 * (a33 + a13);
      const Lanes w_up = below[side_linear * parts + p] + g1 * (a33 - a11 + 2.0 * a13);
      const Lanes o_up = below[side_antiplane * parts + p] + g0 * (a12 - a23);

      const Lanes c_sum = c_down + c_up, d_sum = d_down + d_up;
      const Lanes trace = ratio * (d_sum - c_sum - a33);
      const Lanes bulk = kappa * (w_down + w_up - c_sum - d_sum);
      // The half-space under the opposite traction.
      const Lanes f = t3[p] - s1[p], deep = f * (depth * e0 + e1);
      const Lanes s11 = 2.0 * c_sum - trace + bulk - a11 + (t3[p] - 2.0 * s1[p]) * e0 - deep;
      const Lanes s22 = -trace - a22 + 2 * nu * f * e0;
      const Lanes s33 = t3[p] * e0 + deep - c_sum - d_sum - bulk;
      const Lanes s13 = s1[p] * e0 + deep - (c_down + d_down) + (c_up + d_up) +
                        kappa * ((2.0 * d_down - w_down) - (2.0 * d_up - w_up));
      const Lanes s12 = o_down + o_up - a12 - s2[p] * e0;
      const Lanes s23 = o_up - o_down + s2[p] * e0;

      const Lanes ax = c * s11 - s * s12, ay = c * s12 - s * s22;
      const Lanes bx = s * s11 + c * s12, by = s * s12 + c * s22;
      v[0][p] = c * ax - s * ay;
      v[1][p] = s * bx + c * by;
      v[2][p] = s33;
      if (at.deviator) {
        const Lanes mean = (s11 + s22 + s33) * (1.0 / 3);
        v[0][p] -= mean;
        v[1][p] -= mean;
      }
      v[5][p] = s * ax + c * ay;
      v[4][p] = c * s13 - s * s23;
      v[3][p] = s * s13 + c * s23;

      for (auto& sum : r) sum[p] *= e;
      r[side_linear][p] += r[side_d][p] - r[side_c][p];
      r[side_c][p] += a11 + a13;
      r[side_d][p] += a33 - a13;
      r[side_linear][p] += a33 - a11 - 2.0 * a13;
      r[side_antiplane][p] += a12 + a23;
    }
    depth += x;
    e0 *= e;
    e1 *= e;
    for (int m = 0; m < 6; ++m) {
      if (at.deviator && m == 2) continue;
      double* to = values + places[m] * at.component_step + k * at.layer_step;
      rotate<parts>(v[m], 4 - at.turns[m]);
      if constexpr (parts == 1) {
        *reinterpret_cast<Loose*>(to) = v[m][0];
      } else {
        *reinterpret_cast<Loose*>(to) =
            __builtin_shufflevector(v[m][0], v[m][1], 0, 8, 1, 9, 2, 10, 3, 11);
        *reinterpret_cast<Loose*>(to + width) =
            __builtin_shufflevector(v[m][0], v[m][1], 4, 12, 5, 13, 6, 14, 7, 15);
      }
    }
  }
}

SAMCONTACT_MULTIVERSION
void sweep_complex(const Layout& at, const char* used, const double* mode, int mode_step, double nu,
                   double lame, double twice_mu, double* values, Lanes* turned, Lanes* side) {
  sweep<2>(at, used, mode, mode_step, nu, lame, twice_mu, values, turned, side);
}

SAMCONTACT_MULTIVERSION
void sweep_real(const Layout& at, const char* used, const double* mode, int mode_step, double nu,
                double lame, double twice_mu, double* values, Lanes* turned, Lanes* side) {
  sweep<1>(at, used, mode, mode_step, nu, lame, twice_mu, values, turned, side);
}

/// With yz and xz multiplied by i all is real; what is stored lacks (-i) for each mirrored
/// direction in which the component is odd.
Layout make_layout(const VolumeSpectrum& spectrum) {
  Layout at{spectrum.nz,
            spectrum.tensor == Tensor::deviator,
            {},
            spectrum.nz * spectrum.row_size(),
            spectrum.row_size()};
  for (int c = 0; c < 6; ++c) {
    const auto parity = kernels::component_parity(c);
    const int missing = (spectrum.symmetry != Symmetry::none && parity.odd_y) +
                        (spectrum.symmetry == Symmetry::xy && parity.odd_x);
    at.turns[c] = ((c == 3 || c == 4) + 3 * missing) % 4;
  }
  return at;
}

/// At the highest wavenumber of a direction its sign is unknown: the components that are odd in
/// that direction have no defined sign either and are left out.
void drop_unsigned(VolumeSpectrum& spectrum, int ky) {
  const int parts = spectrum.parts, last = spectrum.components - 1;
  const int yz = last - 2, xz = last - 1, xy = last;
  for (int k = 0; k < spectrum.nz; ++k) {
    for (const int c : {xz, xy}) {
      std::fill_n(spectrum.row(ky, c, k) + spectrum.mx / 2 * parts, parts, 0.0);
    }
    if (2 * ky != spectrum.my) continue;
    for (const int c : {yz, xy}) {
      std::fill_n(spectrum.row(ky, c, k), spectrum.modes * parts, 0.0);
    }
  }
}

}  // namespace

LayerResidualStress::LayerResidualStress(const Grid& grid, const VolumeTransform& transform,
                                         const Elastic& elastic, double image_tol)
    : nz_(grid.nz),
      pitch_(transform.pitch()),
      nu_(elastic.nu),
      lame_(2 * elastic.shear_modulus() * elastic.nu / (1 - 2 * elastic.nu)),
      shear_modulus_(elastic.shear_modulus()),
      images_(grid, transform, elastic, image_tol) {
  const int mh = transform.mh();
  modes_.assign(static_cast<std::size_t>(mh) * coefficient_count * pitch_, 0.0);
  const double two_pi = 2 * std::numbers::pi;
  for (int ky = 0; ky < mh; ++ky) {
    double* row = modes_.data() + static_cast<std::size_t>(ky) * coefficient_count * pitch_;
    for (int i = 0; i < transform.modes(); ++i) {
      const int kx = i <= transform.mx() / 2 ? i : i - transform.mx();
      fill_mode(two_pi * kx / (transform.mx() * grid.dx), two_pi * ky / (transform.my() * grid.dy),
                grid.dz, row + i, pitch_);
    }
  }
}

void LayerResidualStress::apply(VolumeSpectrum& spectrum) const {
  const Layout at = make_layout(spectrum);
  const auto run = spectrum.parts == 2 ? sweep_complex : sweep_real;
  // The transform is not normalised.
  const double unit_cell = 1.0 / (static_cast<double>(spectrum.mx) * spectrum.my);
  const double lame = lame_ * unit_cell, twice_mu = 2 * shear_modulus_ * unit_cell;
  const std::size_t scratch = static_cast<std::size_t>(nz_) * spectrum.parts * width;
#pragma omp parallel
  {
    const FlushDenormals flush;
    Field turned(turned_count * scratch), side(side_count * scratch);
#pragma omp for schedule(dynamic)
    for (int ky = 0; ky < spectrum.mh; ++ky) {
      drop_unsigned(spectrum, ky);
      const double* row = modes_.data() + static_cast<std::size_t>(ky) * coefficient_count * pitch_;
      for (int kx = 0; kx < spectrum.modes; kx += width) {
        run(at, spectrum.used.data(), row + kx, pitch_, nu_, lame, twice_mu,
            spectrum.row(ky, 0, 0) + kx * spectrum.parts, reinterpret_cast<Lanes*>(turned.data()),
            reinterpret_cast<Lanes*>(side.data()));
      }
      drop_unsigned(spectrum, ky);
    }
  }
  spectrum.used.assign(nz_, 1);
}

Field LayerResidualStress::far_field(Tensor tensor, const double* strain) const {
  return images_.stress(tensor, strain);
}

void LayerResidualStress::correct(Tensor tensor, const Field& far_field, int layer,
                                  double* stress) const {
  images_.subtract(tensor, far_field, layer, stress);
}

std::size_t LayerResidualStress::bytes() const {
  return modes_.size() * sizeof(double) + images_.bytes();
}

}  // namespace samcontact::operators
