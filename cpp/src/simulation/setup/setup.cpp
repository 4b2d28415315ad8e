// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/setup/setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "samcontact/base/cells_over.hpp"
#include "samcontact/operators/medium/finite_body.hpp"

namespace samcontact::simulation {
namespace {

/// Depth of fields in contact radii if the number of layers is not limited, and minimum number of
/// layers.
constexpr double depth_in_radii = 1.5;
constexpr int fewest_layers = 8;

/// Radius of the spots in contact: that of a circle with their mean chord, along the direction in
/// which they are shorter [m].
double spot_radius(const Field& repulsion, const Grid& grid) {
  std::size_t cells = 0, chords_x = 0, chords_y = 0;
  const auto touches = [&](int i, int j) {
    return i >= 0 && j >= 0 &&
           contact::in_contact(repulsion[static_cast<std::size_t>(i) * grid.ny + j]);
  };
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      if (!touches(i, j)) continue;
      ++cells;
      if (!touches(i - 1, j)) ++chords_x;
      if (!touches(i, j - 1)) ++chords_y;
    }
  }
  if (cells == 0) return 0.0;
  const auto area = static_cast<double>(cells);
  const double across_x = area * grid.dx / static_cast<double>(chords_x);
  const double across_y = area * grid.dy / static_cast<double>(chords_y);
  return 2 / std::numbers::pi * std::min(across_x, across_y);
}

Media media_of(const plasticity::Body& body1, const plasticity::Body& body2) {
  const auto upper = operators::medium_of(body1);
  const auto lower = operators::medium_of(body2);
  return {upper, *upper == *lower ? upper : lower};
}

/// Mirror planes that the free faces of the bodies permit.
fft::Symmetry symmetry_of_faces(const std::array<plasticity::Body, 2>& bodies) {
  const bool mirrored = std::all_of(bodies.begin(), bodies.end(), [](const auto& body) {
    const FreeFaces& faces = body.material(0).free_faces;
    return faces.low == -faces.high;
  });
  return mirrored ? fft::Symmetry::xy : fft::Symmetry::none;
}

}  // namespace

Setup::Setup(const Grid& grid_, const plasticity::Body& body1, const plasticity::Body& body2,
             Field initial_gap_, contact::FrictionLaw friction_, double image_tol,
             const TransientHeating& transient_heating_, int reach_, Reliefs reliefs_,
             const operators::BandSplit& split_, contact::SharedContactLaw contact_law_,
             InclusionsPair inclusions_)
    : grid(grid_),
      bodies{body1, body2},
      media(media_of(body1, body2)),
      initial_gap(std::move(initial_gap_)),
      contact_law(std::move(contact_law_)),
      friction(std::move(friction_)),
      partial_slip(friction.sticks() ? std::make_shared<const contact::PartialSlipContact>(
                                           grid_, media[0], media[1], friction, contact_law)
                                     : nullptr),
      transient_heating(transient_heating_),
      reach(reach_),
      split((require_valid(split_), split_)),
      reliefs(std::move(reliefs_)),
      inclusions(std::move(inclusions_)),
      cache(grid, media, friction, contact_law, image_tol, split),
      symmetry_(symmetry_of(initial_gap, grid_)) {
  // Throws for bodies without a contact solution.
  if (!friction.sticks()) cache.solver({});
  symmetry_ = common(symmetry_, friction.symmetry());
  symmetry_ = common(symmetry_, symmetry_of_faces(bodies));
  for (const auto& own : inclusions) {
    if (own) symmetry_of_inclusions_ = common(symmetry_of_inclusions_, own->symmetry(grid));
  }
}

int Setup::followed() const {
  // Without plastic strain or relief all positions on a body are equivalent.
  const auto has_history = [this](int body) {
    return is_strained(body) || !reliefs[body].heights.empty() || friction_moves_with(body);
  };
  return has_history(1) ? 1 : has_history(0) ? 0 : -1;
}

bool Setup::friction_moves_with(int body) const {
  const contact::MappedCoulomb* map = friction.map();
  return map != nullptr && map->x.size() > 1 && map->body == body + 1;
}

Placement Setup::placement(const Travel& travel) const {
  const int body = followed();
  if (body >= 0 || !friction.sticks()) return {travel, body};
  // Under partial slip the shear is transported with the surface, by the mean travel of both
  // bodies.
  const double mean = 0.5 * (travel.x[0] + travel.x[1]);
  return {Travel{{mean, mean}, travel.y}, 1};
}

