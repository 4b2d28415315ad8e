// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/medium/layered_influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "samcontact/kernels/buried_displacement.hpp"
#include "samcontact/kernels/layered_wave.hpp"
#include "samcontact/kernels/rings.hpp"
#include "samcontact/operators/influence/corner_sums.hpp"

namespace samcontact::operators {
namespace {

using kernels::WaveCompliance;

/// Wavenumber times thickness above which the reflection from the bottom of a layer is below
/// rounding.
constexpr double deepest_wave = 22.0;
/// Counterpart for stress, times twice the thickness less the depth, or times the depth.
constexpr double deepest_stress_wave = 42.0;
/// Smallest wavenumber that is evaluated, times the longest length: the limit is linear in it.
constexpr double shortest_wave = 1e-5;

/// Length over which a body differs from its substrate: stiff layers bend like plates.
double longest_length(const Stack& stack) {
  double stiffest = 1.0;
  for (const ElasticLayer& layer : stack.layers) {
    if (!stack.substrate.is_rigid()) {
      stiffest = std::max(stiffest, layer.elastic.E / stack.substrate.E);
    }
  }
  return 2 * stack.thickness() * std::cbrt(stiffest);
}

WaveCompliance combined(const WaveCompliance& a, double factor, const WaveCompliance& b) {
  return {a.along + factor * b.along, a.coupling + factor * b.coupling, a.down + factor * b.down,
          a.across + factor * b.across};
}

/// Displacement along an axis due to Fourier modes of a traction, times the wavenumber, with the
/// direction of the wavevector.
double component(const WaveCompliance& of, Traction traction, Axis axis, double c, double s) {
  if (traction == Traction::shear_y) {
    return component(of, Traction::shear_x, exchanged(axis), s, c);
  }
  if (traction == Traction::pressure) {
    return axis == Axis::z ? of.down : -of.coupling * (axis == Axis::x ? c : s);
  }
  if (axis == Axis::z) return c * of.coupling;
  return axis == Axis::x ? c * c * of.along + s * s * of.across : c * s * (of.across - of.along);
}

/// Counterpart for modes exp(-q d)/q on a rectangle: a corner function, whose sum is to be
/// multiplied by 1/(2 pi).
double buried(const WaveCompliance& of, Traction traction, Axis axis, double x, double y,
              double d) {
  if (traction == Traction::shear_y || (traction == Traction::pressure && axis == Axis::y)) {
    return buried(of, exchanged(traction), exchanged(axis), y, x, d);
  }
  if (traction == Traction::pressure) {
    return axis == Axis::z ? of.down * kernels::buried_displacement(x, y, d)
                           : -of.coupling * kernels::buried_coupling(x, y, d);
  }
  if (axis == Axis::z) return of.coupling * kernels::buried_coupling(x, y, d);
  if (axis == Axis::y) return (of.across - of.along) * kernels::buried_across(x, y, d);
  return of.across * kernels::buried_displacement(x, y, d) +
         (of.along - of.across) * kernels::buried_along(x, y, d);
}

/// Non-zero wavevector near 0, in the direction in which even components have their mean.
std::array<double, 2> moved_from_zero(double kx, double ky, double longest) {
  if (kx != 0 || ky != 0) return {kx, ky};
  return {shortest_wave / longest, shortest_wave / longest};
}

/// Fourier modes of a traction less those of the closed forms, near and far.
struct DisplacementRest {
  const Stack& stack;
  Traction traction;
  Axis axis;
  WaveCompliance near, far;  // of the top layer; of the substrate less that of the top layer
  double distance, longest;

  DisplacementRest(const Stack& of, Traction load, Axis along)
      : stack(of),
        traction(load),
        axis(along),
        near(kernels::wave_compliance(of.elastic(0))),
        far(combined(kernels::wave_compliance(of.substrate), -1.0, near)),
        distance(2 * of.thickness()),
        longest(longest_length(of)) {}

