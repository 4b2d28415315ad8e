// SPDX-License-Identifier: GPL-3.0-or-later
// Heat that is not proportional to the pressure, as a source of displacement and stress.
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "samcontact/simulation/sources/given_heat.hpp"
#include "samcontact/simulation/sources/source.hpp"

namespace samcontact::simulation {

class HeatSource : public Source {
 public:
  /// offsets: offsets of the cells of the bodies, see Placement.
  HeatSource(const Grid& grid, const std::array<GivenHeat, 2>& heat,
             const std::array<double, 2>& offsets)
      : grid_(grid), heat_(heat), offsets_(offsets) {}

  bool acts_on(int body) const override { return heat_[body].is_on(); }
  bool remains() const override { return false; }
  void displace(int body, Field& sum) const override;
  void stress(int body, const Box& box, operators::Tensor tensor, Field& sum) const override;
  operators::DeviatorAt deviator(int body) const override;

 private:
  using ByDepth = std::map<double, Field>;
  /// Adds the stress at missing depths.
  void find_stress(int body, std::span<const double> depths, ByDepth& known) const;

  const Grid& grid_;
  std::array<GivenHeat, 2> heat_;
  std::array<double, 2> offsets_;
  mutable std::array<Field, 2> displacement_;  // empty until first used
  /// Depths used so far: all six components below the grid, [component][i][j] [Pa].
  mutable std::array<ByDepth, 2> stress_;
};

}  // namespace samcontact::simulation
