// SPDX-License-Identifier: GPL-3.0-or-later
// Tolerances and methods of a simulation.
#pragma once

#include <array>
#include <functional>

#include "samcontact/base/box.hpp"
#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/operators/zones/band_split.hpp"

namespace samcontact::simulation {

/// Factor of a body's yield stress from the rise of temperature [K], both [k][i][j] of a box.
using Softening = std::function<Field(const Field& temperature, const Box& box)>;

/// Defaults and ranges are the caller's.
struct Settings {
  double tol{};  // relative change of the plastic strain increment, and yield excess
  /// Error of the division into increments, by step doubling; 0: increments as given.
  double increment_tol{};
  int max_iterations{};
  contact::OnBorder on_border{};
  operators::ResidualMethod residual_stress{};
  /// Fast residual stress: error due to periodic images, relative to the largest stress.
  double image_tol{};
  /// How far beyond the grid plastic strain acts along x [cells].
  int reach{};
  /// Plastic strain in one box always, never in small zones.
  bool one_zone = false;
  /// How the operators of small zones are split in bands.
  operators::BandSplit split = {};
  int max_halvings = 8;
  /// By body; empty: none. Asked once an increment, or part of one.
  std::array<Softening, 2> softening = {};
};

}  // namespace samcontact::simulation
