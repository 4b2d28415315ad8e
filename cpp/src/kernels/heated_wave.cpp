// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/heated_wave.hpp"

#include <cmath>
#include <complex>

namespace samcontact::kernels {
namespace {

using Complex = std::complex<double>;
/// Argument below which (1 - exp(-x))/x is summed as a series.
constexpr double small = 0.3;

/// exp(-x), 0 where it is negligible: products with it would be subnormal numbers, which are slow.
template <class Scalar>
Scalar decayed(Scalar x) {
  constexpr double negligible_decay = 300.0;
  return std::real(x) > negligible_decay ? Scalar{} : std::exp(-x);
}

/// (exp(-q y) - exp(-m y))/(m - q) for m - q = d; fast = exp(-m y), slow = exp(-q y).
double divided_difference(double d, double y, double, double slow) {
  const double x = d * y;
  return slow * y * (x == 0 ? 1.0 : -std::expm1(-x) / x);
}
Complex divided_difference(Complex d, double y, Complex fast, double slow) {
  const Complex x = d * y;
  if (std::norm(x) >= small * small) return (slow - fast) / d;
  Complex sum = 1.0, term = 1.0;
  for (int n = 2; n < 14; ++n) {
    term *= -x / static_cast<double>(n);
    sum += term;
  }
  return slow * y * sum;
}

template <class Scalar>
Eigen::Matrix<Scalar, 2, 1> times(const Eigen::Matrix2d& matrix,
                                  const Eigen::Matrix<Scalar, 2, 1>& v) {
  return {matrix(0, 0) * v[0] + matrix(0, 1) * v[1], matrix(1, 0) * v[0] + matrix(1, 1) * v[1]};
}

ThermalStack thermal_part(const HeatedStack& stack) {
  ThermalStack thermal{{}, stack.thermal.back()};
  for (std::size_t n = 0; n < stack.elastic.layers.size(); ++n) {
    thermal.layers.push_back({stack.thermal[n], stack.elastic.layers[n].thickness});
  }
  return thermal;
}

}  // namespace

template <class Scalar>
HeatWave<Scalar>::HeatWave(const ThermalStack& stack) {
  for (const auto& [thermal, thickness] : stack.layers) {
    layers_.push_back({thermal.conductivity, thermal.diffusivity, thickness});
  }
  layers_.push_back({stack.substrate.conductivity, stack.substrate.diffusivity, INFINITY});
}

template <class Scalar>
void HeatWave<Scalar>::set(double q, Scalar rate) {
  Scalar admittance{};  // flux over temperature at the top of the material below [W/(m^2 K)]
  for (std::size_t n = layers_.size(); n-- > 0;) {
    Layer& own = layers_[n];
    const Scalar relative = rate / own.diffusivity;
    own.m = std::sqrt(q * q + relative);
    own.excess = relative / (own.m + q);
    const Scalar plain = own.conductivity * own.m;
    if (std::isinf(own.thickness)) {
      own.reflection = own.decay = Scalar{};
      admittance = plain;
      continue;
    }
    own.reflection = (plain - admittance) / (plain + admittance);
    own.decay = decayed<Scalar>(own.m * own.thickness);
    const Scalar returned = own.reflection * own.decay * own.decay;
    admittance = plain * (1.0 - returned) / (1.0 + returned);
  }
  Scalar flux{1.0};  // at the top of the layer
  for (Layer& own : layers_) {
    const Scalar plain = own.conductivity * own.m;
    own.down = flux / (plain * (1.0 - own.reflection * own.decay * own.decay));
    own.up = own.reflection * own.decay * own.down;
    flux = plain * (own.decay * own.down - own.up);
  }
}

template <class Scalar>
Scalar HeatWave<Scalar>::temperature(int layer, double y) const {
  const Layer& own = layers_[layer];
  const Scalar down = own.down * decayed<Scalar>(own.m * y);
  if (std::isinf(own.thickness)) return down;
  return down + own.up * decayed<Scalar>(own.m * (own.thickness - y));
}

template <class Scalar>
HeatedWave<Scalar>::HeatedWave(const HeatedStack& stack)
    : elastic_(stack.elastic), heat_(thermal_part(stack)) {
  const std::size_t count = elastic_.layers().size();
  for (std::size_t n = 0; n < count; ++n) {
    const double nu = elastic_.layers()[n].nu, softness = elastic_.layers()[n].softness;
    eigenstrain_.push_back(stack.thermal[n].expansion * (1 + nu) / (1 - nu));
    modulus_.push_back(2 * eigenstrain_[n] / softness);
  }
  down_.assign(count, Vector::Zero());
  up_ = sent_ = down_;
}

// A particular solution exp(-m y)/(m^2 - q^2) has a resonance at m = q, the steady state at rest:
// less the harmonic wave exp(-q y), which changes the elastic waves only, it has none.
template <class Scalar>
std::array<typename HeatedWave<Scalar>::Potential, 2> HeatedWave<Scalar>::potentials(
    std::size_t layer) const {
  const auto& own = heat_.layers()[layer];
  const Scalar part = 1.0 / (own.m + q_);
  if (std::isinf(own.thickness)) return {{{Scalar{}, -own.down * part}, {}}};
  const double slow = elastic_.layers()[layer].decay(0, 0);
  const Scalar across = divided_difference(own.excess, own.thickness, own.decay, slow) * part;
  const Scalar slope = own.decay * part - q_ * across;
  return {{{-own.up * across, own.up * slope - own.down * part},
           {-own.down * across, own.up * part - own.down * slope}}};
}

template <class Scalar>
auto HeatedWave<Scalar>::particular(std::size_t layer, const Potential& potential) const
    -> Particular {
  const double stress = modulus_[layer] * q_, strain = eigenstrain_[layer] * q_;
  return {{-stress * potential.slope, stress * q_ * potential.value},
          {-strain * q_ * potential.value, strain * potential.slope}};
}

template <class Scalar>
void HeatedWave<Scalar>::set(double q, Scalar rate) {
  q_ = q;
  elastic_.set_wavenumber(q);
  heat_.set(q, rate);
  find_waves();
}

template <class Scalar>
Scalar HeatedWave<Scalar>::held_displacement() const {
  Scalar sum{};
  for (std::size_t n = 0; n < eigenstrain_.size(); ++n) {
    const auto& own = heat_.layers()[n];
    sum -= eigenstrain_[n] * (own.down + own.up) * (1.0 - own.decay) / own.m;
  }
  return sum;
}

template <class Scalar>
void HeatedWave<Scalar>::find_waves() {
  const auto& layers = elastic_.layers();
  Vector below = Vector::Zero();  // free displacement of the top of the material below
  std::vector<Vector> arriving(layers.size(), Vector::Zero()), tops(layers.size());
  std::vector<Vector> bottoms(layers.size(), Vector::Zero());
  for (std::size_t n = layers.size(); n-- > 0;) {
    const auto& own = layers[n];
    const auto ends = potentials(n);
    const Particular top = particular(n, ends[0]);
    tops[n] = top.traction;
    sent_[n] = Vector::Zero();
    if (std::isfinite(own.thickness)) {
      const Particular bottom = particular(n, ends[1]);
      bottoms[n] = bottom.traction;
      Vector opening = bottom.displacement - below;
      if (n + 1 < layers.size()) opening -= times(layers[n + 1].compliance, bottom.traction);
      sent_[n] = times(own.of_below, opening);
      arriving[n] = times(own.decay, sent_[n]);
    }
    const Vector traction = times(own.traction_up, arriving[n]) + top.traction;
    below = times(own.displacement_up, arriving[n]) + top.displacement -
            times(own.compliance, traction);
  }
  free_ = below;
  Vector traction = Vector::Zero();
  for (std::size_t n = 0; n < layers.size(); ++n) {
    const auto& own = layers[n];
    down_[n] =
        times(own.to_amplitude, Vector(traction - times(own.traction_up, arriving[n]) - tops[n]));
    if (!std::isfinite(own.thickness)) break;
    const Vector through = times(own.decay, down_[n]);
    up_[n] = times(own.reflection, through) + sent_[n];
    traction = times(own.traction_down, through) + times(own.traction_up, up_[n]) + bottoms[n];
  }
}

template <class Scalar>
auto HeatedWave<Scalar>::at(int layer, double z) const -> Field {
  const auto& own = elastic_.layers()[layer];
  const auto& heat = heat_.layers()[layer];
  const Scalar part = 1.0 / (heat.m + q_);
  const double c = modulus_[layer];
  Field found{};
  // Waves that decay downwards (sign 1) or upwards (-1) from a distance.
  const auto add = [&](const Vector& amplitude, Scalar source, double distance, double sign) {
    const double x = q_ * distance, slow = decayed(x);
    const auto fast = decayed<Scalar>(heat.m * distance);
    const Scalar depth = divided_difference(heat.excess, distance, fast, slow) * part;
    const Scalar temperature = source * fast, bent = -c * q_ * q_ * source * depth;
    const Scalar P = amplitude[0] * slow, F = amplitude[1] * slow, plain = P + x * F;
    found.temperature += temperature;
    found.s11 += 2.0 * F - plain - bent - c * temperature;
    found.s22 += 2 * own.nu * F - c * temperature;
    found.s33 += plain + bent;
    found.shear += sign * (plain - F + c * q_ * source * (fast * part - q_ * depth));
  };
  add(down_[layer], heat.down, z - own.top, 1.0);
  if (std::isfinite(own.thickness)) {
    add(up_[layer], heat.up, own.thickness - (z - own.top), -1.0);
  }
  return found;
}

template class HeatWave<double>;
template class HeatWave<Complex>;
template class HeatedWave<double>;
template class HeatedWave<Complex>;

}  // namespace samcontact::kernels
