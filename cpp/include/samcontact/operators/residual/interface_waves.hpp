// SPDX-License-Identifier: GPL-3.0-or-later
// Fourier modes between the interfaces of layers, several wavenumbers at a time: eqs. (44) to (46)
// of docs/theory/layers.md.
#pragma once

#include <span>

#include "samcontact/operators/residual/sweep_lanes.hpp"

namespace samcontact::operators::layers {

/// Amplitudes P and F of a mode, or (T, N), or (q U, q W) times the shear modulus of the first
/// layer.
struct Pair {
  Lanes p{}, f{};

  SAMCONTACT_INLINE Pair operator+(const Pair& o) const { return {p + o.p, f + o.f}; }
  SAMCONTACT_INLINE Pair operator-(const Pair& o) const { return {p - o.p, f - o.f}; }
  SAMCONTACT_INLINE Pair operator*(const Lanes& factor) const { return {p * factor, f * factor}; }
};

/// Matrix of two columns.
struct Matrix {
  Pair first, second;

  SAMCONTACT_INLINE Pair operator*(const Pair& v) const { return first * v.p + second * v.f; }
  SAMCONTACT_INLINE Matrix operator*(const Matrix& o) const {
    return {*this * o.first, *this * o.second};
  }
  SAMCONTACT_INLINE Matrix operator-(const Matrix& o) const {
    return {first - o.first, second - o.second};
  }
  SAMCONTACT_INLINE Matrix inverse() const {
    const Lanes over = 1.0 / (first.p * second.f - second.p * first.f);
    return {{second.f * over, -first.f * over}, {-second.p * over, first.p * over}};
  }
};

/// Tractions and displacements of modes at y = 0, downwards and upwards.
struct Sides {
  double half;  // half of the ratio of the shear modulus of the first layer to that of this layer
  double nu;

  SAMCONTACT_INLINE static Pair traction_down(const Pair& v) { return {v.p - v.f, v.p}; }
  SAMCONTACT_INLINE static Pair traction_up(const Pair& v) { return {v.f - v.p, v.p}; }
  SAMCONTACT_INLINE Pair displacement_down(const Pair& v) const {
    return {half * (2 * (1 - nu) * v.f - v.p), -half * (v.p + (1 - 2 * nu) * v.f)};
  }
  SAMCONTACT_INLINE Pair displacement_up(const Pair& v) const {
    return {half * (2 * (1 - nu) * v.f - v.p), half * (v.p + (1 - 2 * nu) * v.f)};
  }
};

/// Mode in the plane of wavevector and depth, and across it.
struct Wave {
  Pair plane;
  Lanes across{};
};

/// Response of one layer: decay through it; upward modes at its bottom due to downward modes there,
/// and due to a free displacement of the material below; downward modes due to tractions at its
/// top, and displacement there, without traction, due to upward modes.
struct Interfaces {
  Lanes e, y;
  Matrix reflection, of_below, to_amplitude, rising;
  Lanes across_reflection, across_of_below, across_to_amplitude, across_rising;

