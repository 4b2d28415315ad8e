// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over Fourier modes of the thermal fields of a layered body, for one heated cell: at rest, in
// motion, in the steady state and for a finite time (layered_heat.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <span>
#include <utility>
#include <vector>

#include "samcontact/base/thermal_stack.hpp"
#include "samcontact/kernels/oblique_wake_sums.hpp"
#include "samcontact/kernels/rings.hpp"
#include "samcontact/kernels/wake_sums.hpp"
#include "samcontact/operators/heat/heating.hpp"
#include "samcontact/operators/heat/step_table.hpp"

namespace samcontact::operators {

/// Smallest wavenumber of a table over a finite time, times the longest length: at rest, and in
/// motion.
inline constexpr double lowest_step_wave = 1e-12, lowest_pulse_wave = 1e-6;

/// Cell of the grid, and where its influence is needed.
struct HeatedCell {
  const Heating& heating;
  double dx, dy;
  const Offsets& offsets;
};

/// Smallest diffusivity of all layers.
inline double slowest_diffusion(const HeatedStack& stack) {
  return std::ranges::min(stack.thermal, {}, &Thermal::diffusivity).diffusivity;
}

/// Components of a field in the frame of the wavevector, those along x and y, and the function
/// turn(in, cos, sin, out) from the former to the latter.
template <class Turn>
struct Components {
  int count = 0;
  std::vector<kernels::Parity> parities;  // at rest
  Turn turn;
  double power = 0.5;  // of time, in the growth of the field under a constant flux
};
// Some compilers do not deduce the argument of an aggregate.
template <class Turn>
Components(int, std::vector<kernels::Parity>, Turn) -> Components<Turn>;
template <class Turn>
Components(int, std::vector<kernels::Parity>, Turn, double) -> Components<Turn>;

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
  return kernels::ring_sums({components.parities,
                             modes,
                             highest,
                             longest,
                             true,
                             {},
                             cell.heating.period_x,
                             cell.heating.period_y},
                            cell.dx, cell.dy, cell.offsets.x, cell.offsets.y);
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
  std::vector<kernels::Parity> parities = components.parities;
  if (!along_x) {
    for (kernels::Parity& parity : parities) std::swap(parity.odd_x, parity.odd_y);
  }
  const double slowest = slowest_diffusion(stack);
  return kernels::wake_sums({parities, at, highest, longest, speed / slowest}, along_x ? dx : dy,
                            along_x ? dy : dx, along_x ? offsets.x : offsets.y,
                            along_x ? offsets.y : offsets.x);
}

/// Indices of the parity parts that may be non-zero.
inline std::vector<int> flips_of(const Heating& heating) {
  std::vector<int> flips;
  for (const int flip : {0, 1, 2, 3}) {
    if ((flip & 1) != 0 && heating.speed_x == 0) continue;
    if ((flip & 2) != 0 && heating.speed_y == 0) continue;
    flips.push_back(flip);
  }
  return flips;
}

/// Value of a part of the modes exp(-i omega age), of which `plus` and `minus` are those of (kx,
/// ky) and (kx, -ky).
inline double part_of(int flip, const kernels::Parity& rest, std::complex<double> plus,
                      std::complex<double> minus) {
  const double by_x = rest.odd_x ? -1.0 : 1.0, by_y = rest.odd_y ? -1.0 : 1.0;
  const std::complex<double> even = 0.5 * (plus + minus), odd = 0.5 * (plus - minus);
  switch (flip) {
    case 0:
      return even.real();
    case 1:
      return -by_x * even.imag();
    case 2:
      return -by_y * odd.imag();
    default:
      return -by_x * by_y * odd.real();
  }
}

/// Parities of the parts of all components, [flip][component].
inline std::vector<kernels::Parity> parities_of(const std::vector<kernels::Parity>& rest,
                                                const std::vector<int>& flips) {
  std::vector<kernels::Parity> parities;
  for (const int flip : flips) {
    for (const kernels::Parity& one : rest) {
      parities.push_back(
          {one.odd_x != ((flip & 1) != 0), one.odd_y != ((flip & 2) != 0), one.odd_z});
    }
  }
  return parities;
}

