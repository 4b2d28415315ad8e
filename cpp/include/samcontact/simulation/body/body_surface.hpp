// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of the plastic strain of a body on the surfaces in contact.
#pragma once

#include <array>
#include <span>

#include "samcontact/simulation/cells/box_choice.hpp"
#include "samcontact/simulation/strain/outside_strain.hpp"
#include "samcontact/simulation/strain/zone_volume.hpp"

namespace samcontact::simulation {

class BodySurface {
 public:
  /// copies: 2 if the other body is the mirror image in the contact plane, otherwise 1. offset:
  /// offset of the cells of the body, see Placement.
  BodySurface(const Setup& setup, int body, int copies, fft::Symmetry symmetry, double offset)
      : setup_(setup),
        body_(body),
        copies_(copies),
        offset_(offset),
        choice_(setup.grid, symmetry) {}

  /// Axes along which the residual displacement is needed.
  std::span<const operators::Axis> axes() const;
  /// Sets new zones. volume: of the zones, outlives this object; null: none. split: see
  /// PlasticBody. before: strain in them for which the tractions were found, if tangential axes are
  /// needed.
  void begin(ZoneVolume* volume, bool split, const Field& before);
  /// Sets the displacement due to the history outside the zones; the stress of `outside` is not
  /// used.
  void take(OutsideStrain outside) { outside_ = std::move(outside); }
  /// Sets whether there is strain in the zones, which the volume has transformed.
  void set_strained(bool strained) { strained_ = strained; }

  /// Surface cells with known residual displacement, one layer.
  Box known() const { return volume_ != nullptr ? choice_.whole(volume_->surface()) : Box{}; }
  /// Cells of the body that lie in the grid, at least partly.
  Box seen() const;
  /// Adds the normal displacement due to plastic strain to the gap.
  void add_displacement_to(Field& gap);
  /// Adds the slip of body 1 relative to body 2 due to the plastic strain of this increment
  /// [2][i][j].
  void add_tangential_displacement_to(Field& free_slip) const;
  /// Box around the cells of the grid in which residual displacement that is not known could close
  /// the gap, if no displacement exceeds `reach` [m]; empty if there are none.
  Box possible_contact_outside(const Field& gap, double reach) const;
  /// Cells of the body that lie in a part of the grid, at least partly; without layers.
  Box below(const Box& part) const;
  /// Largest residual displacement in the outermost known cells [m], sum over all copies.
  double rim_displacement() const { return copies_ * rim_displacement_; }

 private:
  /// Adds a multiple of a displacement along an axis, known on a stored box, to a surface field.
  void add_displacement(const Box& box, const Field& displacement, operators::Axis axis,
                        double factor, double* to) const;
  double largest_at_rim(const Box& box, const Field& displacement, bool ends_x) const;

  const Setup& setup_;
  int body_, copies_;
  double offset_;
  BoxChoice choice_;
  ZoneVolume* volume_ = nullptr;
  bool split_ = false, strained_ = false;
  OutsideStrain outside_;
  double rim_displacement_ = 0.0;
  std::array<Field, 2> displaced_before_;  // along x and y, in the known cells; empty: none
};

}  // namespace samcontact::simulation
