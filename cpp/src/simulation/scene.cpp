// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "samcontact/base/cells_over.hpp"
#include "samcontact/operators/medium/layered_half_space.hpp"
#include "samcontact/simulation/yield_scan.hpp"

namespace samcontact::simulation {
namespace {

/// Two bodies with a box each and one for what lies outside of it, and fields on demand.
constexpr std::size_t most_kept = 6;
/// Cells beyond which the operators of a box that was outgrown are not kept.
constexpr std::size_t large_box = 1'000'000;

/// Where the volume has no bottom: depth of fields in radii of a contact, and fewest layers.
constexpr double depth_in_radii = 1.5;
constexpr int fewest_layers = 8;

/// Radius of the spots under pressure, a circle's from its mean chord, along the direction in which
/// they are shorter [m].
double spot_radius(const Field& pressure, const Grid& grid) {
  std::size_t cells = 0, chords_x = 0, chords_y = 0;
  const auto touches = [&](int i, int j) {
    return i >= 0 && j >= 0 && pressure[static_cast<std::size_t>(i) * grid.ny + j] > 0;
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

std::array<operators::SharedMedium, 2> media_of(const plasticity::Body& body1,
                                                const plasticity::Body& body2) {
  const auto upper = operators::medium_of(body1.stack());
  const auto lower = operators::medium_of(body2.stack());
  return {upper, *upper == *lower ? upper : lower};
}

}  // namespace

Scene::Scene(const Grid& grid_, const plasticity::Body& body1, const plasticity::Body& body2,
             Field initial_gap_, const contact::FrictionLaw& friction_, double image_tol,
             const HeatMarch& march_, int reach_, Reliefs reliefs_,
             const operators::BandSplit& split_)
    : grid(grid_),
      bodies{body1, body2},
      media(media_of(body1, body2)),
      initial_gap(std::move(initial_gap_)),
      friction(friction_),
      partial_slip(friction.sticks() ? std::make_unique<const contact::PartialSlipContact>(
                                           grid_, media[0], media[1], friction)
                                     : nullptr),
      march(march_),
      reach(reach_),
      split((require_valid(split_), split_)),
      reliefs(std::move(reliefs_)),
      image_tol_(image_tol),
      symmetry_(symmetry_of(initial_gap, grid_)) {
  // Throws for bodies that have no contact.
  if (!friction.sticks()) solver({});
  symmetry_ = common(symmetry_, friction.symmetry());
}

int Scene::followed() const {
  // Without plastic strain or relief nothing tells one place of a body from another.
  const auto remembers = [this](int body) {
    return bodies[body].is_plastic() || !reliefs[body].heights.empty();
  };
  return remembers(1) ? 1 : remembers(0) ? 0 : -1;
}

Placement Scene::placement(const Travel& travel) const {
  const int body = followed();
  if (body >= 0 || !friction.sticks()) return {travel, body};
  // What sticks remembers the shear, which is carried by the mean of both ways.
  const double mean = 0.5 * (travel[0] + travel[1]);
  return {Travel{mean, mean}, 1};
}

Field Scene::relief(int body, const Travel& travel) const {
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

Field Scene::gap(const Travel& travel) const {
  Field gap = shifted_gap(initial_gap, grid, placement(travel).origin);
  for (int b = 0; b < 2; ++b) {
    if (reliefs[b].heights.empty()) continue;
    const Field heights = relief(b, travel);
    for (std::size_t n = 0; n < gap.size(); ++n) gap[n] -= heights[n];
  }
  return gap;
}

fft::Symmetry Scene::symmetry(const Travel& travel) const {
  const bool moved = travel != Travel{};
  const auto symmetry = moved ? common(symmetry_, fft::Symmetry::y) : symmetry_;
  const bool flat = reliefs[0].heights.empty() && reliefs[1].heights.empty();
  if (flat) return symmetry;
  const auto of_gap = common(symmetry, symmetry_of(gap(travel), grid));
  return common(of_gap, common(symmetry_of_worn(0, travel), symmetry_of_worn(1, travel)));
}

fft::Symmetry Scene::symmetry_of_worn(int body, const Travel& travel) const {
  const Relief& relief = reliefs[body];
  if (relief.worn.empty()) return fft::Symmetry::xy;
  Field worn(grid.surface_size());
  const int first = placement(travel).first[body];
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      worn[static_cast<std::size_t>(i) * grid.ny + j] = relief.worn_at(i + first, j, grid.ny);
    }
  }
  // Of what lies beside the grid along x only the rows are known to be alike.
  return common(symmetry_of(worn, grid), fft::Symmetry::y);
}

Strength Scene::strength(int body, const Travel& travel) const {
  return {bodies[body], grid, reliefs[body], placement(travel).first[body]};
}

std::shared_ptr<const contact::ContactSolver> Scene::solver(
    const operators::HeatingPair& heating) const {
  const std::lock_guard lock(mutex_);
  if (!solver_ || solver_heating_ != heating) {
    solver_ =
        std::make_shared<const contact::ContactSolver>(grid, media[0], media[1], friction, heating);
    solver_heating_ = heating;
  }
  return solver_;
}

std::shared_ptr<const operators::Temperature> Scene::temperature(const operators::Heating& heating,
                                                                 const Box& box) const {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(temperatures_.begin(), temperatures_.end(), [&](const auto& kept) {
        return kept->heating() == heating && kept->grid().nx == box.nx && kept->grid().ny == box.ny;
      });
  if (found != temperatures_.end()) {
    temperatures_.splice(temperatures_.begin(), temperatures_, found);
    return temperatures_.front();
  }
  temperatures_.push_front(std::make_shared<const operators::Temperature>(box.grid(grid), heating));
  if (temperatures_.size() > 2) temperatures_.pop_back();
  return temperatures_.front();
}

std::shared_ptr<const operators::HeatStress> Scene::heat_stress(
    int body, const operators::Heating& heating) const {
  if (!heating.is_on()) return nullptr;
  const std::lock_guard lock(heat_mutex_);
  for (const auto& kept : heat_stress_) {
    if (kept && kept->heating() == heating && kept->body() == media[body]->heat()) return kept;
  }
  heat_stress_[body] =
      std::make_shared<const operators::HeatStress>(grid, heat_of(*media[body]), heating);
  return heat_stress_[body];
}

std::shared_ptr<const operators::FluxHeat> Scene::flux_heat(
    int body, const operators::Heating& heating) const {
  const operators::Heating of_power = heating.of_power();
  const std::lock_guard lock(heat_mutex_);
  auto& kept = flux_heat_[body];
  if (!kept || kept->heating() != of_power) {
    kept = std::make_shared<const operators::FluxHeat>(grid, heat_of(*media[body]), of_power);
  }
  return kept;
}

operators::HeatHistory Scene::heat_history(int body, const operators::Heating& heating) const {
  return heat_of(*media[body])
      ->history(
          grid, heating,
          {.shortest = march.shortest, .longest = march.longest, .in_depth = grid.has_volume()});
}

Box Scene::volume_below(const Field& pressure) const {
  Box box = Box::whole(grid);
  if (grid.nz > 0 || !grid.has_volume()) return box;
  const double depth = depth_in_radii * spot_radius(pressure, grid);
  box.nz = std::max(fewest_layers, cells_over(depth, grid.dz));
  return box;
}

void Scene::require_volume(int body) const {
  if (!grid.has_volume()) {
    throw std::invalid_argument("the grid has no dz: fields below the surface need layers");
  }
  if (media[body]->is_rigid()) {
    throw std::invalid_argument("body " + std::to_string(body + 1) +
                                " is rigid: it has no stress or strain");
  }
}

Scene::Operators Scene::volume(int body, const Box& box, operators::Tensor tensor,
                               operators::ResidualMethod method, fft::Symmetry symmetry,
                               const operators::Heating& heating) const {
  require_volume(body);
  const Box size{0, 0, box.nx, box.ny, box.nz};
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) {
    return k.medium == media[body] && k.size == size && k.tensor == tensor && k.method == method &&
           k.symmetry == symmetry && k.heating == heating;
  });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    return kept_.front().operators;
  }
  Operators shallower;
  for (const Kept& k : kept_) {
    const bool alike = k.medium == media[body] && k.size.nx == size.nx && k.size.ny == size.ny &&
                       k.tensor == tensor && k.method == method && k.symmetry == symmetry &&
                       k.heating == heating;
    if (!alike || k.size.nz > size.nz) continue;
    if (!shallower || k.size.nz > shallower->grid().nz) shallower = k.operators;
  }
  kept_.remove_if([&](const Kept& k) {
    const int own = k.operators == shallower ? 2 : 1;
    return k.medium == media[body] && k.tensor == tensor && k.operators.use_count() == own &&
           k.size.volume_size() > large_box && size.contains(k.size);
  });
  const operators::VolumeOptions options{tensor, symmetry, method, image_tol_,
                                         heat_stress(body, heating)};
  kept_.push_front({media[body], size, tensor, method, symmetry, heating,
                    std::make_shared<operators::VolumeOperators>(size.grid(grid), media[body],
                                                                 options, shallower)});
  if (kept_.size() > most_kept) kept_.pop_back();
  return kept_.front().operators;
}

