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
#include "samcontact/operators/heat/step_table.hpp"

namespace samcontact::operators {
namespace {

using kernels::HeatedWave;
using kernels::Parity;

/// Decay exponent beyond which the reflection of a wave is below rounding.
constexpr double deepest_heat_wave = 42.0;
/// Smallest wavenumber of a table over a finite time, times the longest length.
constexpr double lowest_step_wave = 1e-12;

/// Cell of the grid, and where its influence is needed.
struct HeatedCell {
  const Heating& heating;
  double dx, dy;
  const Offsets& offsets;
};

void require_supported(const Heating& heating) {
  if (heating.age != Heating::infinity() && heating.is_moving()) {
    throw std::invalid_argument("a moving layered body must be heated in a steady state");
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

/// Components of a field in the frame of the wavevector, those along x and y, and the function
/// turn(in, cos, sin, out) from the former to the latter.
template <class Turn>
struct Components {
  int count = 0;
  std::vector<Parity> parities;  // at rest
  Turn turn;
};

/// Rest of a field by rings, for a source at rest. at: q, and values of all components.
template <class At, class Turn>
Field sums_at_rest(const HeatedCell& cell, double highest, double longest,
                   const Components<Turn>& components, const At& at) {
  const auto modes = [at = at, components, in = std::vector<double>(components.count)](
                         double kx, double ky, double* values) mutable {
    const double q = std::hypot(kx, ky);
    at(q, in.data());
    components.turn(in.data(), kx / q, ky / q, values);
  };
  return kernels::ring_sums({components.parities, modes, highest, longest, true}, cell.dx, cell.dy,
                            cell.offsets.x, cell.offsets.y);
}

/// Counterpart for a moving source, [component][part][..], along the motion fastest.
template <class Modes, class Turn>
Field sums_in_motion(const HeatedStack& stack, const HeatedCell& cell, double highest,
                     double longest, const Components<Turn>& components, const Modes& modes) {
  // Wakes are along x: axes are exchanged for a body that moves along y.
  using Complex = std::complex<double>;
  const auto& [heating, dx, dy, offsets] = cell;
  const bool along_x = heating.speed_x != 0;
  const double speed = std::fabs(along_x ? heating.speed_x : heating.speed_y);
  const auto at = [own = modes, along_x, speed, components,
                   in = std::vector<Complex>(components.count)](double along, double across,
                                                                Complex* values) mutable {
    const double q = std::hypot(along, across), c = along / q, s = across / q;
    own(q, Complex(0.0, speed * along), in.data());
    along_x ? components.turn(in.data(), c, s, values) : components.turn(in.data(), s, c, values);
  };
  std::vector<Parity> parities = components.parities;
  if (!along_x) {
    for (Parity& parity : parities) std::swap(parity.odd_x, parity.odd_y);
  }
  double slowest = stack.thermal[0].diffusivity;
  for (const Thermal& layer : stack.thermal) slowest = std::min(slowest, layer.diffusivity);
  return kernels::wake_sums({parities, at, highest, longest, speed / slowest}, along_x ? dx : dy,
                            along_x ? dy : dx, along_x ? offsets.x : offsets.y,
                            along_x ? offsets.y : offsets.x);
}

/// Adds the rest of a field. modes(double{}) and modes(std::complex<double>{}) return functions of
/// q, rate and the values of all components.
template <class Modes, class Turn>
void add_modes(const HeatedStack& stack, const HeatedCell& cell, double highest,
               const Components<Turn>& components, const Modes& modes,
               std::span<ParityParts* const> into) {
  const auto& [heating, dx, dy, offsets] = cell;
  const std::size_t nx = offsets.x.size(), ny = offsets.y.size(), plane = nx * ny;
  double longest = longest_heat_length(stack);
  if (heating.is_moving()) {
    const bool along_x = heating.speed_x != 0;
    const bool is_reversed = (along_x ? heating.speed_x : heating.speed_y) < 0;
    const Field sums =
        sums_in_motion(stack, cell, highest, longest, components, modes(std::complex<double>{}));
    const double* from = sums.data();
    for (ParityParts* parts : into) {
      for (const int flip : {0, along_x ? 1 : 2}) {
        Field& part = (*parts)[flip];
        part.resize(plane);
        const double sign = flip > 0 && is_reversed ? -1.0 : 1.0;
        for (std::size_t j = 0; j < ny; ++j) {
          for (std::size_t i = 0; i < nx; ++i) {
            part[j * nx + i] += sign * from[along_x ? j * nx + i : i * ny + j];
          }
        }
        from += plane;
      }
    }
    return;
  }
  Field sums;
  if (heating.age == Heating::infinity()) {
    const auto at = [own = modes(double{})](double q, double* values) mutable {
      own(q, 0.0, values);
    };
    sums = sums_at_rest(cell, highest, longest, components, at);
  } else {
    for (const Thermal& layer : stack.thermal) {
      longest = std::max(longest, std::sqrt(layer.diffusivity * heating.age));
    }
    const double extent = std::max({longest, offsets.x.back(), offsets.y.back()});
    const StepTable table(modes(std::complex<double>{}), components.count, heating.age,
                          lowest_step_wave / extent, 2.1 * highest);
    const auto at = [&table](double q, double* values) { table.at(q, values); };
    sums = sums_at_rest(cell, highest, longest, components, at);
  }
  const double* from = sums.data();
  for (ParityParts* parts : into) {
    Field& part = (*parts)[0];
    part.resize(plane);
    for (std::size_t n = 0; n < plane; ++n) part[n] += *from++;
  }
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
  add_modes(stack, {heating, dx, dy, offsets}, highest_heat_wave(stack, 0, 0.0),
            Components{1, {Parity{}}, copy_one}, modes, into);
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
  add_modes(stack, {heating, dx, dy, offsets}, highest_heat_wave(stack, layer, z),
            Components{4, parities, turn_stress}, modes, into);
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
  add_modes(stack, {heating, dx, dy, offsets}, highest_heat_wave(stack, layer, z),
            Components{1, {Parity{}}, copy_one}, modes, into);
  return parts;
}

}  // namespace samcontact::operators
