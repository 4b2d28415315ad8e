// SPDX-License-Identifier: GPL-3.0-or-later
// Cell that an interface divides into two phases, each with its own plastic flow: a laminate, in
// which the traction on the interface and the strain along it are the same in both phases.
#pragma once

#include <array>

#include "samcontact/plasticity/return_mapping.hpp"

namespace samcontact::plasticity {

/// One phase of the cell: moduli [Pa], yield law, and history before an increment.
struct Phase {
  double bulk, shear;
  const Hardening* hardening;  // null: does not yield
  double strength;             // factor on the yield stress
  Tensor inelastic;            // plastic strain plus misfit strain
  double equivalent;
};

struct TwoPhaseStep {
  Tensor stress{}, strain{};           // means over the cell
  std::array<Tensor, 2> plastic{};     // increments of the plastic strain of both phases
  std::array<double, 2> equivalent{};  // likewise
  double overshoot = 0.0;              // see Return
};

/// Means that satisfy (1 - p) stress + p C strain = kept, with the stiffness C of the first phase
/// and p of its bulk and shear part. share: of the second phase; normal: unit vector of the
/// interface; start: an estimate of the strain.
TwoPhaseStep two_phase_step(const std::array<Phase, 2>& phases, double share,
                            const std::array<double, 3>& normal, const std::array<double, 2>& p,
                            const Tensor& kept, const Tensor& start);

}  // namespace samcontact::plasticity