/// Rest of a field in steady motion between x and y, [flip][component][..].
template <class Modes, class Turn>
Field sums_in_oblique_motion(const HeatedStack& stack, const HeatedCell& cell, double highest,
                             double longest, const Components<Turn>& components,
                             const Modes& modes) {
  using Complex = std::complex<double>;
  const auto& [heating, dx, dy, offsets] = cell;
  const double vx = heating.speed_x, vy = heating.speed_y, slowest = slowest_diffusion(stack);
  const std::vector<int> flips = flips_of(heating);
  const std::size_t count = components.parities.size();
  kernels::ObliqueWaves waves{
      parities_of(components.parities, flips), {}, highest, longest, vx / slowest, vy / slowest};
  waves.at = [own = modes, &components, flips, vx, vy, count,
              in = std::vector<Complex>(components.count),
              out = std::vector<Complex>(2 * count)](double kx, double ky, double* values) mutable {
    const double q = std::hypot(kx, ky);
    own(q, Complex(0.0, kx * vx + ky * vy), in.data());
    components.turn(in.data(), kx / q, ky / q, out.data());
    own(q, Complex(0.0, kx * vx - ky * vy), in.data());
    components.turn(in.data(), kx / q, ky / q, out.data() + count);
    for (const int flip : flips) {
      for (std::size_t c = 0; c < count; ++c) {
        *values++ = part_of(flip, components.parities[c], out[c], out[count + c]);
      }
    }
  };
  return kernels::oblique_wake_sums(waves, dx, dy, offsets.x, offsets.y);
}

/// Rest of a field of a moving body that has been heated for a time, [flip][component][..].
template <class Modes, class Turn>
Field sums_since(const HeatedStack& stack, const HeatedCell& cell, double highest, double longest,
                 const Components<Turn>& components, const Modes& modes) {
  using Complex = std::complex<double>;
  const auto& [heating, dx, dy, offsets] = cell;
  const double vx = heating.speed_x, vy = heating.speed_y, age = heating.age;
  const double speed = std::hypot(vx, vy), slowest = slowest_diffusion(stack);
  const double extent = std::max({longest, offsets.x.back(), offsets.y.back(), speed * age});
  const PulseTable table(modes, components.count, {age, speed, slowest, components.power},
                         lowest_pulse_wave / extent, 2.1 * highest);
  const std::vector<int> flips = flips_of(heating);
  kernels::RingWaves waves{{},
                           {},
                           highest,
                           longest,
                           true,
                           {std::fabs(vx) * age, std::fabs(vy) * age, speed / slowest},
                           heating.period_x,
                           heating.period_y};
  waves.parities = parities_of(components.parities, flips);
  const std::size_t count = components.parities.size();
  waves.at = [&table, &components, flips, vx, vy, count, weights = std::vector<double>{},
              in = std::vector<Complex>(2 * components.count),
              out = std::vector<Complex>(2 * count)](double kx, double ky, double* values) mutable {
    const double q = std::hypot(kx, ky);
    const std::array omegas{kx * vx + ky * vy, kx * vx - ky * vy};
    table.at(q, omegas, weights, in.data());
    components.turn(in.data(), kx / q, ky / q, out.data());
    components.turn(in.data() + components.count, kx / q, ky / q, out.data() + count);
    for (const int flip : flips) {
      for (std::size_t c = 0; c < count; ++c) {
        *values++ = part_of(flip, components.parities[c], out[c], out[count + c]);
      }
    }
  };
  return kernels::ring_sums(waves, dx, dy, offsets.x, offsets.y);
}

/// Adds sums [part][..] to some parts of fields.
inline void add_to_parts(const double* from, int flip, std::size_t plane,
                         std::span<ParityParts* const> into) {
  for (ParityParts* parts : into) {
    Field& part = (*parts)[flip];
    part.resize(plane);
    for (std::size_t n = 0; n < plane; ++n) part[n] += *from++;
  }
}

/// Adds sums [flip][component][..] to all parts of fields.
inline void add_all_parts(const Heating& heating, const double* from, std::size_t plane,
                          std::span<ParityParts* const> into) {
  for (const int flip : flips_of(heating)) {
    add_to_parts(from, flip, plane, into);
    from += plane * into.size();
  }
}

