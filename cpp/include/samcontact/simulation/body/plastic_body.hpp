// SPDX-License-Identifier: GPL-3.0-or-later
// An inelastic body in an increment: the zones that hold its plastic strain and every cell that may
// flow, what the strain does there, and the return to the yield surface.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "samcontact/plasticity/return_mapping.hpp"
#include "samcontact/simulation/body/active_cells.hpp"
#include "samcontact/simulation/cells/box_choice.hpp"
#include "samcontact/simulation/scene/strength.hpp"
#include "samcontact/simulation/scene/yield_scan.hpp"
#include "samcontact/simulation/sources/sources.hpp"
#include "samcontact/simulation/state/state.hpp"
#include "samcontact/simulation/strain/outside_strain.hpp"
#include "samcontact/simulation/strain/zone_volume.hpp"

namespace samcontact::simulation {

class PlasticBody {
 public:
  /// from: with the bodies where the increment takes them. number: its own among the inelastic
  /// bodies. copies: 2 where the other body is its mirror image in the contact plane.
  /// heating: that goes with the pressure.
  PlasticBody(const State& from, int index, std::uint8_t number, int copies, fft::Symmetry symmetry,
              const operators::Heating& heating);

  int index() const { return index_; }  // of the body: 0 or 1
  int copies() const { return copies_; }
  operators::Tensor tensor() const { return tensor_; }
  bool has_history() const { return history_ != nullptr; }
  /// Stored: from the mirror planes on.
  const Zones& zones() const { return zones_; }
  /// Where its residual displacement is known, one layer.
  Box surface() const { return volume_ ? choice_.whole(volume_->surface()) : Box{}; }
  bool strained() const { return strained_; }
  /// What acts on it, in its own cells.
  const operators::Tractions& tractions() const { return offset_ != 0 ? seen_ : *tractions_; }
  double sign() const { return operators::shear_sign(index_); }
  /// The box of all cells where tractions and sources alone come near yielding; before there is a
  /// strain.
  Box near_yield(const YieldScan& scan, const Sources& sources) const;
  /// The columns of those that yield.
  const Columns& yielding_columns(const YieldScan& scan, const Sources& sources);
  /// The box of all cells below those of the grid where these alone make it yield; of a body that
  /// is weak somewhere below, of all cells where they come near.
  Box yield_below(const YieldScan& scan, const Sources& sources) const;
  /// Whether it yields down to any depth.
  bool yields_everywhere(const YieldScan& scan) const;

  /// Other zones, which hold all unknowns: what is in both stays. split: whether their operators
  /// are to be those of zones, or that of the box around them, which must hold all tractions then.
  /// Throws MemoryError.
  void set_zones(const Zones& zones, bool split, const Sources& sources, ActiveCells& active);
  bool is_split() const { return split_; }
  /// Boxes that hold all of the history.
  std::vector<Box> history_boxes() const;
  bool has_strain_beyond(const Zones& zones) const {
    return history_ && history_->reaches_beyond(zones);
  }

  /// Of a cell, with its unknowns; transformed next.
  void set_strain(std::uint32_t cell, const plasticity::Tensor& strain);
  /// Transforms the strain. active: whether the increment has unknowns.
  void transform(bool active);
  /// Adds what its plastic strain opens to the gap.
  void open(Field& gap);
  /// Adds what its plastic strain of this increment lets body 1 slip over body 2 [2][i][j].
  void slide(Field& free_slip) const;
  /// Its cells, of which the grid shows at least parts.
  Box seen_surface() const;
  /// Whether its residual displacement could close the gap where it is not known, and where all
  /// bodies displace by no more than `reach` [m].
  bool may_touch_outside(const Field& gap, double reach) const;
  /// Largest residual displacement at the rim of its window [m], of all copies.
  double rim_displacement() const { return copies_ * rim_displacement_; }

  void meet(const operators::Tractions& tractions);
  /// Factor of the yield stress in a box that holds its own; null: 1.
  void soften(std::shared_ptr<const BoxField> factor);
  const std::shared_ptr<const BoxField>& softening() const { return softening_; }

  /// Stress of its active cells; cells that yield and were not active are appended. Returns the
  /// smallest (yield stress - von Mises)/yield stress of cells that are not active.
  double find_stress(ActiveCells& active);
  void activate(std::uint32_t cell, const plasticity::Tensor& deviator, ActiveCells& active);
  /// Radial return of a cell, whose flow was guessed.
  plasticity::Return return_map(std::uint32_t cell, const plasticity::Tensor& deviator,
                                const plasticity::Tensor& guess) const;

