// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/surface/surface_displacement.hpp"

#include <utility>

#include "samcontact/operators/medium/finite_body.hpp"

namespace samcontact::operators {

SurfaceDisplacement::SurfaceDisplacement(const Grid& grid, const SurfaceInfluence& influence)
    : convolution_(grid),
      influence_(influence.tabulated(grid, convolution_.offsets())),
      rest_(influence_.rest(grid, convolution_.offsets())),
      ends_(influence_.ends(grid)),
      self_influence_(influence_.elastic(grid, CellOffsets::lattice(1, 1))[0]) {
  even_.push_back({compliance_parity(Traction::pressure, Axis::z),
                   influence_.even(grid, CellOffsets::lattice(convolution_.offsets().nx,
                                                              convolution_.offsets().ny))});
  convolution_.transform(even_[0]);
  for (ParityKernel& kernel : rest_) convolution_.transform(kernel);
}

void SurfaceDisplacement::apply(const double* pressure, double* displacement,
                                ComplexField& work) const {
  if (!ends_) {
    convolution_.apply(even_, pressure, displacement, work);
    return;
  }
  const Field ends = ends_->displacement(pressure);
  convolution_.apply(even_, pressure, displacement, work);
  for (std::size_t i = 0; i < ends.size(); ++i) displacement[i] += ends[i];
}

void SurfaceDisplacement::apply_rest(const double* pressure, double* displacement,
                                     ComplexField& work) const {
  convolution_.apply(rest_, pressure, displacement, work);
}

Field surface_displacement(const Grid& grid, const Medium& medium, const Heating& heating,
                           const Tractions& tractions, double shear_sign, Axis axis) {
  Field total(grid.surface_size(), 0.0), part(grid.surface_size());
  if (medium.is_rigid()) return total;
  const SurfaceConvolution convolution(grid);
  const auto offsets = CellOffsets::lattice(convolution.offsets().nx, convolution.offsets().ny);
  ComplexField work;
  for (const Traction kind : all_tractions) {
    const Field& field = tractions.of(kind);
    if (field.empty()) continue;
    std::vector<ParityKernel> kernels;
    kernels.push_back(
        {compliance_parity(kind, axis), medium.compliance(kind, axis, grid, offsets)});
    if (kind == Traction::pressure && axis == Axis::z && heating.is_on()) {
      auto parts = heat_of(medium)->displacement(heating, grid.dx, grid.dy,
                                                 offsets.in_metres(grid.dx, grid.dy));
      for (int flip = 0; flip < 4; ++flip) {
        if (parts[flip].empty()) continue;
        kernels.push_back({{(flip & 1) != 0, (flip & 2) != 0, false}, std::move(parts[flip])});
      }
    }
    for (ParityKernel& kernel : kernels) convolution.transform(kernel);
    convolution.apply(kernels, field.data(), part.data(), work);
    const double sign = sign_of(kind, shear_sign);
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += sign * part[i];
  }
  if (const auto faced = faced_body(medium); faced && !tractions.pressure.empty()) {
    const auto ends = EndEffects::of(grid, {{faced->elastic, faced->faces}});
    if (ends) add(ends->displacement(tractions.pressure.data()), total);
  }
  return total;
}

}  // namespace samcontact::operators
