// SPDX-License-Identifier: GPL-3.0-or-later
// Steady motion of viscoelastic bodies through a contact: influence of tractions on the relative
// displacement, with the creep of the material that has passed.
#pragma once

#include <vector>

#include "samcontact/base/grid.hpp"
#include "samcontact/operators/convolution/surface_convolution.hpp"
#include "samcontact/operators/medium/medium.hpp"

namespace samcontact::operators {

/// Creep of material that moves through the contact at a constant speed. After a distance s under
/// constant traction its displacement is 1 + sum of amount (1 - exp(-s/distance)) times the elastic
/// one.
struct MovingCreep {
  std::vector<double> amounts;    // [-], >= 0
  std::vector<double> distances;  // speed times retardation time [m], >= 0; 0: fully crept
  bool towards_plus_x = false;    // whether the material moves towards +x, or else towards -x
};

/// One body of a contact.
struct CreepingBody {
  SharedMedium medium;  // with the instantaneous elastic constants
  MovingCreep creep;
  double factor = 1.0;  // on its displacement
};

/// Influence of pressure on the gap in the steady state: spectra of its even and its odd part in x,
/// for the transforms of `convolution`. Along a direction that is not periodic, pressure is linear
/// between cell centres in the creep and uniform in each cell in the displacement, and the whole
/// track of the contact is included; along a periodic x, the factor of each Fourier mode is exact.
std::vector<ParityKernel> creep_kernels(const Grid& grid, const std::vector<CreepingBody>& bodies,
                                        const SurfaceConvolution& convolution);

/// The same for the displacement along an axis due to a traction, on a grid that is not periodic
/// along x; empty: all bodies are rigid.
std::vector<ParityKernel> creep_kernels(const Grid& grid, const std::vector<CreepingBody>& bodies,
                                        const SurfaceConvolution& convolution, Traction kind,
                                        Axis axis);

}  // namespace samcontact::operators