  double strain_at_yield() const { return body().strain_at_yield(); }
  /// That, or the largest accumulated strain before the increment.
  double strain_scale() const;
  /// A cell's history after a flow by `increment`.
  void flow(std::uint32_t cell, const plasticity::Tensor& increment, double equivalent);
  /// The history after the increment; ends the use of this object.
  std::shared_ptr<const PlasticState> finish();

 private:
  /// What a look at a layer finds: cells that yield and were not active, and the largest square of
  /// a von Mises stress over its limit of those that are not.
  struct Seen {
    std::vector<std::pair<std::uint32_t, plasticity::Tensor>> yielding;
    double largest = 0.0;
  };
  /// Squares of von Mises stresses, over 3.
  struct Limits {
    std::vector<double> first;  // by material, before hardening and its profile
    double weakest;             // of all cells
  };
  Limits first_limits() const;
  /// Memory of an increment in zones.
  double bytes_of(const Zones& zones, bool split) const;
  /// The columns where some tractions go beyond a limit.
  struct Yielding {
    operators::Tractions tractions;
    double softening;
    Columns columns;
  };

  const plasticity::Body& body() const { return scene_.bodies[index_]; }
  int material_number(std::size_t cell) const { return material_.empty() ? 0 : material_[cell]; }
  const plasticity::Material& material(std::size_t cell) const {
    return body().material(material_number(cell));
  }
  Columns columns_beyond(const YieldLimit& limit, const YieldScan& scan) const;
  /// Axes along which its residual displacement matters.
  std::span<const operators::Axis> axes() const;
  /// What the strain before the increment does along the surface.
  void find_slid_before(const Field& strain);
  /// Adds a multiple of a displacement along an axis, known on a stored box, to a surface field.
  void add_displacement(const Box& box, const Field& displacement, operators::Axis axis,
                        double factor, double* to) const;
  double largest_at_rim(const Box& box, const Field& displacement, bool ends_x) const;
  /// first: the number of its first cell; plane: how many it has.
  Seen look_at_layer(std::size_t first, std::size_t plane, const double* layer,
                     const Limits& limits, ActiveCells& active) const;
  /// Adds what else stresses a layer.
  Field with_given_stress(std::size_t zone, int k, const double* layer) const;
  double yield_limit(std::uint32_t cell) const;
  /// Factor of the yield stress.
  double strength_of(std::uint32_t cell) const;
  /// Of its material, before the increment, into the first places.
  std::span<const plasticity::Tensor> backstresses(std::uint32_t cell,
                                                   plasticity::Tensors& place) const;

  const Scene& scene_;
  int index_;
  std::uint8_t number_;
  int copies_;
  operators::ResidualMethod method_;
  fft::Symmetry symmetry_;
  operators::Heating heating_;
  BoxChoice choice_;
  Strength strength_;
  std::shared_ptr<const PlasticState> history_;  // before the increment; null: none
  /// The same as the surfaces met with it, before it was extrapolated.
  std::shared_ptr<const PlasticState> met_;
  operators::Tensor tensor_ = operators::Tensor::deviator;
  Zones zones_;
  std::unique_ptr<ZoneVolume> volume_;  // null: no zones
  bool split_ = false;
  Field strain_;                         // before the increment plus the last guess
  Field equivalent_;                     // before the increment
  Field backstress_;                     // before the increment, [term][component][cell]
  Field factor_;                         // of the yield stress, by depth; empty: 1
  std::vector<std::uint16_t> material_;  // number of each cell's; empty: there is one
  std::vector<int> active_;              // per cell: its place among the active ones, or -1
  bool strained_ = false;
  double rim_displacement_ = 0.0;
  std::array<Field, 2> slid_before_;  // along x and y, where it is known; empty: not at all
  OutsideStrain outside_;             // what the history outside of the zones does
  std::vector<Field> given_stress_;   // by zone, of all but tractions and the strain in the zones
  double offset_ = 0.0;               // of its cells from the grid's, see Placement
  const operators::Tractions* tractions_ = nullptr;
  operators::Tractions seen_;  // from cells at an offset
  std::shared_ptr<const BoxField> softening_;
  double weakest_ = 1.0;              // its smallest value
  std::optional<Yielding> yielding_;  // as last looked for
};

}  // namespace samcontact::simulation
