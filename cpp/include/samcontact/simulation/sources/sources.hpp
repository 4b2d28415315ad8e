// SPDX-License-Identifier: GPL-3.0-or-later
// All sources of displacement and stress in a state or increment.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "samcontact/simulation/sources/eigenstrain.hpp"
#include "samcontact/simulation/sources/given_heat.hpp"
#include "samcontact/simulation/sources/source.hpp"
#include "samcontact/simulation/sources/traction_memory.hpp"

namespace samcontact::simulation {

/// Undeformed surfaces, heat, initial stress, eigenstrain and memory of viscoelastic bodies, added
/// in this order. Not thread-safe.
class Sources {
 public:
  /// heat: not proportional to the pressure. method: for the stress of eigenstrains. memory: of
  /// viscoelastic bodies, as tractions that cause an elastic displacement; empty: none.
  Sources(const Setup& setup, const Travel& travel, const std::array<GivenHeat, 2>& heat,
          const Eigenstrains& eigenstrains, operators::ResidualMethod method,
          std::array<TrackTractions, 2> memory = {});

  /// Whether all stress of a body that is not due to tractions and plastic strain remains after
  /// unloading.
  bool all_remain(int body) const;
  /// Mirror planes that all sources permit.
  fft::Symmetry symmetry() const;
  /// Whether the search for yield takes all stress of a body into account.
  bool all_smooth(int body) const;
  /// Adds the separation of the undeformed surfaces [i][j] of the grid [m].
  void separate(Field& gap) const;
  /// Adds the surface displacement u_z of a body [i][j] of the grid [m].
  void displace(int body, Field& sum) const;
  /// Adds the stress in a box of cells of a body, [component][k][i][j] of the tensor [Pa]; an empty
  /// field stands for 0.
  void stress(int body, const Box& box, operators::Tensor tensor, Field& sum) const;
  /// Adds the part of the stress that remains after unloading.
  void residual_stress(int body, const Box& box, operators::Tensor tensor, Field& sum) const;
  /// Deviator of the stress at depths below the grid, to be added in a search for yield; empty:
  /// zero.
  operators::DeviatorAt deviator(int body) const;
  /// Box of all cells in which stress unknown to the search exceeds a fraction of the softened
  /// yield stress; empty: none.
  Box box_beyond(int body, const Strength& strength, double softening, double share) const;

 private:
  std::vector<std::unique_ptr<const Source>> all_;
};

}  // namespace samcontact::simulation