  kernels::RingWaves waves() const {
    const auto at = [rest = *this, wave = kernels::LayeredWave(stack)](double kx, double ky,
                                                                       double* value) mutable {
      const auto [x, y] = moved_from_zero(kx, ky, rest.longest);
      const double q = std::hypot(x, y);
      wave.set_wavenumber(q);
      const auto layered = combined(wave.compliance(), -1.0, rest.near);
      const auto own = combined(layered, -std::exp(-q * rest.distance), rest.far);
      *value = component(own, rest.traction, rest.axis, x / q, y / q) / q;
    };
    return {
        {compliance_parity(traction, axis)}, at, deepest_wave / stack.layers[0].thickness, longest};
  }
};

/// Primitive in x of the displacement due to a line load at a distance d whose Fourier mode is
/// exp(-k d)/k: with ln(reference/r) if it is even.
double distant_line_primitive(double x, double d, bool odd, double reference) {
  const double log = std::log((x * x + d * d) / (reference * reference)), angle = std::atan(x / d);
  if (odd) return (x * angle - 0.5 * d * log) / std::numbers::pi;
  return -(0.5 * x * log - x + d * angle) / std::numbers::pi;
}

/// Displacement due to a uniform traction: zero for an elastic substrate, whose mean plane is at
/// rest at infinite depth; on a rigid substrate layers are compressed and sheared by a finite
/// amount.
double uniform_displacement(const Stack& stack, Traction traction, Axis axis) {
  if (!stack.substrate.is_rigid() || traction_along(axis) != traction) return 0.0;
  double sum = 0.0;
  for (const auto& [elastic, thickness] : stack.layers) {
    const double nu = elastic.nu, shear = elastic.shear_modulus();
    sum += thickness / (axis == Axis::z ? 2 * shear * (1 - nu) / (1 - 2 * nu) : shear);
  }
  return sum;
}

/// Highest wavenumber at which the stress at a depth differs from that of a half-space.
double highest_stress_wave(const Stack& stack, int layer, double z) {
  return deepest_stress_wave / (layer > 0 ? z : 2 * stack.layers[0].thickness - z);
}

/// Stress due to a Fourier mode of a traction, from that of the tractions along x.
template <class Decays>
kernels::Stress stress_of(const kernels::LayeredWave& wave, Traction traction, int layer,
                          const Decays& decays, double c, double s) {
  if (traction == Traction::pressure) return wave.under_pressure(layer, decays, c, s);
  if (traction == Traction::shear_x) return wave.under_shear_x(layer, decays, c, s);
  const auto rotated = wave.under_shear_x(layer, decays, s, c);
  return {rotated[1], rotated[0], rotated[2], rotated[4], rotated[3], rotated[5]};
}

}  // namespace

Field layered_compliance(const Stack& stack, Traction traction, Axis axis, const Grid& grid,
                         const CellOffsets& offsets) {
  Field table = cell_compliance(stack.elastic(0), traction, axis, grid, offsets);
  if (stack.layers.empty()) return table;
  // At large distances the substrate acts, at a depth that leaves the near field to the top layer.
  const DisplacementRest rest(stack, traction, axis);
  const double scale = grid.dx / (2 * std::numbers::pi);
  const Field distant = corner_sums(offsets, grid.dy / grid.dx, [&](double x, double y) {
    return scale * buried(rest.far, traction, axis, x, y, rest.distance / grid.dx);
  });
  const auto [x, y] = offsets.in_metres(grid.dx, grid.dy);
  const Field sums = kernels::ring_sums(rest.waves(), grid.dx, grid.dy, x, y);
  for (std::size_t n = 0; n < table.size(); ++n) table[n] += distant[n] + sums[n];
  return table;
}

CellInfluence layered_compliance_of_cell(const Stack& stack, Traction traction, Axis axis,
                                         const Grid& grid) {
  CellInfluence influence = compliance_of_cell(stack.elastic(0), traction, axis, grid);
  influence.uniform = {uniform_displacement(stack, traction, axis)};
  influence.cell = [=](int nx, int ny) {
    return layered_compliance(stack, traction, axis, grid, CellOffsets::lattice(nx, ny));
  };
  influence.wave = [=](double kx, double ky, double* value) {
    const double q = std::hypot(kx, ky);
    kernels::LayeredWave wave(stack);
    wave.set_wavenumber(q);
    *value = component(wave.compliance(), traction, axis, kx / q, ky / q) / q;
  };
  influence.strip = [=, near = influence.strip](int nx) {
    Field sums = near(nx);
    const auto parity = compliance_parity(traction, axis);
    if (parity.odd_y) return sums;
    const DisplacementRest rest(stack, traction, axis);
    const double factor = component(rest.far, traction, axis, 1.0, 0.0);
    const double reference = grid.period.reference > 0 ? grid.period.reference : grid.dx;
    std::vector<double> x = CellOffsets::lattice(nx, 1).in_metres(grid.dx, grid.dy).x;
    x.push_back(reference);  // which may lie within the bending length of stiff layers
    Field added = kernels::ring_strip_sums(rest.waves(), grid.dx, x);
    const auto line = [&](double at) {
      return distant_line_primitive(at, rest.distance, parity.odd_x, reference);
    };
    for (int i = 0; i <= nx; ++i) {
      added[i] += factor * (line(x[i] + 0.5 * grid.dx) - line(x[i] - 0.5 * grid.dx));
    }
    const double there = parity.odd_x ? 0.0 : added[nx];
    for (int i = 0; i < nx; ++i) sums[i] += added[i] - there;
    return sums;
  };
  return influence;
}

namespace {

/// See RingWaves.
std::vector<std::size_t> exchanged_modes(Traction traction, Tensor tensor) {
  if (traction != Traction::pressure) return {};
  const auto& places = exchanged_places(tensor);
  return {places.begin(), places.begin() + count(tensor)};
}

/// Stress at a depth due to a Fourier mode of a traction less that of a half-space of the same
/// layer.
kernels::RingWaves stress_rest(const Stack& stack, Traction traction, double z, Tensor tensor) {
  const int layer = stack.layer_at(z);
  const double nu = stack.elastic(layer).nu, longest = std::max(longest_length(stack), z);
  const auto at = [=, wave = kernels::LayeredWave(stack)](double kx, double ky,
                                                          double* values) mutable {
    const auto [x, y] = moved_from_zero(kx, ky, longest);
    const double q = std::hypot(x, y);
    wave.set_wavenumber(q);
    auto stress = stress_of(wave, traction, layer, wave.at(layer, z), x / q, y / q);
    const auto near = wave_stress(traction, x, y, z, nu);
    for (int c = 0; c < 6; ++c) stress[c] -= near[c];
    std::ranges::copy_n(select(stress, tensor).begin(), count(tensor), values);
  };
  kernels::RingWaves waves{{}, at, highest_stress_wave(stack, layer, z), longest};
  for (const int c : components(tensor)) waves.parities.push_back(stress_parity(traction, c));
  waves.exchanged = exchanged_modes(traction, tensor);
  return waves;
}

}  // namespace

Field layered_stress(const Stack& stack, Traction traction, const Grid& grid,
                     const CellOffsets& offsets, double z, Tensor tensor) {
  Field table =
      cell_stress(stack.elastic(stack.layer_at(z)).nu, traction, grid, offsets, z, tensor);
  if (stack.layers.empty()) return table;
  const auto [x, y] = offsets.in_metres(grid.dx, grid.dy);
  const Field sums =
      kernels::ring_sums(stress_rest(stack, traction, z, tensor), grid.dx, grid.dy, x, y);
  for (std::size_t n = 0; n < table.size(); ++n) table[n] += sums[n];
  return table;
}

CellInfluence layered_stress_of_cell(const Stack& stack, Traction traction, const Grid& grid,
                                     double z) {
  const int layer = stack.layer_at(z);
  CellInfluence influence = stress_of_cell(stack.elastic(layer).nu, traction, grid, z);
  influence.cell = [=](int nx, int ny) {
    return layered_stress(stack, traction, grid, CellOffsets::lattice(nx, ny), z, Tensor::full);
  };
  influence.wave = [=](double kx, double ky, double* stress) {
    const double q = std::hypot(kx, ky);
    kernels::LayeredWave wave(stack);
    wave.set_wavenumber(q);
    const auto found = stress_of(wave, traction, layer, wave.at(layer, z), kx / q, ky / q);
    std::ranges::copy(found, stress);
  };
  influence.strip = [=, near = influence.strip](int nx) {
    Field sums = near(nx);
    const auto offsets = CellOffsets::lattice(nx, 1).in_metres(grid.dx, grid.dy);
    const Field rings =
        kernels::ring_strip_sums(stress_rest(stack, traction, z, Tensor::full), grid.dx, offsets.x);
    for (std::size_t n = 0; n < sums.size(); ++n) sums[n] += rings[n];
    return sums;
  };
  return influence;
}

namespace {

/// Displacement along an axis due to Fourier modes of eigenstrain in a layer of cells, [6], from
/// the mean stress due to a traction there. Betti's theorem: the work of a traction on the
/// displacement equals that of its stress on the eigenstrain.
struct ResidualWaves {
  Stack stack;
  Traction traction;
  double z0, z1, nu, longest;
  int own;  // layer of the stack

