// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/setup/operator_cache.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "samcontact/base/memory.hpp"
#include "samcontact/operators/medium/finite_body.hpp"
#include "samcontact/operators/medium/scaled_medium.hpp"
#include "samcontact/simulation/setup/yield_scan.hpp"

namespace samcontact::simulation {
namespace {

/// Number of kept operators: two bodies with one box each and one for the strain outside it, and
/// fields on demand.
constexpr std::size_t max_kept = 6;
/// Number of cells above which the operators of a box that has become too small are released.
constexpr std::size_t large_box = 1'000'000;
/// Memory of the displacement due to the tractions of a track: kernels, spectra and fields of all
/// tractions and axes [bytes per cell].
constexpr double track_bytes = 350;

}  // namespace

void require_volume(const Grid& grid, const Media& media, int body) {
  if (!grid.has_volume()) {
    throw std::invalid_argument("the grid has no dz: fields below the surface require layers");
  }
  if (media[body]->is_rigid()) {
    throw std::invalid_argument("body " + std::to_string(body + 1) +
                                " is rigid: it has no stress or strain");
  }
}

std::shared_ptr<const contact::ContactSolver> OperatorCache::solver(
    const operators::HeatingPair& heating) const {
  const std::lock_guard lock(mutex_);
  if (!solver_ || solver_heating_ != heating) {
    solver_ = std::make_shared<const contact::ContactSolver>(grid_, media_[0], media_[1], friction_,
                                                             heating, contact_law_);
    solver_heating_ = heating;
  }
  return solver_;
}

std::optional<double> OperatorCache::common_factor(const operators::HeatingPair& heating,
                                                   const Compliances& compliances) const {
  if (heating[0].is_on() || heating[1].is_on() || contact_law_->attracts()) return {};
  if (media_[0]->is_rigid() || compliances[0] == compliances[1]) return compliances[1];
  if (media_[1]->is_rigid()) return compliances[0];
  if (friction_.slides()) return {};
  for (const auto& medium : media_) {
    if (operators::faced_body(*medium)) return {};
  }
  const auto ratio = media_[0]->normal_ratio(operators::Traction::pressure, *media_[1]);
  if (!ratio) return {};
  return (*ratio * compliances[0] + compliances[1]) / (*ratio + 1.0);
}

contact::ScaledContact OperatorCache::contact(const operators::HeatingPair& heating,
                                              const Compliances& compliances) const {
  if (compliances == elastic_compliances) return {solver(heating)};
  if (const auto factor = common_factor(heating, compliances)) return {solver(heating), *factor};
  const std::lock_guard lock(mutex_);
  if (!scaled_solver_ || scaled_heating_ != heating || scaled_by_ != compliances) {
    scaled_solver_ = std::make_shared<const contact::ContactSolver>(
        grid_, operators::scaled_medium(media_[0], compliances[0]),
        operators::scaled_medium(media_[1], compliances[1]), friction_, heating, contact_law_);
    scaled_heating_ = heating;
    scaled_by_ = compliances;
  }
  return {scaled_solver_};
}

std::shared_ptr<const contact::PartialSlipContact> OperatorCache::partial_slip(
    const Compliances& compliances) const {
  const std::lock_guard lock(mutex_);
  if (!slipping_ || slipping_by_ != compliances) {
    slipping_ = std::make_shared<const contact::PartialSlipContact>(
        grid_, operators::scaled_medium(media_[0], compliances[0]),
        operators::scaled_medium(media_[1], compliances[1]), friction_, contact_law_);
    slipping_by_ = compliances;
  }
  return slipping_;
}

std::shared_ptr<const operators::BodyDisplacement> OperatorCache::displacement(int body) const {
  const std::lock_guard lock(mutex_);
  auto& own = displacements_[body];
  if (!own && media_[0] == media_[1]) own = displacements_[1 - body];
  if (!own) own = std::make_shared<const operators::BodyDisplacement>(grid_, media_[body]);
  return own;
}

std::shared_ptr<const operators::BodyDisplacement> OperatorCache::displacement(int body, int nx,
                                                                               int ny) const {
  if (nx == grid_.nx && ny == grid_.ny) return displacement(body);
  const std::lock_guard lock(mutex_);
  const auto fits = [&](const auto& kept) {
    return kept && kept->grid().nx == nx && kept->grid().ny == ny;
  };
  auto& own = small_displacements_[body];
  const auto& other = small_displacements_[1 - body];
  if (fits(own)) return own;
  if (fits(other) && media_[0] == media_[1]) return own = other;
  const Grid part = Box{0, 0, nx, ny, 0}.grid(grid_);
  if (nx > grid_.nx) {
    require_memory(track_bytes * static_cast<double>(part.surface_size()),
                   "the track of a viscoelastic body");
  }
  own = std::make_shared<const operators::BodyDisplacement>(part, media_[body]);
  return own;
}

std::shared_ptr<const operators::Temperature> OperatorCache::temperature(
    const operators::Heating& heating, const Box& box) const {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(temperatures_.begin(), temperatures_.end(), [&](const auto& kept) {
        return kept->heating() == heating && kept->grid().nx == box.nx && kept->grid().ny == box.ny;
      });
  if (found != temperatures_.end()) {
    temperatures_.splice(temperatures_.begin(), temperatures_, found);
    return temperatures_.front();
  }
  temperatures_.push_front(
      std::make_shared<const operators::Temperature>(box.grid(grid_), heating));
  if (temperatures_.size() > 2) temperatures_.pop_back();
  return temperatures_.front();
}

std::shared_ptr<const operators::HeatStress> OperatorCache::heat_stress(
    int body, const operators::Heating& heating) const {
  if (!heating.is_on()) return nullptr;
  const std::lock_guard lock(heat_mutex_);
  for (const auto& kept : heat_stress_) {
    if (kept && kept->heating() == heating && kept->body() == media_[body]->heat()) return kept;
  }
  heat_stress_[body] =
      std::make_shared<const operators::HeatStress>(grid_, heat_of(*media_[body]), heating);
  return heat_stress_[body];
}

std::shared_ptr<const operators::FluxHeat> OperatorCache::flux_heat(
    int body, const operators::Heating& heating) const {
  const operators::Heating of_power = heating.of_power();
  const std::lock_guard lock(heat_mutex_);
  auto& kept = flux_heat_[body];
  if (!kept || kept->heating() != of_power) {
    kept = std::make_shared<const operators::FluxHeat>(grid_, heat_of(*media_[body]), of_power);
  }
  return kept;
}

OperatorCache::Operators OperatorCache::volume(int body, const Box& box, operators::Tensor tensor,
                                               operators::ResidualMethod method,
                                               fft::Symmetry symmetry,
                                               const operators::Heating& heating,
                                               operators::Reach reach) const {
  require_volume(grid_, media_, body);
  const Box size{0, 0, box.nx, box.ny, box.nz, box.k0};
  if (heating.is_on() || grid_.period.is_on()) reach = {};
  reach = {std::min(reach.x, box.nx), std::min(reach.y, box.ny)};
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) {
    return k.medium == media_[body] && k.size == size && k.tensor == tensor && k.method == method &&
           k.symmetry == symmetry && k.heating == heating && k.reach == reach;
  });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
    return kept_.front().operators;
  }
  Operators shallower;
  for (const Kept& k : kept_) {
    const bool fits = k.medium == media_[body] && k.size.nx == size.nx && k.size.ny == size.ny &&
                      k.size.k0 == size.k0 && k.tensor == tensor && k.method == method &&
                      k.symmetry == symmetry && k.heating == heating && k.reach == reach;
    if (!fits || k.size.nz > size.nz) continue;
    if (!shallower || k.size.layers() > shallower->grid().nz) shallower = k.operators;
  }
  kept_.remove_if([&](const Kept& k) {
    const int own = k.operators == shallower ? 2 : 1;
    return k.medium == media_[body] && k.tensor == tensor && k.operators.use_count() == own &&
           k.size.volume_size() > large_box && size.contains(k.size);
  });
  const operators::VolumeOptions options{
      tensor, symmetry, method, image_tol_, heat_stress(body, heating), reach};
  kept_.push_front({media_[body], size, tensor, method, symmetry, heating, reach,
                    std::make_shared<operators::VolumeOperators>(size.grid(grid_), media_[body],
                                                                 options, shallower)});
  if (kept_.size() > max_kept) kept_.pop_back();
  return kept_.front().operators;
}

