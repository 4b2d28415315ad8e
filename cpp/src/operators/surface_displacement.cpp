// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface_displacement.hpp"

#include <utility>

namespace samcontact::operators {
namespace {

constexpr kernels::Parity even{false, false, false};
constexpr kernels::Parity odd_in_y{false, true, false};

}  // namespace

SurfaceDisplacement::SurfaceDisplacement(const Grid& grid, const SurfaceInfluence& influence)
    : convolution_(grid),
      rest_(influence.rest(grid.dx, grid.dy, grid.nx, grid.ny)),
      self_influence_(influence.elastic(grid.dx, grid.dy, 1, 1)[0]) {
  even_.push_back({even, influence.even(grid.dx, grid.dy, grid.nx, grid.ny)});
  convolution_.transform(even_[0]);
  for (ParityKernel& kernel : rest_) convolution_.transform(kernel);
}

void SurfaceDisplacement::apply(const double* pressure, double* displacement,
                                ComplexField& work) const {
  convolution_.apply(even_, pressure, displacement, work);
}

void SurfaceDisplacement::apply_rest(const double* pressure, double* displacement,
                                     ComplexField& work) const {
  convolution_.apply(rest_, pressure, displacement, work);
}

Field surface_displacement(const Grid& grid, const SurfaceInfluence& influence,
                           double coupling_compliance, const double* pressure,
                           const double* shear_x, const double* shear_y) {
  const SurfaceConvolution convolution(grid);
  Field total(grid.surface_size(), 0.0), part(grid.surface_size());
  ComplexField work;
  const auto add = [&](const double* traction, std::vector<ParityKernel> kernels) {
    for (ParityKernel& kernel : kernels) convolution.transform(kernel);
    convolution.apply(kernels, traction, part.data(), work);
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += part[i];
  };
  if (pressure != nullptr) {
    auto kernels = influence.rest(grid.dx, grid.dy, grid.nx, grid.ny);
    kernels.push_back({even, influence.even(grid.dx, grid.dy, grid.nx, grid.ny)});
    add(pressure, std::move(kernels));
  }
  if (coupling_compliance == 0) return total;
  const SurfaceInfluence shear(0.0, coupling_compliance);
  if (shear_x != nullptr) add(shear_x, shear.rest(grid.dx, grid.dy, grid.nx, grid.ny));
  if (shear_y != nullptr) {
    // The same with x and y exchanged.
    const auto kernels = shear.rest(grid.dy, grid.dx, grid.ny, grid.nx);
    Field table(grid.surface_size());
    for (int j = 0; j < grid.ny; ++j) {
      for (int i = 0; i < grid.nx; ++i) {
        table[static_cast<std::size_t>(j) * grid.nx + i] =
            kernels[0].quarter[static_cast<std::size_t>(i) * grid.ny + j];
      }
    }
    add(shear_y, {{odd_in_y, std::move(table)}});
  }
  return total;
}

}  // namespace samcontact::operators