std::shared_ptr<const operators::ZoneTables> Scene::zone_tables(
    int body, operators::Tensor tensor, const operators::Heating& heating) const {
  require_volume(body);
  const std::lock_guard lock(mutex_);
  const operators::Heating heat = heating.is_on() ? heating : operators::Heating{};
  for (const KeptZones& kept : zone_tables_) {
    const bool alike = kept.medium == media[body] && kept.heating == heat;
    if (alike && kept.tables->tensor() == tensor) return kept.tables;
  }
  std::erase_if(zone_tables_, [&](const KeptZones& kept) {
    return kept.body == body && kept.tables->tensor() == tensor && kept.heating.is_on() &&
           heat.is_on();
  });
  auto tables = std::make_shared<const operators::ZoneTables>(grid, media[body], tensor, image_tol_,
                                                              split, heat);
  zone_tables_.push_back({body, media[body], heat, std::move(tables)});
  return zone_tables_.back().tables;
}

std::shared_ptr<const ZoneScan> Scene::zone_scan(int body,
                                                 const operators::Heating& heating) const {
  const auto tables = zone_tables(body, operators::Tensor::deviator, heating);
  const Strength strength = this->strength(body, {});
  const std::lock_guard lock(mutex_);
  for (const auto& scan : zone_scans_) {
    if (scan && scan->tables() == tables && scan->resolves(strength)) return scan;
  }
  zone_scans_[body] = std::make_shared<const ZoneScan>(tables, strength);
  return zone_scans_[body];
}

std::size_t Scene::operator_bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t bytes = 0;
  for (const KeptZones& kept : zone_tables_) bytes += kept.tables->bytes();
  for (const auto& scan : zone_scans_) bytes += scan ? scan->bytes() : 0;
  for (const Kept& k : kept_) bytes += k.operators->bytes();
  for (const auto& kept : temperatures_) bytes += kept->bytes();
  const std::lock_guard heat_lock(heat_mutex_);
  for (int b = 0; b < 2; ++b) {
    if (heat_stress_[b] && (b == 0 || heat_stress_[1] != heat_stress_[0])) {
      bytes += heat_stress_[b]->bytes();
    }
  }
  return bytes;
}

}  // namespace samcontact::simulation
