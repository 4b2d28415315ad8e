// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/creeping_displacement.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

#include "samcontact/operators/surface/kernel_floor.hpp"
#include "samcontact/operators/surface/surface_influence.hpp"

namespace samcontact::operators {
namespace {

/// Elastic compliance of both bodies together.
struct Elastic2 {
  const std::vector<CreepingBody>& bodies;
  double wave_compliance(double wavenumber) const {
    double sum = 0.0;
    for (const CreepingBody& body : bodies) sum += body.medium->wave_compliance(wavenumber);
    return sum;
  }
};

}  // namespace

CreepingDisplacement::CreepingDisplacement(const Grid& grid,
                                           const std::vector<CreepingBody>& bodies)
    : convolution_(grid), kernels_(creep_kernels(grid, bodies, convolution_)) {
  const double longest = std::max(grid.nx * grid.dx, grid.ny * grid.dy);
  longest_compliance_ = Elastic2{bodies}.wave_compliance(2 * std::numbers::pi / longest);
  SurfaceInfluence elastic;
  for (const CreepingBody& body : bodies) elastic.add(body.medium);
  self_influence_ = elastic.elastic(grid, CellOffsets::lattice(1, 1))[0];
  prepare_modes(grid, kernel_floor(grid, Elastic2{bodies}));
}

/// Smaller one of the displacements that the cells at both ends of x cause at each other.
double CreepingDisplacement::least_at_ends(const Grid& grid) const {
  const std::size_t last = (static_cast<std::size_t>(grid.nx) - 1) * grid.ny;
  Field first(grid.surface_size(), 0.0), other = first;
  first[0] = other[last] = 1.0;
  ComplexField work;
  apply(first.data(), first.data(), work);
  apply(other.data(), other.data(), work);
  return std::min(first[last], other[0]);
}

void CreepingDisplacement::prepare_modes(const Grid& grid, double floor) {
  modes_ = kernels_;
  Field& even = modes_[0].quarter;
  // Nothing resists a uniform pressure on whole periods: its mode counts like the next one.
  if (grid.period.x > 0 && grid.period.y > 0) {
    const std::size_t width = convolution_.mx() / 2 + 1;
    even[0] = width > 1 ? even[1] : even[width];
  }
  if (grid.period.y > 0 && grid.period.x == 0) {
    // The track of a line load is infinitely long: it lowers or raises the whole grid.
    const KernelOffsets& offsets = convolution_.offsets();
    ParityKernel uniform{kernels_[0].parity,
                         Field(static_cast<std::size_t>(offsets.nx) * offsets.ny, 1.0)};
    convolution_.transform(uniform);
    const double level = least_at_ends(grid);
    for (std::size_t n = 0; n < even.size(); ++n) even[n] -= level * uniform.quarter[n];
  }
  // The spectra contain 1/(mx my) of the two transforms.
  const double points = static_cast<double>(convolution_.mx()) * convolution_.my();
  for (double& value : even) value = std::max(value, floor / points);
}

std::vector<ParityKernel> CreepingDisplacement::inverse(double spring) const {
  std::vector<ParityKernel> inverse = modes_;
  Field &even = inverse[0].quarter, &odd = inverse[1].quarter;
  const double points = static_cast<double>(convolution_.mx()) * convolution_.my();
  for (std::size_t n = 0; n < even.size(); ++n) {
    const double real = even[n] * points + spring, across = odd[n] * points;
    const double square = (real * real + across * across) * points;
    even[n] = real / square;
    odd[n] = -across / square;
  }
  return inverse;
}

}  // namespace samcontact::operators
