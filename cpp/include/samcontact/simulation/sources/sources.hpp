// SPDX-License-Identifier: GPL-3.0-or-later
// All sources of displacement and stress at one moment, which increments and fields of a state ask.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "samcontact/simulation/sources/eigenstrain.hpp"
#include "samcontact/simulation/sources/given_heat.hpp"
#include "samcontact/simulation/sources/source.hpp"

namespace samcontact::simulation {

/// The undeformed surfaces, heat, initial stress and eigenstrain, in this order of addition. Not to
/// be asked by several threads at once.
class Sources {
 public:
  /// heat: that does not go with the pressure. method: of the stress of eigenstrains.
  Sources(const Scene& scene, const Travel& travel, const std::array<GivenHeat, 2>& heat,
          const Eigenstrains& eigenstrains, operators::ResidualMethod method);

  /// Whether all stress of a body without tractions and plastic strain remains when it is unloaded.
  bool all_remain(int body) const;
  /// Mirror planes that all leave.
  fft::Symmetry symmetry() const;
  /// Whether the search of cells that yield knows all stress of a body.
  bool all_smooth(int body) const;
  /// Adds the separation of the undeformed surfaces [i][j] of the grid.
  void separate(Field& gap) const;
  /// Adds the displacement u_z of a body's surface [i][j] of the grid.
  void displace(int body, Field& sum) const;
  /// Adds the stress in a box of a body's cells, [component][k][i][j] of the tensor; an empty field
  /// is 0.
  void stress(int body, const Box& box, operators::Tensor tensor, Field& sum) const;
  /// The part of it that remains when the bodies are unloaded.
  void residual_stress(int body, const Box& box, operators::Tensor tensor, Field& sum) const;
  /// Deviator of the stress at depths below the grid that a search of cells that yield is to add;
  /// none: zero.
  operators::DeviatorAt deviator(int body) const;
  /// The box of all cells where a stress that search does not know exceeds a share of the softened
  /// yield stress; empty: none.
  Box box_beyond(int body, const Strength& strength, double softening, double share) const;

 private:
  std::vector<std::unique_ptr<const Source>> all_;
};

}  // namespace samcontact::simulation