  ResidualWaves(const Stack& of, Axis axis, const Grid& grid, int layer)
      : stack(of),
        traction(traction_along(axis)),
        z0(layer * grid.dz),
        z1((layer + 1) * grid.dz),
        longest(std::max(longest_length(of), z1)),
        own(of.layer_at(0.5 * (z0 + z1))) {
    nu = stack.elastic(own).nu;
  }

  void evaluate(kernels::LayeredWave& wave, double kx, double ky, double* values) const {
    const double q = std::hypot(kx, ky);
    wave.set_wavenumber(q);
    const auto stress = stress_of(wave, traction, own, wave.mean(own, z0, z1), kx / q, ky / q);
    for (int c = 0; c < 6; ++c) values[c] = (z1 - z0) * betti_factor(traction, c) * stress[c];
  }
  /// Less that of a half-space with the constants of the layer.
  kernels::RingWaves rest() const {
    const auto at = [waves = *this, wave = kernels::LayeredWave(stack)](double kx, double ky,
                                                                        double* values) mutable {
      const auto [x, y] = moved_from_zero(kx, ky, waves.longest);
      waves.evaluate(wave, x, y, values);
      const auto near = wave_mean(waves.traction, x, y, waves.z0, waves.z1, waves.nu);
      for (int c = 0; c < 6; ++c) {
        values[c] -= (waves.z1 - waves.z0) * betti_factor(waves.traction, c) * near[c];
      }
    };
    kernels::RingWaves rings{{}, at, highest_stress_wave(stack, own, own > 0 ? z0 : z1), longest};
    for (int c = 0; c < 6; ++c) rings.parities.push_back(stress_parity(traction, c));
    rings.exchanged = exchanged_modes(traction, Tensor::full);
    return rings;
  }
};

}  // namespace

Field layered_residual_displacement(const Stack& stack, Axis axis, const Grid& grid,
                                    const CellOffsets& offsets, int layer) {
  const ResidualWaves waves(stack, axis, grid, layer);
  Field table = cell_residual_displacement(waves.nu, axis, grid, offsets, layer);
  if (stack.layers.empty()) return table;
  const auto [x, y] = offsets.in_metres(grid.dx, grid.dy);
  const Field sums = kernels::ring_sums(waves.rest(), grid.dx, grid.dy, x, y);
  for (std::size_t n = 0; n < table.size(); ++n) table[n] += sums[n];
  return table;
}

CellInfluence layered_residual_of_cell(const Stack& stack, Axis axis, const Grid& grid, int layer) {
  const ResidualWaves waves(stack, axis, grid, layer);
  CellInfluence influence = residual_of_cell(waves.nu, axis, grid, layer);
  influence.cell = [=](int nx, int ny) {
    return layered_residual_displacement(stack, axis, grid, CellOffsets::lattice(nx, ny), layer);
  };
  influence.wave = [=, wave = kernels::LayeredWave(stack)](double kx, double ky,
                                                           double* values) mutable {
    waves.evaluate(wave, kx, ky, values);
  };
  influence.strip = [=, near = influence.strip](int nx) {
    Field sums = near(nx);
    const auto offsets = CellOffsets::lattice(nx, 1).in_metres(grid.dx, grid.dy);
    const Field rings = kernels::ring_strip_sums(waves.rest(), grid.dx, offsets.x);
    for (std::size_t n = 0; n < sums.size(); ++n) sums[n] += rings[n];
    return sums;
  };
  return influence;
}

}  // namespace samcontact::operators
