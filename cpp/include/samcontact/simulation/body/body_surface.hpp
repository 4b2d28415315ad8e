// SPDX-License-Identifier: GPL-3.0-or-later
// What the plastic strain of a body does to the surfaces in contact.
#pragma once

#include <array>
#include <span>

#include "samcontact/simulation/cells/box_choice.hpp"
#include "samcontact/simulation/strain/outside_strain.hpp"
#include "samcontact/simulation/strain/zone_volume.hpp"

namespace samcontact::simulation {

class BodySurface {
 public:
  /// copies: 2 where the other body is its mirror image in the contact plane. offset: of the body's
  /// cells, see Placement.
  BodySurface(const Scene& scene, int body, int copies, fft::Symmetry symmetry, double offset)
      : scene_(scene),
        body_(body),
        copies_(copies),
        offset_(offset),
        choice_(scene.grid, symmetry) {}

  /// Axes along which the residual displacement matters.
  std::span<const operators::Axis> axes() const;
  /// Other zones. volume: of them, outlives this; null: none. split: see PlasticBody. before: the
  /// strain in them with which the surfaces met, where axes along the surface matter.
  void begin(ZoneVolume* volume, bool split, const Field& before);
  /// What the history outside of the zones displaces; its stress is not used.
  void take(OutsideStrain outside) { outside_ = std::move(outside); }
  /// Whether there is a strain in the zones, which the volume has transformed.
  void set_strained(bool strained) { strained_ = strained; }

  /// Where the residual displacement is known, one layer.
  Box known() const { return volume_ != nullptr ? choice_.whole(volume_->surface()) : Box{}; }
  /// The body's cells, of which the grid shows at least parts.
  Box seen() const;
  /// Adds what the plastic strain opens to the gap.
  void open(Field& gap);
  /// Adds what the plastic strain of this increment lets body 1 slip over body 2 [2][i][j].
  void slide(Field& free_slip) const;
  /// Whether the residual displacement could close the gap where it is not known, and where all
  /// bodies displace by no more than `reach` [m].
  bool may_touch_outside(const Field& gap, double reach) const;
  /// Largest residual displacement at the rim of its window [m], of all copies.
  double rim_displacement() const { return copies_ * rim_displacement_; }

 private:
  /// Adds a multiple of a displacement along an axis, known on a stored box, to a surface field.
  void add_displacement(const Box& box, const Field& displacement, operators::Axis axis,
                        double factor, double* to) const;
  double largest_at_rim(const Box& box, const Field& displacement, bool ends_x) const;

  const Scene& scene_;
  int body_, copies_;
  double offset_;
  BoxChoice choice_;
  ZoneVolume* volume_ = nullptr;
  bool split_ = false, strained_ = false;
  OutsideStrain outside_;
  double rim_displacement_ = 0.0;
  std::array<Field, 2> slid_before_;  // along x and y, where it is known; empty: not at all
};

}  // namespace samcontact::simulation
