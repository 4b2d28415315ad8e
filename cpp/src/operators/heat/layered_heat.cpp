// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/layered_heat.hpp"

#include <cmath>
#include <complex>
#include <span>
#include <vector>

#include "samcontact/kernels/heat_steady.hpp"
#include "samcontact/kernels/heated_wave.hpp"
#include "samcontact/operators/heat/layered_sums.hpp"

namespace samcontact::operators {
namespace {

using kernels::HeatedWave;
using kernels::Parity;

/// Decay exponent beyond which the reflection of a wave is below rounding.
constexpr double deepest_heat_wave = 42.0;

/// Highest wavenumber at which a field at a depth differs from that of a homogeneous body.
double highest_heat_wave(const HeatedStack& stack, int layer, double z) {
  return deepest_heat_wave / (layer > 0 ? z : 2 * stack.elastic.layers[0].thickness - z);
}

/// For a single component that does not depend on the direction.
constexpr auto copy_one = [](const auto* in, double, double, auto* out) { *out = *in; };

/// Modes of a field of the layers less those of a homogeneous body of one of them.
template <class Scalar>
struct DisplacementModes {
  HeatedWave<Scalar> layered, near;
  double factor, far, distance;  // less those of a source at a depth, -far exp(-q distance)/q^2

  void operator()(double q, Scalar rate, Scalar* values) {
    layered.set(q, rate);
    near.set(q, rate);
    *values = factor * (layered.displacement() - near.displacement());
    *values += factor * far * std::exp(-q * distance) / (q * q);
  }
};

/// Counterpart for a body that is laterally held.
template <class Scalar>
struct HeldModes {
  HeatedWave<Scalar> layered, near;
  double factor;

  void operator()(double q, Scalar rate, Scalar* values) {
    layered.set(q, rate);
    near.set(q, rate);
    *values = factor * (layered.held_displacement() - near.held_displacement());
  }
};

/// 11, 22, 33 and i s_13.
template <class Scalar>
struct HeatStressModes {
  HeatedWave<Scalar> layered, near;
  double factor, z;
  int layer;

  void operator()(double q, Scalar rate, Scalar* values) {
    layered.set(q, rate);
    near.set(q, rate);
    const auto whole = layered.at(layer, z), own = near.at(0, z);
    values[0] = factor * (whole.s11 - own.s11);
    values[1] = factor * (whole.s22 - own.s22);
    values[2] = factor * (whole.s33 - own.s33);
    values[3] = factor * (whole.shear - own.shear);
  }
};

constexpr auto turn_stress = [](const auto* in, double c, double s, auto* out) {
  out[0] = c * c * in[0] + s * s * in[1];
  out[1] = s * s * in[0] + c * c * in[1];
  out[2] = in[2];
  out[3] = s * in[3];
  out[4] = c * in[3];
  out[5] = -c * s * (in[0] - in[1]);
};

template <class Scalar>
struct TemperatureModes {
  kernels::HeatWave<Scalar> layered, near;
  double factor, z, top;
  int layer;