OperatorCache::Operators OperatorCache::volume_of_motion(int body, const Box& box,
                                                         operators::ResidualMethod method) const {
  {
    const std::lock_guard lock(mutex_);
    const auto last = of_motion_[body].lock();
    const auto fits = [&](const Grid& grid) {
      return grid.nx == box.nx && grid.ny == box.ny && grid.nz == box.nz;
    };
    if (last && !fits(last->grid())) {
      kept_.remove_if([&](const Kept& k) { return k.operators == last; });
    }
  }
  Operators found = volume(body, box, operators::Tensor::full, method, fft::Symmetry::none, {});
  const std::lock_guard lock(mutex_);
  of_motion_[body] = found;
  return found;
}

std::shared_ptr<const operators::ZoneTables> OperatorCache::zone_tables(
    int body, operators::Tensor tensor, const operators::Heating& heating) const {
  require_volume(grid_, media_, body);
  const std::lock_guard lock(mutex_);
  const operators::Heating heat = heating.is_on() ? heating : operators::Heating{};
  for (const KeptZones& kept : zone_tables_) {
    const bool fits = kept.medium == media_[body] && kept.heating == heat;
    if (fits && kept.tables->tensor() == tensor) return kept.tables;
  }
  std::erase_if(zone_tables_, [&](const KeptZones& kept) {
    return kept.body == body && kept.tables->tensor() == tensor && kept.heating.is_on() &&
           heat.is_on();
  });
  auto tables = std::make_shared<const operators::ZoneTables>(grid_, media_[body], tensor,
                                                              image_tol_, split_, heat);
  zone_tables_.push_back({body, media_[body], heat, std::move(tables)});
  return zone_tables_.back().tables;
}

