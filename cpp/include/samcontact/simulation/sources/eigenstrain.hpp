// SPDX-License-Identifier: GPL-3.0-or-later
// Prescribed eigenstrain of the bodies (misfit, swelling, transformation) as a source.
#pragma once

#include <array>
#include <memory>
#include <utility>

#include "samcontact/simulation/sources/source.hpp"
#include "samcontact/simulation/strain/acting_strain.hpp"

namespace samcontact::simulation {

/// Eigenstrains by body, without equivalent strain and backstress; null: none.
using Eigenstrains = std::array<std::shared_ptr<const PlasticState>, 2>;

/// Sum of an eigenstrain and of a second eigenstrain in a box of grid cells with first layer k0,
/// [component][k][i][j] of all six components. Null if it is zero everywhere.
std::shared_ptr<const PlasticState> sum_of(const std::shared_ptr<const PlasticState>& before,
                                           const Box& box, int k0, const Field& strain,
                                           const Grid& grid);

/// Throws std::invalid_argument if the travel of the bodies is not a whole number of their cells
/// and no body has cells that follow it.
void require_followed(const Eigenstrains& strains, const Setup& setup, const Travel& travel);

class Eigenstrain : public Source {
 public:
  Eigenstrain(const Setup& setup, const Travel& travel, operators::ResidualMethod method,
              Eigenstrains strains)
      : setup_(setup),
        method_(method),
        strains_(std::move(strains)),
        offsets_(setup.placement(travel).offset) {}

  bool acts_on(int body) const override { return strains_[body] != nullptr; }
  bool remains() const override { return true; }
  bool is_smooth() const override { return false; }
  fft::Symmetry symmetry() const override {
    return strains_[0] || strains_[1] ? fft::Symmetry::none : fft::Symmetry::xy;
  }
  void displace(int body, Field& sum) const override;
  void stress(int body, const Box& box, operators::Tensor tensor, Field& sum) const override;
  Box box_beyond(int body, const Strength& strength, double softening, double share) const override;

 private:
  const Setup& setup_;
  operators::ResidualMethod method_;
  Eigenstrains strains_;
  std::array<double, 2> offsets_;
  mutable std::array<Field, 2> displacement_;  // empty until first used
};

}  // namespace samcontact::simulation
