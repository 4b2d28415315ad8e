// SPDX-License-Identifier: GPL-3.0-or-later
// What heat does to an increment besides the heat that goes with its pressure: heat of earlier
// steps moves the surfaces and stresses the bodies, and the temperature lowers the yield stress.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "samcontact/simulation/given_heat.hpp"
#include "samcontact/simulation/simulation.hpp"
#include "samcontact/simulation/source.hpp"
#include "samcontact/simulation/yield_scan.hpp"

namespace samcontact::simulation {

class HeatOfIncrement : public Source {
 public:
  /// offsets: of the bodies' cells, see Placement.
  HeatOfIncrement(const Scene& scene, const Target& target, const std::array<double, 2>& offsets);

  /// Past heat, or heat of slip.
  bool has_past(int body) const { return given_[body].is_on(); }
  /// Of that.
  void open(Field& gap) const override;
  void stress(int body, const Box& box, operators::Tensor tensor, Field& sum) override;
  /// The same at depths below the grid's window; none without.
  operators::DeviatorAt deviator(int body) const;
  /// Factor of the yield stress in a box under a pressure; null: 1 everywhere. Throws
  /// std::invalid_argument for a law that gives what is none.
  std::shared_ptr<const BoxField> softening(int body, const Softening& law, const Field& pressure,
                                            const Box& box) const;

 private:
  using ByDepth = std::map<double, Field>;
  /// Adds past stress at the depths that are missing.
  void find_stress(int body, std::span<const double> depths, ByDepth& known) const;

  const Scene& scene_;
  const Target& target_;
  std::array<double, 2> offsets_;
  std::array<GivenHeat, 2> given_;
  std::vector<Field> displacement_;
  /// Of bodies, as far as it was asked for: all six components of past stress below the grid's
  /// window, [component][i][j].
  mutable std::array<ByDepth, 2> stress_;
};

}  // namespace samcontact::simulation