/// Adds the rest of a field in steady motion along x or y.
template <class Modes, class Turn>
void add_in_motion(const HeatedStack& stack, const HeatedCell& cell, double highest,
                   const Components<Turn>& components, const Modes& modes,
                   std::span<ParityParts* const> into) {
  const auto& [heating, dx, dy, offsets] = cell;
  const std::size_t nx = offsets.x.size(), ny = offsets.y.size();
  const bool along_x = heating.speed_x != 0;
  const bool is_reversed = (along_x ? heating.speed_x : heating.speed_y) < 0;
  const Field sums =
      sums_in_motion(stack, cell, highest, longest_heat_length(stack), components, modes);
  const double* from = sums.data();
  for (ParityParts* parts : into) {
    for (const int flip : {0, along_x ? 1 : 2}) {
      Field& part = (*parts)[flip];
      part.resize(nx * ny);
      const double sign = flip > 0 && is_reversed ? -1.0 : 1.0;
      for (std::size_t j = 0; j < ny; ++j) {
        for (std::size_t i = 0; i < nx; ++i) {
          part[j * nx + i] += sign * from[along_x ? j * nx + i : i * ny + j];
        }
      }
      from += nx * ny;
    }
  }
}

/// Adds the rest of a field. modes(double{}) and modes(std::complex<double>{}) return functions of
/// q, rate and the values of all components.
template <class Modes, class Turn>
void add_modes(const HeatedStack& stack, const HeatedCell& cell, double highest,
               const Components<Turn>& components, const Modes& modes,
               std::span<ParityParts* const> into) {
  const auto& [heating, dx, dy, offsets] = cell;
  const std::size_t plane = offsets.x.size() * offsets.y.size();
  double longest = longest_heat_length(stack);
  if (heating.age == Heating::infinity()) {
    if (heating.speed_x != 0 && heating.speed_y != 0) {
      const Field sums = sums_in_oblique_motion(stack, cell, highest, longest, components,
                                                modes(std::complex<double>{}));
      add_all_parts(heating, sums.data(), plane, into);
      return;
    }
    if (heating.is_moving()) {
      add_in_motion(stack, cell, highest, components, modes(std::complex<double>{}), into);
      return;
    }
    const auto at = [own = modes(double{})](double q, double* values) mutable {
      own(q, 0.0, values);
    };
    const Field sums = sums_at_rest(cell, highest, longest, components, at);
    add_to_parts(sums.data(), 0, plane, into);
    return;
  }
  for (const Thermal& layer : stack.thermal) {
    longest = std::max(longest, std::sqrt(layer.diffusivity * heating.age));
  }
  if (heating.is_moving()) {
    const Field sums =
        sums_since(stack, cell, highest, longest, components, modes(std::complex<double>{}));
    add_all_parts(heating, sums.data(), plane, into);
    return;
  }
  const double extent = std::max({longest, offsets.x.back(), offsets.y.back()});
  const StepTable table(modes(std::complex<double>{}), components.count, heating.age,
                        lowest_step_wave / extent, 2.1 * highest);
  const auto at = [&table](double q, double* values) { table.at(q, values); };
  const Field sums = sums_at_rest(cell, highest, longest, components, at);
  add_to_parts(sums.data(), 0, plane, into);
}

/// Adds the mean of the rest of a field on a surface that is periodic along x and y.
template <class Modes, class Turn>
void add_mean(const HeatedStack& stack, const HeatedCell& cell, const Components<Turn>& components,
              const Modes& modes, std::span<ParityParts* const> into) {
  const auto& [heating, dx, dy, offsets] = cell;
  if (heating.period_x == 0 || heating.period_y == 0) return;
  const double length = std::max({longest_heat_length(stack), heating.period_x, heating.period_y,
                                  std::sqrt(slowest_diffusion(stack) * heating.age)});
  const double q = lowest_pulse_wave / length;
  std::vector<double> in(components.count), out(components.parities.size());
  StepTable(modes, components.count, heating.age, q, 2 * q).at(q, in.data());
  components.turn(in.data(), 1.0, 0.0, out.data());
  const double share = dx * dy / (heating.period_x * heating.period_y);
  for (std::size_t c = 0; c < into.size(); ++c) {
    const kernels::Parity& parity = components.parities[c];
    if (parity.odd_x || parity.odd_y) continue;
    for (double& value : (*into[c])[0]) value += share * out[c];
  }
}

}  // namespace samcontact::operators
