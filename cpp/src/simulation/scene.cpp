// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/scene.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace samcontact::simulation {
namespace {

/// Two bodies with a box each, and the whole grid for fields on demand.
constexpr std::size_t most_kept = 4;
/// Cells beyond which the operators of a box that was outgrown are not kept.
constexpr std::size_t large_box = 1'000'000;

}  // namespace

Scene::Scene(const Grid& grid_, const plasticity::Material& body1,
             const plasticity::Material& body2, Field initial_gap_, double friction_,
             double image_tol, const HeatMarch& march_)
    : grid(grid_),
      materials{body1, body2},
      initial_gap(std::move(initial_gap_)),
      friction(friction_),
      march(march_),
      image_tol_(image_tol),
      symmetry_(symmetry_of(initial_gap, grid_)) {
  // Throws for bodies or friction that no contact has.
  solver({});
  // Sliding is along x.
  if (friction > 0) symmetry_ = common(symmetry_, fft::Symmetry::y);
}

std::shared_ptr<const contact::ContactSolver> Scene::solver(
    const operators::HeatingPair& heating) const {
  const std::lock_guard lock(mutex_);
  if (!solver_ || solver_heating_ != heating) {
    solver_ = std::make_shared<const contact::ContactSolver>(
        grid, materials[0].elastic, materials[1].elastic, friction, heating);
    solver_heating_ = heating;
  }
  return solver_;
}

std::shared_ptr<const operators::Temperature> Scene::temperature(
    const operators::Heating& heating) const {
  const std::lock_guard lock(mutex_);
  if (!temperature_ || temperature_heating_ != heating) {
    temperature_ = std::make_shared<const operators::Temperature>(grid, heating, grid.z());
    temperature_heating_ = heating;
  }
  return temperature_;
}

std::shared_ptr<const operators::HeatStress> Scene::heat_stress(
    int body, const operators::Heating& heating) const {
  if (!heating.is_on()) return nullptr;
  const std::lock_guard lock(heat_mutex_);
  const Elastic& elastic = materials[body].elastic;
  for (const auto& kept : heat_stress_) {
    if (kept && kept->heating() == heating && kept->elastic() == elastic) return kept;
  }
  heat_stress_[body] = std::make_shared<const operators::HeatStress>(grid, elastic, heating);
  return heat_stress_[body];
}

operators::HeatHistory Scene::heat_history(int body, const operators::Heating& heating) const {
  return {grid,
          heating.thermal,
          materials[body].elastic,
          heating.speed_x,
          heating.speed_y,
          {.shortest = march.shortest, .longest = march.longest, .in_depth = grid.nz > 0}};
}

void Scene::require_volume(int body) const {
  if (grid.nz == 0) {
    throw std::invalid_argument("nz is 0: fields below the surface need a grid with nz and dz");
  }
  if (materials[body].elastic.is_rigid()) {
    throw std::invalid_argument("body " + std::to_string(body + 1) +
                                " is rigid: it has no stress or strain");
  }
}

Scene::Operators Scene::volume(int body, const Box& box, operators::Tensor tensor,
                               operators::ResidualMethod method, fft::Symmetry symmetry,
                               const operators::Heating& heating) const {
  require_volume(body);
  if (materials[0].elastic == materials[1].elastic) body = 0;
  const Box size{0, 0, box.nx, box.ny, box.nz};
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) {
    return k.body == body && k.size == size && k.tensor == tensor && k.method == method &&
           k.symmetry == symmetry && k.heating == heating;
  });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    return kept_.front().operators;
  }
  kept_.remove_if([&](const Kept& k) {
    return k.body == body && k.tensor == tensor && k.operators.use_count() == 1 &&
           k.size.volume_size() > large_box && size.contains(k.size);
  });
  const operators::VolumeOptions options{tensor, symmetry, method, image_tol_,
                                         heat_stress(body, heating)};
  kept_.push_front({body, size, tensor, method, symmetry, heating,
                    std::make_shared<operators::VolumeOperators>(
                        size.grid(grid), materials[body].elastic, options)});
  if (kept_.size() > most_kept) kept_.pop_back();
  return kept_.front().operators;
}

std::size_t Scene::operator_bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t bytes = 0;
  for (const Kept& k : kept_) bytes += k.operators->bytes();
  if (temperature_) bytes += temperature_->bytes();
  const std::lock_guard heat_lock(heat_mutex_);
  for (int b = 0; b < 2; ++b) {
    if (heat_stress_[b] && (b == 0 || heat_stress_[1] != heat_stress_[0])) {
      bytes += heat_stress_[b]->bytes();
    }
  }
  return bytes;
}

fft::Symmetry symmetry_of(const operators::HeatingPair& heating) {
  auto symmetry = fft::Symmetry::xy;
  for (const auto& h : heating) {
    if (!h.is_on()) continue;
    if (h.speed_x != 0) symmetry = common(symmetry, fft::Symmetry::y);
    if (h.speed_y != 0) symmetry = fft::Symmetry::none;
  }
  return symmetry;
}

fft::Symmetry symmetry_of(const Field& field, const Grid& grid) {
  const auto at = [&](int i, int j) { return field[static_cast<std::size_t>(i) * grid.ny + j]; };
  double largest = 0.0;
  for (const double value : field) largest = std::max(largest, std::fabs(value));
  const double rounding = 1e-10 * largest;
  bool x = true, y = true;
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      y = y && std::fabs(at(i, j) - at(i, grid.ny - 1 - j)) <= rounding;
      x = x && std::fabs(at(i, j) - at(grid.nx - 1 - i, j)) <= rounding;
    }
  }
  if (!y) return fft::Symmetry::none;
  return x ? fft::Symmetry::xy : fft::Symmetry::y;
}

fft::Symmetry symmetry_of(const operators::Tractions& tractions, const Grid& grid) {
  if (!tractions.shear_y.empty()) return fft::Symmetry::none;
  fft::Symmetry symmetry = symmetry_of(tractions.pressure, grid);
  if (!tractions.shear_x.empty()) {
    symmetry = common(symmetry, common(fft::Symmetry::y, symmetry_of(tractions.shear_x, grid)));
  }
  return symmetry;
}

fft::Symmetry common(fft::Symmetry a, fft::Symmetry b) { return std::min(a, b); }

Box stored_part(const Grid& grid, fft::Symmetry symmetry) {
  Box part = Box::whole(grid);
  if (symmetry != fft::Symmetry::none) {
    part.j0 = grid.ny / 2;
    part.ny = grid.ny - part.j0;
  }
  if (symmetry == fft::Symmetry::xy) {
    part.i0 = grid.nx / 2;
    part.nx = grid.nx - part.i0;
  }
  return part;
}

Box whole_box(const Box& stored, const Grid& grid, fft::Symmetry symmetry) {
  Box whole = stored;
  if (symmetry != fft::Symmetry::none) {
    whole.j0 = grid.ny - (stored.j0 + stored.ny);
    whole.ny = grid.ny - 2 * whole.j0;
  }
  if (symmetry == fft::Symmetry::xy) {
    whole.i0 = grid.nx - (stored.i0 + stored.nx);
    whole.nx = grid.nx - 2 * whole.i0;
  }
  return whole;
}

}  // namespace samcontact::simulation