  SAMCONTACT_INLINE Pair decayed(const Pair& v) const { return {(v.p + y * v.f) * e, v.f * e}; }
  /// Modes at the top of the layer after propagation to its bottom, reflection, and return.
  SAMCONTACT_INLINE Pair returned(const Pair& v) const { return decayed(reflection * decayed(v)); }
};

/// Modes of one layer: first those that leave it, downwards at its bottom and upwards at its top,
/// then those that enter it, downwards at its top (a) and upwards at its bottom (b).
struct LayerWaves {
  Wave down, up, a, b;
};

/// All layers from the bottom up, eq. (45).
SAMCONTACT_INLINE void fill_interfaces(const SweptStack& stack, const double* row, int step,
                                       Interfaces* interfaces) {
  const auto& layers = stack.layers();
  const double mu = layers[0].mu;
  const Lanes one = Lanes{} + 1.0;
  const Pair p{one, Lanes{}}, f{Lanes{}, one};
  Matrix below{};  // displacement over traction at the top of the material below
  Lanes across{};
  for (int n = static_cast<int>(layers.size()) - 1; n >= 0; --n) {
    const auto& layer = layers[n];
    const Sides sides{0.5 * mu / layer.mu, layer.nu};
    const Lanes softness = Lanes{} + mu / layer.mu;
    const Matrix down{sides.displacement_down(p), sides.displacement_down(f)};
    const Matrix up{sides.displacement_up(p), sides.displacement_up(f)};
    Interfaces& own = interfaces[n];
    Pair back_p{}, back_f{};
    Lanes across_back{};
    if (!layer.is_endless()) {
      const auto at = [=](int place) { return row + static_cast<std::ptrdiff_t>(place) * step; };
      own.e = *reinterpret_cast<const Loose*>(at(layer.through));
      own.y = *reinterpret_cast<const Loose*>(at(layer.mode + thickness)) * layer.over_cell;
      const Matrix under_up{below * Sides::traction_up(p), below * Sides::traction_up(f)};
      const Matrix under_down{below * Sides::traction_down(p), below * Sides::traction_down(f)};
      own.of_below = (under_up - up).inverse();
      own.reflection = own.of_below * (down - under_down);
      back_p = own.returned(p);
      back_f = own.returned(f);
      own.across_of_below = 1.0 / (across - softness);
      own.across_reflection = (softness + across) * own.across_of_below;
      across_back = own.e * own.e * own.across_reflection;
    }
    own.to_amplitude = Matrix{Sides::traction_down(p) + Sides::traction_up(back_p),
                              Sides::traction_down(f) + Sides::traction_up(back_f)}
                           .inverse();
    below = Matrix{down.first + up * back_p, down.second + up * back_f} * own.to_amplitude;
    own.rising = up - Matrix{below * Sides::traction_up(p), below * Sides::traction_up(f)};
    own.across_to_amplitude = 1.0 / (1.0 - across_back);
    across = -softness * (1.0 + across_back) * own.across_to_amplitude;
    own.across_rising = across - softness;
  }
}

/// Modes that enter the layers from those that leave them, eq. (46); the surface is free.
SAMCONTACT_INLINE void reflect(const SweptStack& stack, const Interfaces* interfaces, int parts,
                               LayerWaves* waves) {
  const int count = static_cast<int>(stack.layers().size());
  for (int part = 0; part < parts; ++part) {
    // Upwards: free displacement of the material below, without traction. Until the downward pass,
    // a contains the modes that arrive at the top of a layer, and b those that its bottom returns.
    Wave free;
    for (int n = count - 1; n >= 0; --n) {
      const Interfaces& own = interfaces[n];
      LayerWaves& at = waves[n * parts + part];
      at.a = at.up;
      if (!stack.layers()[n].is_endless()) {
        at.b.plane = own.reflection * at.down.plane - own.of_below * free.plane;
        at.b.across = own.across_reflection * at.down.across + own.across_of_below * free.across;
        at.a.plane = at.a.plane + own.decayed(at.b.plane);
        at.a.across += own.e * at.b.across;
      }
      free.plane = own.rising * at.a.plane;
      free.across = own.across_rising * at.a.across;
    }
    Wave traction;  // downwards, initially zero
    for (int n = 0; n < count; ++n) {
      const Interfaces& own = interfaces[n];
      LayerWaves& at = waves[n * parts + part];
      at.a.plane = own.to_amplitude * (traction.plane - Sides::traction_up(at.a.plane));
      at.a.across = own.across_to_amplitude * (traction.across + at.a.across);
      if (stack.layers()[n].is_endless()) break;
      const Pair below = own.decayed(at.a.plane);
      const Lanes across_below = own.e * at.a.across;
      at.b.plane = own.reflection * below + at.b.plane;
      at.b.across += own.across_reflection * across_below;
      traction.plane = Sides::traction_down(below + at.down.plane) + Sides::traction_up(at.b.plane);
      traction.across = across_below + at.down.across - at.b.across;
    }
  }
}

}  // namespace samcontact::operators::layers