std::shared_ptr<const ZoneScan> OperatorCache::zone_scan(int body, const Strength& strength,
                                                         const operators::Heating& heating) const {
  const auto tables = zone_tables(body, operators::Tensor::deviator, heating);
  const std::lock_guard lock(mutex_);
  for (const auto& scan : zone_scans_) {
    if (scan && scan->tables() == tables && scan->resolves(strength)) return scan;
  }
  zone_scans_[body] = std::make_shared<const ZoneScan>(tables, strength);
  return zone_scans_[body];
}

std::size_t OperatorCache::bytes() const {
  const std::lock_guard lock(mutex_);
  std::size_t bytes = 0;
  for (const KeptZones& kept : zone_tables_) bytes += kept.tables->bytes();
  for (const auto& scan : zone_scans_) bytes += scan ? scan->bytes() : 0;
  for (const Kept& k : kept_) bytes += k.operators->bytes();
  for (const auto& kept : temperatures_) bytes += kept->bytes();
  for (int b = 0; b < 2; ++b) {
    const auto& kept = displacements_[b];
    if (kept && (b == 0 || kept != displacements_[0])) bytes += kept->bytes();
  }
  const std::lock_guard heat_lock(heat_mutex_);
  for (int b = 0; b < 2; ++b) {
    if (heat_stress_[b] && (b == 0 || heat_stress_[1] != heat_stress_[0])) {
      bytes += heat_stress_[b]->bytes();
    }
  }
  return bytes;
}

}  // namespace samcontact::simulation
