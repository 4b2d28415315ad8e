// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/stack_sweep.hpp"

#include <cmath>

namespace samcontact::operators {
namespace {

/// Below this the closed forms lose digits, and few terms of their series are enough.
constexpr double thin = 0.1;

/// Sum of factor(n) (-x)^n/n! from n = first on.
template <class Factor>
double series(double x, int first, const Factor& factor) {
  double term = 1.0, sum = 0.0;
  for (int n = 1; n < first + 12; ++n) {
    term *= -x / n;
    if (n >= first) sum += factor(n) * term;
  }
  return sum;
}

/// The integrals c, d, w and o of equation (25) of docs/theory.md.
struct Sums {
  double c = 0.0, d = 0.0, w = 0.0, o = 0.0;
};

}  // namespace

StackSweep::StackSweep(const Stack& stack, const std::vector<int>& layer_of, double h)
    : wave_(stack), layer_of_(layer_of), h_(h), stress_(layer_of.size()) {
  waves_.resize(wave_.layers().size());
}

void StackSweep::set_wavenumber(double q) {
  q_ = q;
  if (q == 0) return;
  wave_.set_wavenumber(q);
  const double x = q * h_, e = std::exp(-x);
  const double mean = -std::expm1(-x) / x;
  if (x < thin) {
    cell_ = {x,
             e,
             mean,
             series(x, 2, [](int n) { return n - 1.0; }) / (x * x),
             series(x, 2, [](int) { return 1.0; }) / x,
             series(x, 3, [](int n) { return 2.0 - n; }) / x};
  } else {
    cell_ = {x, e, mean, (mean - e) / x, (x - 1 + e) / x, (x - 2 + (x + 2) * e) / x};
  }
}

void StackSweep::add_infinite_space(const std::vector<TurnedTensor>& source, int sign) {
  const auto& [x, e, mean, mean_linear, own, own_linear] = cell_;
  const int count = static_cast<int>(source.size());
  const double enters = 0.5 * x * mean, enters_linear = 0.5 * x * x * mean_linear;
  Sums at;  // at the face where the sweep enters a layer of cells
  for (int n = 0; n < count; ++n) {
    const int k = sign > 0 ? n : count - 1 - n, next = k + sign, layer = layer_of_[k];
    const auto& material = wave_.layers()[layer];
    const double kappa = 0.5 / (1 - material.nu), ratio = material.nu / (1 - material.nu);
    const TurnedTensor& t = source[k];
    const Sums from{t.t11 + sign * t.t13, t.t33 - sign * t.t13, t.t33 - t.t11 - 2 * sign * t.t13,
                    t.t12 + sign * t.t23};
    const double c = at.c * mean + 0.5 * from.c * own, d = at.d * mean + 0.5 * from.d * own;
    const double w = at.w * mean + (at.d - at.c) * x * mean_linear + 0.5 * from.w * own_linear;
    const double o = at.o * mean + 0.5 * from.o * own;
    TurnedTensor& s = stress_[k];
    s.t11 += 2 * c - ratio * (d - c) + kappa * (w - c - d);
    s.t22 -= ratio * (d - c);
    s.t33 -= c + d + kappa * (w - c - d);
    s.t13 += sign * (kappa * (2 * d - w) - c - d);
    s.t12 += o;
    s.t23 -= sign * o;
    at = {at.c * e + from.c * enters, at.d * e + from.d * enters,
          (at.w + x * (at.d - at.c)) * e + from.w * enters_linear, at.o * e + from.o * enters};
    if (next >= 0 && next < count && layer_of_[next] == layer) continue;
    // What leaves the layer is one of its waves, decayed as far as its cells do not reach.
    const double depth = (k + 1) * h_ - material.top;
    const double y = sign > 0 ? q_ * (material.thickness - depth) : 0.0, gone = std::exp(-y);
    const double P = -(1 - kappa) * (at.c + at.d) - kappa * at.w, F = kappa * (at.c - at.d);
    Vector left(0.0, 0.0);
    if (gone > 0) left = {(P + y * F) * gone, F * gone};
    (sign > 0 ? waves_[layer].down : waves_[layer].up) = left;
    (sign > 0 ? waves_[layer].across_down : waves_[layer].across_up) = -at.o * gone;
    at = {};
  }
}

void StackSweep::reflect() {
  const auto& layers = wave_.layers();
  const int count = static_cast<int>(layers.size());
  std::vector<Vector> arriving(count), returned(count, Vector(0.0, 0.0));
  std::vector<double> across_arriving(count), across_returned(count, 0.0);
  // Upwards: the displacement that what lies below has of itself, without traction.
  Vector free(0.0, 0.0);
  double across_free = 0.0;
  for (int m = count - 1; m >= 0; --m) {
    const auto& own = layers[m];
    arriving[m] = waves_[m].up;
    across_arriving[m] = waves_[m].across_up;
    if (std::isfinite(own.thickness)) {
      returned[m] = own.reflection * waves_[m].down - own.of_below * free;
      across_returned[m] =
          own.across_reflection * waves_[m].across_down + own.across_of_below * across_free;
      arriving[m] += own.decay * returned[m];
      across_arriving[m] += own.across_decay * across_returned[m];
    }
    free = own.displacement_up * arriving[m] - own.compliance * (own.traction_up * arriving[m]);
    across_free = (own.across_compliance - own.softness) * across_arriving[m];
  }
  // Downwards, from the surface without traction.
  Vector traction(0.0, 0.0);
  double across = 0.0;
  for (int m = 0; m < count; ++m) {
    const auto& own = layers[m];
    Waves& waves = waves_[m];
    waves.a = own.to_amplitude * (traction - own.traction_up * arriving[m]);
    waves.across_a = own.across_to_amplitude * (across + across_arriving[m]);
    waves.b = Vector(0.0, 0.0);
    waves.across_b = 0.0;
    if (!std::isfinite(own.thickness)) break;
    const Vector below = own.decay * waves.a;
    const double across_below = own.across_decay * waves.across_a;
    waves.b = own.reflection * below + returned[m];
    waves.across_b = own.across_reflection * across_below + across_returned[m];
    traction = own.traction_down * (below + waves.down) + own.traction_up * waves.b;
    across = across_below + waves.across_down - waves.across_b;
  }
}

void StackSweep::add_waves() {
  const double mean = cell_.mean, linear = cell_.x * cell_.mean_linear;
  for (std::size_t k = 0; k < stress_.size(); ++k) {
    const auto& own = wave_.layers()[layer_of_[k]];
    const Waves& waves = waves_[layer_of_[k]];
    TurnedTensor& s = stress_[k];
    const auto add = [&](const Vector& amplitude, double across, double y, double sign) {
      const double gone = std::exp(-y);
      if (gone == 0) return;
      const double P = (amplitude[0] + y * amplitude[1]) * gone, F = amplitude[1] * gone * mean;
      const double plain = P * mean + amplitude[1] * gone * linear, o = across * gone * mean;
      s.t11 += 2 * F - plain;
      s.t22 += 2 * own.nu * F;
      s.t33 += plain;
      s.t13 += sign * (plain - F);
      s.t23 += sign * o;
      s.t12 -= o;
    };
    const double depth = static_cast<double>(k) * h_ - own.top;
    add(waves.a, waves.across_a, q_ * depth, 1.0);
    add(waves.b, waves.across_b, q_ * (own.thickness - depth - h_), -1.0);
  }
}

void StackSweep::add_uniform(std::vector<TurnedTensor>& tensor) const {
  for (std::size_t k = 0; k < tensor.size(); ++k) {
    const double nu = wave_.layers()[layer_of_[k]].nu, side = nu / (1 - nu) * tensor[k].t33;
    const TurnedTensor t = tensor[k];
    tensor[k] = {side - t.t11, side - t.t22, 0.0, -t.t12, 0.0, 0.0};
  }
}

void StackSweep::apply(std::vector<TurnedTensor>& tensor) {
  if (q_ == 0) {
    add_uniform(tensor);
    return;
  }
  for (std::size_t k = 0; k < tensor.size(); ++k) {
    const double nu = wave_.layers()[layer_of_[k]].nu, side = nu / (1 - nu) * tensor[k].t33;
    stress_[k] = {side - tensor[k].t11, side - tensor[k].t22, 0.0, -tensor[k].t12, 0.0, 0.0};
  }
  for (Waves& waves : waves_) waves = Waves();
  for (const int sign : {1, -1}) add_infinite_space(tensor, sign);
  reflect();
  add_waves();
  tensor = stress_;
}

}  // namespace samcontact::operators