  void operator()(double q, Scalar rate, Scalar* values) {
    layered.set(q, rate);
    near.set(q, rate);
    *values = factor * (layered.temperature(layer, z - top) - near.temperature(0, z));
  }
};

/// Displacement of a steady point source at rest at large distances, over its power [m/W].
double far_displacement(const HeatedStack& stack, int layer) {
  const Thermal& thermal = stack.thermal[layer];
  return thermal.expansion * (1 + stack.elastic.elastic(layer).nu) / thermal.conductivity;
}

}  // namespace

ParityParts layered_heat_displacement(const Stack& elastic, const Heating& heating, double dx,
                                      double dy, const Offsets& offsets) {
  const HeatedStack stack = HeatedStack::of(elastic, heating.thermal);
  ParityParts parts =
      heat_displacement(heating.in(stack.thermal[0]), stack.elastic.elastic(0).nu, dx, dy, offsets);
  if (stack.is_uniform()) return parts;
  const double distance = 2 * stack.elastic.thickness();
  double far = 0.0;
  if (heating.is_steady_at_rest()) {
    // At large distances the substrate acts, at a depth that leaves the near field to the layer.
    const auto below = static_cast<int>(stack.elastic.layers.size());
    far = far_displacement(stack, below) - far_displacement(stack, 0);
    std::size_t n = 0;
    for (const double y : offsets.y) {
      for (const double x : offsets.x) {
        parts[0][n++] +=
            heating.factor * far *
            kernels::buried_heat_displacement(x, y, distance, dx / 2, dy / 2, heating.reference);
      }
    }
  }
  const auto modes = [&]<class Scalar>(Scalar) {
    return DisplacementModes<Scalar>{HeatedWave<Scalar>(stack), HeatedWave<Scalar>(stack.only(0)),
                                     heating.factor, far, distance};
  };
  ParityParts* const into[] = {&parts};
  add_modes(stack, {heating, dx, dy, offsets}, highest_heat_wave(stack, 0, 0.0),
            Components{1, {Parity{}}, copy_one, 1.0}, modes, into);
  using Complex = std::complex<double>;
  const HeldModes<Complex> held{HeatedWave<Complex>(stack), HeatedWave<Complex>(stack.only(0)),
                                heating.factor};
  add_mean(stack, {heating, dx, dy, offsets}, Components{1, {Parity{}}, copy_one}, held, into);
  return parts;
}

std::array<ParityParts, 6> layered_heat_stress(const Stack& elastic, const Heating& heating,
                                               double dx, double dy, double z,
                                               const Offsets& offsets) {
  const HeatedStack stack = HeatedStack::of(elastic, heating.thermal);
  const int layer = stack.elastic.layer_at(z);
  const Elastic& own = stack.elastic.elastic(layer);
  if (own.is_rigid()) return {};
  auto parts = heat_stress(heating.in(stack.thermal[layer]), own, dx, dy, z, offsets);
  if (stack.is_uniform()) return parts;
  const auto modes = [&]<class Scalar>(Scalar) {
    return HeatStressModes<Scalar>{HeatedWave<Scalar>(stack), HeatedWave<Scalar>(stack.only(layer)),
                                   heating.factor, z, layer};
  };
  std::vector<Parity> parities;
  std::array<ParityParts*, 6> into{};
  for (int c = 0; c < 6; ++c) {
    parities.push_back(kernels::component_parity(c));
    into[c] = &parts[c];
  }
  add_modes(stack, {heating, dx, dy, offsets}, highest_heat_wave(stack, layer, z),
            Components{4, parities, turn_stress}, modes, into);
  add_mean(stack, {heating, dx, dy, offsets}, Components{4, parities, turn_stress},
           modes(std::complex<double>{}), into);
  return parts;
}

ParityParts layered_heat_temperature(const Heating& heating, double dx, double dy, double z,
                                     const Offsets& offsets) {
  // Elastic constants have no effect on the temperature.
  const HeatedStack stack =
      HeatedStack::of({{}, Elastic::isotropic(1.0, 0.0)}, heating.thermal.merged());
  const int layer = stack.elastic.layer_at(z);
  const Heating own = heating.in(stack.thermal[layer]);
  ParityParts parts = heat_temperature(own, dx, dy, z, offsets);
  if (stack.is_uniform()) return parts;
  double top = 0.0;
  for (int n = 0; n < layer; ++n) top += stack.elastic.layers[n].thickness;
  const auto modes = [&]<class Scalar>(Scalar) {
    return TemperatureModes<Scalar>{kernels::HeatWave<Scalar>(heating.thermal.merged()),
                                    kernels::HeatWave<Scalar>(own.thermal),
                                    heating.factor,
                                    z,
                                    top,
                                    layer};
  };
  ParityParts* const into[] = {&parts};
  add_modes(stack, {heating, dx, dy, offsets}, highest_heat_wave(stack, layer, z),
            Components{1, {Parity{}}, copy_one}, modes, into);
  add_mean(stack, {heating, dx, dy, offsets}, Components{1, {Parity{}}, copy_one},
           modes(std::complex<double>{}), into);
  return parts;
}

}  // namespace samcontact::operators
