// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/heat/layered_heat.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "samcontact/kernels/heat_steady.hpp"
#include "samcontact/kernels/heated_wave.hpp"
#include "samcontact/kernels/rings.hpp"
#include "samcontact/kernels/wake_sums.hpp"

namespace samcontact::operators {
namespace {

using kernels::HeatedWave;
using kernels::Parity;

/// Decay exponent beyond which the reflection of a wave is below rounding.
constexpr double deepest_heat_wave = 42.0;

/// Cell of the grid, and where its influence is needed.
struct HeatedCell {
  const Heating& heating;
  double dx, dy;
  const Offsets& offsets;
};

void require_supported(const Heating& heating) {
  if (heating.age != Heating::infinity()) {
    throw std::invalid_argument(
        "the time of heating of a layered body must be infinite (steady state)");
  }
  if (heating.speed_x != 0 && heating.speed_y != 0) {
    throw std::invalid_argument("the velocity of a heated layered body must be along x or along y");
  }
}

/// Length over which the body differs from its substrate: layers that conduct well spread heat.
double longest_heat_length(const HeatedStack& stack) {
  double ratio = 1.0;
  for (const Thermal& layer : stack.thermal) {
    ratio = std::max(ratio, layer.conductivity / stack.thermal.back().conductivity);
  }
  return 2 * stack.elastic.thickness() * ratio;
}

/// Highest wavenumber at which a field at a depth differs from that of a homogeneous body.
double highest_heat_wave(const HeatedStack& stack, int layer, double z) {
  return deepest_heat_wave / (layer > 0 ? z : 2 * stack.elastic.layers[0].thickness - z);
}

/// Adds fields from their modes: modes(double{}) and modes(std::complex<double>{}) return functions
/// of kx, ky, rate and the values of all components, with the parities given for a source at rest.
template <class Modes>
void add_modes(const HeatedStack& stack, const HeatedCell& cell, double highest,
               const std::vector<Parity>& parities, const Modes& modes,
               std::span<ParityParts* const> into) {
  const auto& [heating, dx, dy, offsets] = cell;
  const double longest = longest_heat_length(stack);
  const std::size_t nx = offsets.x.size(), ny = offsets.y.size(), plane = nx * ny;
  const auto part_of = [&](std::size_t c, int flip) -> Field& {
    Field& part = (*into[c])[flip];
    part.resize(plane);
    return part;
  };
  if (!heating.is_moving()) {
    const auto at = [own = modes(double{})](double kx, double ky, double* values) mutable {
      own(kx, ky, 0.0, values);
    };
    const Field sums =
        kernels::ring_sums({parities, at, highest, longest, true}, dx, dy, offsets.x, offsets.y);
    for (std::size_t c = 0; c < into.size(); ++c) {
      Field& part = part_of(c, 0);
      for (std::size_t n = 0; n < plane; ++n) part[n] += sums[c * plane + n];
    }
    return;
  }
  // Wakes are along x: axes are exchanged for a body that moves along y.
  const bool along_x = heating.speed_x != 0;
  const double speed = along_x ? heating.speed_x : heating.speed_y;
  using Complex = std::complex<double>;
  const auto at = [own = modes(Complex{}), along_x, speed](double along, double across,
                                                           Complex* values) mutable {
    const Complex rate(0.0, std::fabs(speed) * along);
    along_x ? own(along, across, rate, values) : own(across, along, rate, values);
  };
  std::vector<Parity> turned = parities;
  if (!along_x) {
    for (Parity& parity : turned) std::swap(parity.odd_x, parity.odd_y);
  }
  double slowest = stack.thermal[0].diffusivity;
  for (const Thermal& layer : stack.thermal) slowest = std::min(slowest, layer.diffusivity);
  const Field sums = kernels::wake_sums(
      {turned, at, highest, longest, std::fabs(speed) / slowest}, along_x ? dx : dy,
      along_x ? dy : dx, along_x ? offsets.x : offsets.y, along_x ? offsets.y : offsets.x);
  const double* from = sums.data();
  for (std::size_t c = 0; c < into.size(); ++c) {
    for (int opposite = 0; opposite < 2; ++opposite, from += plane) {
      Field& part = part_of(c, opposite == 0 ? 0 : along_x ? 1 : 2);
      const double sign = opposite == 1 && speed < 0 ? -1.0 : 1.0;
      for (std::size_t j = 0; j < ny; ++j) {
        for (std::size_t i = 0; i < nx; ++i) {
          part[j * nx + i] += sign * from[along_x ? j * nx + i : i * ny + j];
        }
      }
    }
  }
}

/// Modes of a field of the layers less those of a homogeneous body of one of them.
template <class Scalar>
struct DisplacementModes {
  HeatedWave<Scalar> layered, near;
  double factor, far, distance;  // less those of a source at a depth, -far exp(-q distance)/q^2

  void operator()(double kx, double ky, Scalar rate, Scalar* values) {
    const double q = std::hypot(kx, ky);
    layered.set(q, rate);
    near.set(q, rate);
    *values = factor * (layered.displacement() - near.displacement());
    *values += factor * far * std::exp(-q * distance) / (q * q);
  }
};

template <class Scalar>
struct HeatStressModes {
  HeatedWave<Scalar> layered, near;
  double factor, z;
  int layer;

  void operator()(double kx, double ky, Scalar rate, Scalar* values) {
    const double q = std::hypot(kx, ky), c = kx / q, s = ky / q;
    layered.set(q, rate);
    near.set(q, rate);
    const auto whole = layered.at(layer, z), own = near.at(0, z);
    const Scalar s11 = factor * (whole.s11 - own.s11), s22 = factor * (whole.s22 - own.s22);
    const Scalar shear = factor * (whole.shear - own.shear);
    values[0] = c * c * s11 + s * s * s22;
    values[1] = s * s * s11 + c * c * s22;
    values[2] = factor * (whole.s33 - own.s33);
    values[3] = s * shear;
    values[4] = c * shear;
    values[5] = -c * s * (s11 - s22);
  }
};

template <class Scalar>
struct TemperatureModes {
  kernels::HeatWave<Scalar> layered, near;
  double factor, z, top;
  int layer;

  void operator()(double kx, double ky, Scalar rate, Scalar* values) {
    const double q = std::hypot(kx, ky);
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
  require_supported(heating);
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
  add_modes(stack, {heating, dx, dy, offsets}, highest_heat_wave(stack, 0, 0.0), {Parity{}}, modes,
            into);
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
  require_supported(heating);
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
  add_modes(stack, {heating, dx, dy, offsets}, highest_heat_wave(stack, layer, z), parities, modes,
            into);
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
  require_supported(heating);
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
  add_modes(stack, {heating, dx, dy, offsets}, highest_heat_wave(stack, layer, z), {Parity{}},
            modes, into);
  return parts;
}

}  // namespace samcontact::operators
