// SPDX-License-Identifier: GPL-3.0-or-later
// Strain fields in tiles of the lattice of a body, shared between states.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/box.hpp"
#include "samcontact/operators/convolution/volume_spectrum.hpp"
#include "samcontact/simulation/cells/zones.hpp"

namespace samcontact::simulation {

/// Boxes are of the cells of the body. Each tile keeps the box of its cells in which a field is not
/// zero. Parts of fields: components of the strain, then equivalent strain, then components of the
/// backstresses.
class StrainTiles {
 public:
  struct Part {
    Box box;
    Field values;  // [part][k][i][j]
    double max_equivalent = 0.0, max_strain = 0.0;
  };
  using Tiles = std::map<Tile, std::shared_ptr<const Part>>;

  explicit StrainTiles(operators::Tensor tensor) : tensor_(tensor) {}

  /// Replaces the fields, by part, of which all over a box are given, in another box inside it.
  void put(const Box& box, const std::vector<const double*>& fields, const Box& inside);
  /// Copies parts from `first` on, `stride` numbers apart, in cells common to a box and the tiles;
  /// the rest of `to` is unchanged.
  void copy(std::size_t first, std::size_t count, const Box& box, double* to,
            std::size_t stride) const;

  const Tiles& tiles() const { return tiles_; }
  std::size_t strain_parts() const { return operators::count(tensor_); }
  /// First layer with a field that is not zero; very large without any.
  int first_layer() const;
  /// Number of cells with equivalent plastic strain.
  std::size_t yielded_cells() const;
  double max_equivalent() const;
  /// Maximum sqrt(2/3 e:e) of the strain e [-].
  double max_strain() const;
  std::size_t bytes() const;

 private:
  std::shared_ptr<const Part> finished(const Box& box, Field values) const;

  operators::Tensor tensor_;
  Tiles tiles_;
};

}  // namespace samcontact::simulation
