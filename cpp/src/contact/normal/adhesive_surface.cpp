// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/adhesive_surface.hpp"

#include <algorithm>
#include <stdexcept>

#include "samcontact/fft/plan.hpp"
#include "samcontact/operators/surface/near_displacement.hpp"

namespace samcontact::contact {
namespace {

/// Waves along the longer side of a periodic surface from which on the preconditioner is the
/// compliance: about the number of contact spots along it. Without this limit, the descent
/// overshoots in longer waves.
constexpr int waves_of_spots = 6;
/// Share of the largest compliance of a wave below which a compliance is zero to rounding.
constexpr double rounding = 1e-13;

Field spectrum(const fft::PeriodicTransform& transform, const Grid& grid,
               const operators::SurfaceInfluence& influence) {
  return operators::periodic_spectrum(transform, grid, [&](const operators::CellOffsets& offsets) {
    return influence.elastic(grid, offsets);
  });
}

}  // namespace

AdhesiveSurface::AdhesiveSurface(const Grid& grid, const operators::SurfaceInfluence& influence)
    : grid_(grid),
      transform_(fft::convolution_size(grid.nx, grid.period.x),
                 fft::convolution_size(grid.ny, grid.period.y),
                 fft::convolution_size(grid.nx, grid.period.x),
                 fft::convolution_size(grid.ny, grid.period.y)),
      compliance_(spectrum(transform_, grid, influence)),
      self_influence_(influence.elastic(grid, operators::CellOffsets::lattice(1, 1))[0]) {
  if (influence.ends(grid)) {
    throw std::invalid_argument("adhesion cannot be combined with free faces of the bodies");
  }
  invert();
}

AdhesiveSurface AdhesiveSurface::with_spring(double compliance) const {
  AdhesiveSurface surface = *this;
  // The padding carries no pressure: a uniform displacement of all cells acts as one of the grid.
  surface.compliance_[0] += compliance * grid_.cell_area();
  surface.invert();
  return surface;
}

AdhesiveSurface AdhesiveSurface::with_free_approach() const {
  AdhesiveSurface surface = *this;
  const auto points = static_cast<double>(size());
  surface.uniform_compliance_ = compliance_[0] * points;
  surface.has_free_mean_ = false;
  surface.has_free_approach_ = true;
  surface.stiffness_[0] = 0.0;
  if (has_free_mean_) {
    surface.preconditioner_[0] = *std::max_element(preconditioner_.begin(), preconditioner_.end());
  }
  return surface;
}

void AdhesiveSurface::invert() {
  const Grid& grid = grid_;
  const auto points = static_cast<double>(size());
  const double largest = *std::max_element(compliance_.begin(), compliance_.end());
  const bool periodic = grid.period.x > 0 && grid.period.y > 0;
  has_free_mean_ = periodic && compliance_[0] <= rounding * largest;
  double shift = 0.0;
  if (periodic) {
    const bool along_x = grid.nx * grid.dx >= grid.ny * grid.dy;
    const int waves = std::min(waves_of_spots, (along_x ? transform_.mx() : transform_.my()) / 2);
    const std::size_t at = along_x ? waves : static_cast<std::size_t>(waves) * transform_.hx();
    shift = 1.0 / (compliance_[at] * points);
  }
  stiffness_.resize(compliance_.size());
  preconditioner_.resize(compliance_.size());
  for (std::size_t k = 0; k < compliance_.size(); ++k) {
    double& compliance = compliance_[k];
    if (has_free_mean_ && compliance <= rounding * largest) {
      compliance = stiffness_[k] = preconditioner_[k] = 0.0;
      continue;
    }
    if (!(compliance > 0)) {
      throw std::invalid_argument(
          "adhesion requires a positive stiffness of the surface for each wave, but the influence "
          "coefficients of these bodies on this grid have none: enlarge the grid");
    }
    const double stiffness = 1.0 / (compliance * points);  // the spectrum contains 1/points
    stiffness_[k] = stiffness / points;
    preconditioner_[k] = 1.0 / (stiffness + shift) / points;
  }
}

void AdhesiveSurface::displace(const Field& pressure, Field& displacement,
                               ComplexField& work) const {
  transform_.filter(pressure.data(), compliance_.data(), displacement.data(), work);
}

void AdhesiveSurface::press(const Field& displacement, Field& pressure, ComplexField& work) const {
  transform_.filter(displacement.data(), stiffness_.data(), pressure.data(), work);
}

void AdhesiveSurface::precondition(const Field& pressure, Field& displacement,
                                   ComplexField& work) const {
  transform_.filter(pressure.data(), preconditioner_.data(), displacement.data(), work);
}

Field AdhesiveSurface::over_grid(const Field& padded) const {
  Field found(grid_.surface_size());
  for (int i = 0; i < grid_.nx; ++i) {
    std::copy_n(padded.data() + row(i), grid_.ny,
                found.data() + static_cast<std::size_t>(i) * grid_.ny);
  }
  return found;
}

Field AdhesiveSurface::padded(const Field& over_grid) const {
  Field found(size(), 0.0);
  for (int i = 0; i < grid_.nx; ++i) {
    std::copy_n(over_grid.data() + static_cast<std::size_t>(i) * grid_.ny, grid_.ny,
                found.data() + row(i));
  }
  return found;
}

}  // namespace samcontact::contact