Field Setup::relief(int body, const Travel& travel) const {
  const Relief& relief = reliefs[body];
  Field heights(grid.surface_size(), 0.0);
  if (relief.heights.empty()) return heights;
  const Placement place = placement(travel);
  const double offset = place.offset[body], part = std::fabs(offset);
  const int side = offset > 0 ? 1 : -1;
  for (int i = 0; i < grid.nx; ++i) {
    const int row = i + place.first[body];
    for (int j = 0; j < grid.ny; ++j) {
      double height = relief.at(row, j, grid.ny);
      if (part > 0) height += part * (relief.at(row + side, j, grid.ny) - height);
      heights[static_cast<std::size_t>(i) * grid.ny + j] = height;
    }
  }
  return heights;
}

Field Setup::gap(const Travel& travel) const {
  Field gap = shifted_gap(initial_gap, grid, placement(travel).origin);
  for (int b = 0; b < 2; ++b) {
    if (reliefs[b].heights.empty()) continue;
    const Field heights = relief(b, travel);
    for (std::size_t n = 0; n < gap.size(); ++n) gap[n] -= heights[n];
  }
  return gap;
}

fft::Symmetry Setup::symmetry(const Travel& travel) const {
  const bool moved = travel != Travel{};
  const auto symmetry = !moved                ? symmetry_
                        : travel.is_along_x() ? common(symmetry_, fft::Symmetry::y)
                                              : fft::Symmetry::none;
  const bool flat = reliefs[0].heights.empty() && reliefs[1].heights.empty();
  if (flat) return symmetry;
  const auto of_gap = common(symmetry, symmetry_of(gap(travel), grid));
  return common(of_gap, common(symmetry_of_worn(0, travel), symmetry_of_worn(1, travel)));
}

fft::Symmetry Setup::symmetry_of_inclusions(const Travel& travel) const {
  if (travel == Travel{}) return symmetry_of_inclusions_;
  return common(symmetry_of_inclusions_, fft::Symmetry::y);
}

fft::Symmetry Setup::symmetry_of_worn(int body, const Travel& travel) const {
  const Relief& relief = reliefs[body];
  if (relief.worn.empty()) return fft::Symmetry::xy;
  Field worn(grid.surface_size());
  const int first = placement(travel).first[body];
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      worn[static_cast<std::size_t>(i) * grid.ny + j] = relief.worn_at(i + first, j, grid.ny);
    }
  }
  // Beyond the grid along x only the symmetry across the rows is known.
  return common(symmetry_of(worn, grid), fft::Symmetry::y);
}

Strength Setup::strength(int body, const Travel& travel) const {
  return {bodies[body], grid, reliefs[body], placement(travel).first[body]};
}

operators::HeatHistory Setup::heat_history(int body, const operators::Heating& heating) const {
  operators::Heating source = heating;
  if (transient_heating.follows()) source.speed_x = source.speed_y = 0.0;
  return heat_of(*media[body])
      ->history(grid, source,
                {.shortest = transient_heating.shortest,
                 .longest = transient_heating.longest,
                 .in_depth = grid.has_volume(),
                 .track = transient_heating.track});
}

Box Setup::volume_below(const Field& repulsion) const {
  Box box = Box::whole(grid);
  if (grid.nz > 0 || !grid.has_volume()) return box;
  const double depth = depth_in_radii * spot_radius(repulsion, grid);
  box.nz = std::max(fewest_layers, cells_over(depth, grid.dz));
  return box;
}

void Setup::require_volume(int body) const { simulation::require_volume(grid, media, body); }

void Setup::require_solvable_inclusions(operators::ResidualMethod method) const {
  for (int b = 0; b < 2; ++b) {
    if (!inclusions[b]) continue;
    const auto refuse = [b](const std::string& why) {
      throw std::invalid_argument("body " + std::to_string(b + 1) + " has inclusions: " + why);
    };
    if (method == operators::ResidualMethod::exact) {
      refuse(
          "residual_stress = \"exact\" is not supported with them, because its stress at the "
          "centres of cells makes soft inclusions unstable: use \"fast\"");
    }
    if (bodies[b].is_viscoelastic()) refuse("they are not supported in viscoelastic bodies");
    if (!reliefs[b].worn.empty()) refuse("wear of this body is not supported");
  }
}

}  // namespace samcontact::simulation
