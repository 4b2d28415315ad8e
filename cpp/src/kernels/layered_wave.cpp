// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/layered_wave.hpp"

#include <Eigen/LU>
#include <cmath>

namespace samcontact::kernels {
namespace {

Eigen::Matrix2d rows(double a, double b, double c, double d) {
  return (Eigen::Matrix2d() << a, b, c, d).finished();
}

}  // namespace

WaveCompliance wave_compliance(const Elastic& elastic) {
  if (elastic.is_rigid()) return {0.0, 0.0, 0.0, 0.0};
  const double softness = 1 / elastic.shear_modulus(), nu = elastic.nu;
  return {(1 - nu) * softness, 0.5 * (1 - 2 * nu) * softness, (1 - nu) * softness, softness};
}

WaveDecay WaveDecay::at(double y) {
  const double e = std::exp(-y);
  return {e, y * e};
}

WaveDecay WaveDecay::mean(double y0, double y1) {
  const double h = y1 - y0;
  // Means over a cell much thinner than the wavelength equal the values at its middle.
  if (h < 1e-4) {
    const double y = 0.5 * (y0 + y1), e = std::exp(-y), bend = h * h / 24;
    return {e * (1 + bend), e * (y + bend * (y - 2))};
  }
  const double e0 = std::exp(-y0), lost = -std::expm1(-h);
  const double e = e0 * lost / h;
  return {e, e0 * (y0 * lost + lost - h * std::exp(-h)) / h};
}

LayeredWave::LayeredWave(const Stack& stack) : on_rigid_(stack.substrate.is_rigid()) {
  double top = 0.0;
  const auto add = [&](const Elastic& elastic, double thickness) {
    const double softness = 1 / elastic.shear_modulus(), half = 0.5 * softness, nu = elastic.nu;
    layers_.push_back({rows(1, -1, 1, 0), rows(-1, 1, 1, 0),
                       half * rows(-1, 2 * (1 - nu), -1, -(1 - 2 * nu)),
                       half * rows(-1, 2 * (1 - nu), 1, 1 - 2 * nu), nu, softness, thickness, top});
    top += thickness;
  };
  for (const auto& [elastic, thickness] : stack.layers) add(elastic, thickness);
  if (!on_rigid_) add(stack.substrate, INFINITY);
}

void LayeredWave::set_wavenumber(double q) {
  q_ = q;
  Matrix below = Matrix::Zero();  // displacement over traction at the top of the material below
  double across = 0.0;
  for (std::size_t n = layers_.size(); n-- > 0;) {
    Layer& own = layers_[n];
    Matrix reflected = Matrix::Zero();  // ratio of the mode from the bottom to that from the top
    double across_reflected = 0.0;
    if (std::isfinite(own.thickness)) {
      const double y = q * own.thickness, e = std::exp(-y);
      own.decay = rows(e, y * e, 0, e);
      own.of_below = (below * own.traction_up - own.displacement_up).inverse();
      own.reflection = own.of_below * (own.displacement_down - below * own.traction_down);
      reflected = own.decay * own.reflection * own.decay;
      own.across_decay = e;
      own.across_of_below = 1 / (across - own.softness);
      own.across_reflection = (own.softness + across) * own.across_of_below;
      across_reflected = e * e * own.across_reflection;
    }
    own.to_amplitude = (own.traction_down + own.traction_up * reflected).inverse();
    own.across_to_amplitude = 1 / (1 - across_reflected);
    below = (own.displacement_down + own.displacement_up * reflected) * own.to_amplitude;
    across = -own.softness * (1 + across_reflected) * own.across_to_amplitude;
    own.compliance = below;
    own.across_compliance = across;
  }
  compliance_ = {-below(0, 0), 0.5 * (below(0, 1) + below(1, 0)), -below(1, 1), -across};
}

WaveCompliance LayeredWave::compliance() const { return compliance_; }

LayeredWave::Amplitudes LayeredWave::amplitudes(int layer, Vector traction, double across) const {
  for (int n = 0;; ++n) {
    const Layer& own = layers_[n];
    Amplitudes found{own.to_amplitude * traction, Vector::Zero(), own.across_to_amplitude * across,
                     0.0};
    if (std::isfinite(own.thickness)) {
      const Vector arriving = own.decay * found.a;
      found.b = own.reflection * arriving;
      const double arriving_across = own.across_decay * found.across_a;
      found.across_b = own.across_reflection * arriving_across;
      traction = own.traction_down * arriving + own.traction_up * found.b;
      across = arriving_across - found.across_b;
    }
    if (n == layer) return found;
  }
}

/// 1 along the wavevector, 2 across.
struct LayeredWave::Rotated {
  double s11 = 0.0, s22 = 0.0, s33 = 0.0, s13 = 0.0, s12 = 0.0, s23 = 0.0;

