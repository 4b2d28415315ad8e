// SPDX-License-Identifier: GPL-3.0-or-later
// Operations of the fast residual-stress sweeps on several wavenumbers at a time: tensors from and
// to a spectrum, rotated into the frame of the wavevector, and the sums over cells of eqs. (25) and
// (26) of docs/theory/residual_stress.md.
#pragma once

#include "samcontact/operators/residual/layer_sweep.hpp"

#define SAMCONTACT_INLINE [[gnu::always_inline]] inline

namespace samcontact::operators::layers {

using Lanes [[gnu::vector_size(width * sizeof(double)), gnu::may_alias]] = double;
using Loose [[gnu::vector_size(width * sizeof(double)), gnu::may_alias, gnu::aligned(8)]] = double;

/// Coefficients of one block of wavenumbers for cells of one thickness.
struct Mode {
  Lanes of[coefficient_count];

  SAMCONTACT_INLINE Mode(const double* row, int step) {
    for (int n = 0; n < coefficient_count; ++n) {
      of[n] = *reinterpret_cast<const Loose*>(row + static_cast<std::ptrdiff_t>(n) * step);
    }
  }
  SAMCONTACT_INLINE const Lanes& operator[](Coefficient c) const { return of[c]; }
};

/// Constants of the material.
struct Constants {
  double nu, kappa, ratio, lame, twice_mu;  // kappa: 1/(2 (1 - nu)); ratio: nu/(1 - nu)

  explicit Constants(const SweptStack::Layer& layer)
      : nu(layer.nu),
        kappa(0.5 / (1 - nu)),
        ratio(nu / (1 - nu)),
        lame(layer.lame),
        twice_mu(2 * layer.mu) {}
};

/// Symmetric tensor in the frame of the wavevector (1 along it, 2 across), with 13 and 23
/// multiplied by i: all components are then real.
struct Rotated {
  Lanes t11, t22, t33, t12, t13, t23;
};

/// v: xx, yy, zz, yz, xz, xy of the strain.
SAMCONTACT_INLINE void eigenstress(const Mode& mode, const Constants& k, const Lanes* v,
                                   Rotated& t) {
  const Lanes c = mode[direction_x], s = mode[direction_y];
  const Lanes twice_mu = k.twice_mu * mode[share];
  const Lanes trace = k.lame * mode[share] * (v[0] + v[1] + v[2]);
  const Lanes xx = c * v[0] + s * v[5], xy = c * v[5] + s * v[1];
  const Lanes yx = c * v[5] - s * v[0], yy = c * v[1] - s * v[5];
  t.t11 = trace + twice_mu * (c * xx + s * xy);
  t.t22 = trace + twice_mu * (c * yy - s * yx);
  t.t33 = trace + twice_mu * v[2];
  t.t12 = twice_mu * (c * xy - s * xx);
  t.t13 = twice_mu * (c * v[4] + s * v[3]);
  t.t23 = twice_mu * (c * v[3] - s * v[4]);
}

/// Rotates back to xx, yy, zz, yz, xz, xy.
SAMCONTACT_INLINE void rotate_back(const Mode& mode, const Rotated& t, bool deviator, Lanes* v) {
  const Lanes c = mode[direction_x], s = mode[direction_y];
  const Lanes ax = c * t.t11 - s * t.t12, ay = c * t.t12 - s * t.t22;
  const Lanes bx = s * t.t11 + c * t.t12, by = s * t.t12 + c * t.t22;
  v[0] = c * ax - s * ay;
  v[1] = s * bx + c * by;
  v[2] = t.t33;
  v[3] = s * t.t13 + c * t.t23;
  v[4] = c * t.t13 - s * t.t23;
  v[5] = s * ax + c * ay;
  if (deviator) {
    const Lanes mean = (t.t11 + t.t22 + t.t33) * (1.0 / 3);
    v[0] -= mean;
    v[1] -= mean;
  }
}

/// Sums over the cells on one side: c, d and o act through exp(-q r), w through q r exp(-q r).
struct Sums {
  Lanes c{}, d{}, w{}, o{};

