// SPDX-License-Identifier: GPL-3.0-or-later
// Cache of the operators of a contact problem: operators are built on first use, and the latest are
// kept.
#pragma once

#include <array>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "samcontact/base/box.hpp"
#include "samcontact/contact/contact_solver.hpp"
#include "samcontact/contact/partial_slip_contact.hpp"
#include "samcontact/contact/scaled_contact.hpp"
#include "samcontact/operators/heat/flux_heat.hpp"
#include "samcontact/operators/heat/temperature.hpp"
#include "samcontact/operators/surface/body_displacement.hpp"
#include "samcontact/operators/volume/volume_operators.hpp"
#include "samcontact/operators/zones/zone_operators.hpp"
#include "samcontact/simulation/setup/strength.hpp"

namespace samcontact::simulation {

class ZoneScan;

/// Media of the bodies 0 (upper) and 1 (lower); one object if they are equal.
using Media = std::array<operators::SharedMedium, 2>;

/// Factors on the compliance of the bodies in an increment; 1: elastic.
using Compliances = std::array<double, 2>;
inline constexpr Compliances elastic_compliances{1.0, 1.0};

/// Throws std::invalid_argument for a grid without layers or a rigid body.
void require_volume(const Grid& grid, const Media& media, int body);

/// Thread-safe.
class OperatorCache {
 public:
  /// image_tol: tolerance of volume operators and zones for periodic images. split: band
  /// decomposition of zones.
  OperatorCache(const Grid& grid, Media media, contact::FrictionLaw friction,
                contact::SharedContactLaw contact_law, double image_tol,
                const operators::BandSplit& split)
      : grid_(grid),
        media_(std::move(media)),
        friction_(std::move(friction)),
        contact_law_(std::move(contact_law)),
        image_tol_(image_tol),
        split_(split) {}

  /// Full-sliding contact with this heat; the last one is kept.
  std::shared_ptr<const contact::ContactSolver> solver(const operators::HeatingPair& heating) const;
  /// Likewise, of bodies whose compliances are multiplied by factors: the elastic solver if it
  /// serves, else one for these factors, which is kept until they change.
  contact::ScaledContact contact(const operators::HeatingPair& heating,
                                 const Compliances& compliances) const;

  /// Partial slip of bodies whose compliances are multiplied by factors; kept until they change.
  std::shared_ptr<const contact::PartialSlipContact> partial_slip(
      const Compliances& compliances) const;

  /// Displacement of a body due to tractions; kept, bodies of one medium share it.
  std::shared_ptr<const operators::BodyDisplacement> displacement(int body) const;
  /// Likewise, on a rectangle of nx x ny cells; the last one of each body is kept.
  std::shared_ptr<const operators::BodyDisplacement> displacement(int body, int nx, int ny) const;

  /// Operator over the surface cells of a box; the last two are kept.
  std::shared_ptr<const operators::Temperature> temperature(const operators::Heating& heating,
                                                            const Box& box) const;

  /// Tables of the heat of a body, null without heat; the last tables of each body are kept.
  std::shared_ptr<const operators::HeatStress> heat_stress(int body,
                                                           const operators::Heating& heating) const;

  /// Temperature, displacement and stress due to heat from slip; the operator of the last heating
  /// is kept.
  std::shared_ptr<const operators::FluxHeat> flux_heat(int body,
                                                       const operators::Heating& heating) const;

  using Operators = std::shared_ptr<const operators::VolumeOperators>;
  /// Volume operators of a body on (whole) boxes of this size; bodies of one medium with equal heat
  /// share them. The last few are kept. reach: ignored with heat and on periodic grids.
  Operators volume(int body, const Box& box, operators::Tensor tensor,
                   operators::ResidualMethod method, fft::Symmetry symmetry,
                   const operators::Heating& heating, operators::Reach reach = {}) const;
  /// Likewise, for all strain near the grid that acts on a body in motion; only the last ones of
  /// each body are kept, because this box grows while the body moves.
  Operators volume_of_motion(int body, const Box& box, operators::ResidualMethod method) const;

  /// Tables of the zones of a body; the last ones with and without heat are kept.
  std::shared_ptr<const operators::ZoneTables> zone_tables(int body, operators::Tensor tensor,
                                                           const operators::Heating& heating) const;

  /// Scan for yield of a body with this strength under given tractions; the last one of each body
  /// is kept.
  std::shared_ptr<const ZoneScan> zone_scan(int body, const Strength& strength,
                                            const operators::Heating& heating) const;

  /// Memory of the operators that are kept [byte].
  std::size_t bytes() const;

 private:
  struct Kept {
    operators::SharedMedium medium;
    Box size;
    operators::Tensor tensor;
    operators::ResidualMethod method;
    fft::Symmetry symmetry;
    operators::Heating heating;
    operators::Reach reach;
    Operators operators;
  };
  struct KeptZones {
    int body;  // of the volume operators
    operators::SharedMedium medium;
    operators::Heating heating;  // if it is on, else none
    std::shared_ptr<const operators::ZoneTables> tables;
  };

  /// Factor on the compliance of both bodies together, if they act as elastic bodies do.
  std::optional<double> common_factor(const operators::HeatingPair& heating,
                                      const Compliances& compliances) const;

  Grid grid_;
  Media media_;
  contact::FrictionLaw friction_;
  contact::SharedContactLaw contact_law_;
  double image_tol_;
  operators::BandSplit split_;
  mutable std::mutex mutex_;
  mutable std::list<Kept> kept_;  // most recently used first
  mutable std::array<std::weak_ptr<const operators::VolumeOperators>, 2> of_motion_;  // in kept_
  mutable std::vector<KeptZones> zone_tables_;
  mutable std::array<std::shared_ptr<const ZoneScan>, 2> zone_scans_;
  mutable std::mutex heat_mutex_;
  mutable std::array<std::shared_ptr<const operators::HeatStress>, 2> heat_stress_;
  mutable std::array<std::shared_ptr<const operators::FluxHeat>, 2> flux_heat_;
  mutable std::list<std::shared_ptr<const operators::Temperature>>
      temperatures_;  // most recently used first
  mutable operators::HeatingPair solver_heating_;
  mutable std::shared_ptr<const contact::ContactSolver> solver_;
  mutable operators::HeatingPair scaled_heating_;
  mutable Compliances scaled_by_ = elastic_compliances;
  mutable std::shared_ptr<const contact::ContactSolver> scaled_solver_;
  mutable Compliances slipping_by_ = elastic_compliances;
  mutable std::shared_ptr<const contact::PartialSlipContact> slipping_;
  using Displacements = std::array<std::shared_ptr<const operators::BodyDisplacement>, 2>;
  mutable Displacements displacements_, small_displacements_;
};

}  // namespace samcontact::simulation