  /// Modes that decay downwards (sign 1) or upwards (-1): P and F in the plane of the wavevector,
  /// and one across.
  void add(const Vector& amplitude, double across, const WaveDecay& decay, double nu, double sign) {
    const double P = amplitude[0], F = amplitude[1];
    const double plain = P * decay.e + F * decay.ye;
    s11 += 2 * F * decay.e - plain;
    s22 += 2 * nu * F * decay.e;
    s33 += plain;
    s13 += sign * (plain - F * decay.e);
    s12 -= across * decay.e;
    s23 += sign * across * decay.e;
  }
};

LayeredWave::Rotated LayeredWave::rotated(int layer, const Decays& decays, const Vector& traction,
                                          double across) const {
  const Amplitudes waves = amplitudes(layer, traction, across);
  Rotated stress;
  stress.add(waves.a, waves.across_a, decays.down, layers_[layer].nu, 1.0);
  stress.add(waves.b, waves.across_b, decays.up, layers_[layer].nu, -1.0);
  return stress;
}

LayeredWave::Decays LayeredWave::at(int layer, double z) const {
  const double y = q_ * (z - layers_[layer].top), end = q_ * layers_[layer].thickness;
  return {WaveDecay::at(y), std::isfinite(end) ? WaveDecay::at(end - y) : WaveDecay{0.0, 0.0}};
}

LayeredWave::Decays LayeredWave::mean(int layer, double z0, double z1) const {
  const double top = layers_[layer].top, end = q_ * layers_[layer].thickness;
  const double y0 = q_ * (z0 - top), y1 = q_ * (z1 - top);
  return {WaveDecay::mean(y0, y1),
          std::isfinite(end) ? WaveDecay::mean(end - y1, end - y0) : WaveDecay{0.0, 0.0}};
}

Stress LayeredWave::under_pressure(int layer, const Decays& decays, double cos, double sin) const {
  const Rotated s = rotated(layer, decays, {0.0, -1.0}, 0.0);
  const double cc = cos * cos, ss = sin * sin;
  return {cc * s.s11 + ss * s.s22,     ss * s.s11 + cc * s.s22, s.s33, sin * s.s13, cos * s.s13,
          -cos * sin * (s.s11 - s.s22)};
}

Stress LayeredWave::under_shear_x(int layer, const Decays& decays, double cos, double sin) const {
  const Rotated s = rotated(layer, decays, {1.0, 0.0}, 1.0);
  const double cc = cos * cos, ss = sin * sin;
  return {cos * (cc * s.s11 + ss * s.s22 + 2 * ss * s.s12),
          cos * (ss * s.s11 + cc * s.s22 - 2 * ss * s.s12),
          cos * s.s33,
          cos * sin * (s.s13 - s.s23),
          -(cc * s.s13 + ss * s.s23),
          sin * (cc * (s.s11 - s.s22) - (cc - ss) * s.s12)};
}

}  // namespace samcontact::kernels