  /// Moves all cells away by one.
  SAMCONTACT_INLINE void recede(const Lanes& decay_) {
    c *= decay_;
    d *= decay_;
    w *= decay_;
    o *= decay_;
    w += d - c;
  }
  /// Adds a cell next to the receiver, above it (sign 1) or below (-1).
  SAMCONTACT_INLINE void add(const Rotated& t, double sign) {
    c += t.t11 + sign * t.t13;
    d += t.t33 - sign * t.t13;
    w += t.t33 - t.t11 - 2 * sign * t.t13;
    o += t.t12 + sign * t.t23;
  }
  /// Integrals of the sums, eq. (25) of docs/theory/residual_stress.md, as means over the receiving
  /// cell.
  SAMCONTACT_INLINE Sums integrals(const Mode& mode) const {
    const Lanes g = mode[other];
    Sums i;
    i.c = g * c;
    i.d = g * d;
    i.w = g * (mode[thickness] * w - mode[other_shift] * (d - c));
    i.o = g * o;
    return i;
  }
  /// Adds the half of the receiving cell itself on this side.
  SAMCONTACT_INLINE void add_own(const Mode& mode, const Rotated& t, double sign) {
    const Lanes g0 = mode[own], g1 = mode[own_linear];
    c += g0 * (t.t11 + sign * t.t13);
    d += g0 * (t.t33 - sign * t.t13);
    w += g1 * (t.t33 - t.t11 - 2 * sign * t.t13);
    o += g0 * (t.t12 + sign * t.t23);
  }
};

/// Stress of the infinite space from the integrals above and below, eq. (26).
SAMCONTACT_INLINE void infinite_space(const Constants& k, const Sums& above, const Sums& below,
                                      const Rotated& t, Rotated& s) {
  const Lanes c = above.c + below.c, d = above.d + below.d;
  const Lanes trace = k.ratio * (d - c - t.t33);
  const Lanes bulk = k.kappa * (above.w + below.w - c - d);
  s.t11 = 2.0 * c - trace + bulk - t.t11;
  s.t22 = -trace - t.t22;
  s.t33 = -c - d - bulk;
  s.t13 = (below.c + below.d) - (above.c + above.d) +
          k.kappa * ((2.0 * above.d - above.w) - (2.0 * below.d - below.w));
  s.t12 = above.o + below.o - t.t12;
  s.t23 = below.o - above.o;
}

/// Position of component m in the spectrum; a deviator has no zz.
template <typename Value>
SAMCONTACT_INLINE Value* at(const Layout& layout, Value* values, int m, int layer) {
  const int place = layout.deviator && m > 2 ? m - 1 : m;
  return values + place * layout.component_step + layer * layout.layer_step;
}

/// Multiplies `parts` numbers (re + i im, or real) by i^turns.
template <int parts>
SAMCONTACT_INLINE void rotate(Lanes* v, int turns) {
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

/// Loads the components of one layer, v[part][component], from the spectrum (complex numbers
/// interleaved).
template <int parts>
SAMCONTACT_INLINE void load(const Layout& layout, const double* values, int layer, Lanes v[][6]) {
  for (int m = 0; m < 6; ++m) {
    if (layout.deviator && m == 2) continue;
    const double* from = at(layout, values, m, layer);
    Lanes number[parts];
    const Loose a = *reinterpret_cast<const Loose*>(from);
    if constexpr (parts == 1) {
      number[0] = a;
    } else {
      const Loose b = *reinterpret_cast<const Loose*>(from + width);
      number[0] = __builtin_shufflevector(a, b, 0, 2, 4, 6);
      number[1] = __builtin_shufflevector(a, b, 1, 3, 5, 7);
    }
    rotate<parts>(number, layout.turns[m]);
    for (int p = 0; p < parts; ++p) v[p][m] = number[p];
  }
  if (layout.deviator) {
    for (int p = 0; p < parts; ++p) v[p][2] = -(v[p][0] + v[p][1]);
  }
}

SAMCONTACT_INLINE void put(double* to, const double* more, const Lanes& value) {
  *reinterpret_cast<Loose*>(to) =
      more == nullptr ? value : value + *reinterpret_cast<const Loose*>(more);
}

/// Stores the components of one layer.
template <int parts>
SAMCONTACT_INLINE void store(const Target& target, const Lanes v[][6], int layer) {
  const Layout& layout = target.layout;
  for (int m = 0; m < 6; ++m) {
    if (layout.deviator && m == 2) continue;
    double* to = at(layout, target.values, m, layer);
    const double* more =
        target.more == nullptr ? nullptr : at(target.more_layout, target.more, m, layer);
    Lanes number[parts];
    for (int p = 0; p < parts; ++p) number[p] = v[p][m];
    rotate<parts>(number, 4 - layout.turns[m]);
    if constexpr (parts == 1) {
      put(to, more, number[0]);
    } else {
      put(to, more, __builtin_shufflevector(number[0], number[1], 0, 4, 1, 5));
      put(to + width, more == nullptr ? nullptr : more + width,
          __builtin_shufflevector(number[0], number[1], 2, 6, 3, 7));
    }
  }
}

}  // namespace samcontact::operators::layers
