// SPDX-License-Identifier: GPL-3.0-or-later
// All sources of displacement and stress at one moment, which increments and fields of a state ask.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "samcontact/simulation/sources/given_heat.hpp"
#include "samcontact/simulation/sources/source.hpp"

namespace samcontact::simulation {

/// The undeformed surfaces, heat and initial stress, in this order of addition. Not to be asked by
/// several threads at once.
class Sources {
 public:
  /// heat: that does not go with the pressure.
  Sources(const Scene& scene, const Travel& travel, const std::array<GivenHeat, 2>& heat);

  /// Whether all stress of a body without tractions and plastic strain remains when it is unloaded.
  bool all_remain(int body) const;
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

 private:
  std::vector<std::unique_ptr<const Source>> all_;
};

}  // namespace samcontact::simulation
