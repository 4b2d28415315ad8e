// SPDX-License-Identifier: GPL-3.0-or-later
// Radial return for J2 plasticity with isotropic and kinematic hardening, backward Euler (Simo &
// Hughes 1998, Computational Inelasticity, boxes 3.1 and 3.2), for a single point.
#pragma once

#include <array>
#include <span>

#include "samcontact/plasticity/material.hpp"

namespace samcontact::plasticity {

/// Components xx, yy, zz, yz, xz, xy of a symmetric tensor.
using Tensor = std::array<double, 6>;

/// Backstresses of a point, one for each backstress of its material.
using Tensors = std::array<Tensor, max_backstresses>;

/// sqrt(3/2 s:s), s the deviator [Pa].
double von_mises(const Tensor& stress);

/// Equivalent plastic strain increment d >= 0 that solves trial - 3 G d = yield_stress(g + d), to
/// rounding. trial: von Mises stress of the trial state [Pa]; g: equivalent plastic strain before;
/// start: an estimate of d.
double equivalent_increment(double trial, double g, double shear_modulus,
                            const Hardening& hardening, double start = 0.0);

struct Return {
  Tensor increment;   // plastic strain increment (tensor components)
  double equivalent;  // equivalent plastic strain increment
  double excess;      // (von Mises - yield stress) / yield stress of the given stress, >= 0
  double
      overshoot;  // relative violation of the yield condition by the trial state, before hardening
};

/// Returns to the yield surface. stress: the stress for the present estimate `guess` of the plastic
/// strain increment; the trial state without this estimate is dev(stress) + 2 G guess. before: all
/// backstresses of the material before the increment. softening: factor on the yield stress.
Return radial_return(const Tensor& stress, const Tensor& guess, double g, const Material& material,
                     std::span<const Tensor> before = {}, double softening = 1.0);

/// Counterpart with another shear modulus G than that of the material.
Return radial_return(const Tensor& stress, const Tensor& guess, double g, double shear_modulus,
                     const Material& material, std::span<const Tensor> before, double softening);

/// Counterpart for two phases with equal plastic strain, without backstresses: the yield stress is
/// the sum of those of both materials, each multiplied by its factor.
struct PhaseYield {
  const Material& material;
  double factor;
};
Return radial_return(const Tensor& stress, const Tensor& guess, double g, double shear_modulus,
                     const std::array<PhaseYield, 2>& phases);

/// Backstress after a plastic strain increment with the given equivalent increment.
Tensor advanced(const Tensor& backstress, const Backstress& law, const Tensor& increment,
                double equivalent);

/// Axial stress for a history of total axial strain under uniaxial stress, from the virgin state
/// [Pa].
std::vector<double> uniaxial_stress(const Material& material, std::span<const double> strain);

}  // namespace samcontact::plasticity
