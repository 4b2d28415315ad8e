// SPDX-License-Identifier: GPL-3.0-or-later
// Plastic history of one body.
#pragma once

#include <memory>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/operators/volume_spectrum.hpp"
#include "samcontact/simulation/mirror.hpp"

namespace samcontact::simulation {

/// Fields of a box, [..][k][i][j]: strain by component, equivalent plastic strain, and backstress
/// by term and five components of the deviator (empty: no kinematic hardening).
struct PlasticFields {
  Box box;
  Field strain, equivalent, backstress;
};

/// Never changed once made. Cut into columns along the depth and y, one for each i, which the
/// states of a rolling contact share; the box may reach beyond the grid along x. With mirror planes
/// it is the part from them on.
class PlasticState {
 public:
  /// `fields` in their box, and otherwise as `before`, of the same symmetry and tensor; null:
  /// nothing.
  PlasticState(const PlasticState* before, fft::Symmetry symmetry, operators::Tensor tensor,
               const PlasticFields& fields);

  const Box& box() const { return box_; }
  fft::Symmetry symmetry() const { return symmetry_; }
  operators::Tensor tensor() const { return tensor_; }

  /// Over any box; zero where there is no history.
  Field strain(const Box& box) const;
  Field equivalent(const Box& box) const;
  Field backstress(const Box& box) const;
  PlasticFields fields(const Box& box) const;

  double max_equivalent() const;
  /// Largest sqrt(2/3 e:e) of the strain e.
  double max_strain() const;
  std::size_t bytes() const;

  /// The same, `cells` further along x.
  std::shared_ptr<const PlasticState> moved(int cells) const;
  /// The same with fewer mirror planes.
  PlasticState unfolded(const Grid& grid, fft::Symmetry symmetry) const;

  bool operator==(const PlasticState& other) const;

 private:
  struct Column {
    Field values;  // [strain, equivalent, backstress][k][j]
    double max_equivalent = 0.0, max_strain = 0.0;
  };

  int strain_parts() const { return operators::count(tensor_); }
  std::size_t parts() const { return strain_parts() + 1 + backstress_parts_; }
  Field gather(int first, int count, const Box& box) const;
  std::shared_ptr<const Column> finished(Field values) const;

  Box box_;
  fft::Symmetry symmetry_;
  operators::Tensor tensor_;
  int backstress_parts_;
  std::vector<std::shared_ptr<const Column>> columns_;  // null: all zero
};

/// Whether two histories, or their absence, are the same.
bool same(const std::shared_ptr<const PlasticState>& a,
          const std::shared_ptr<const PlasticState>& b);

/// A history with fewer mirror planes, or itself.
std::shared_ptr<const PlasticState> unfolded(const std::shared_ptr<const PlasticState>& history,
                                             const Grid& grid, fft::Symmetry symmetry);

}  // namespace samcontact::simulation
