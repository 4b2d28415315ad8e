// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/plastic_body.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "samcontact/base/deviator.hpp"
#include "samcontact/base/memory.hpp"
#include "samcontact/simulation/box_volume.hpp"
#include "samcontact/simulation/split_volume.hpp"

namespace samcontact::simulation {
namespace {

using operators::Tensor;

/// Elastic stress above this part of the yield stress belongs into the box. More where a weak layer
/// lies below what flows and apart from it: no rim says that flow above has brought it to yield.
constexpr double near = 0.9, near_weak = 0.7;
/// The same where zones, or layers below the grid, are to hold what yields.
constexpr double beyond_weak = 0.8;

/// Cells of a surface beyond which a bound of the stress says where a body may yield.
constexpr std::size_t large_surface = 65000;

/// Memory of an increment in which all of a box flows and that is divided; as measured,
/// docs/developer/data_layout.md has the parts. Of a cell that is stored, of the plane of
/// wavenumbers times layers, of coefficients there, which mirrors do not divide; of a backstress;
/// of the exact method.
constexpr double cell_bytes = 290, spectrum_bytes = 160, table_bytes = 150, backstress_bytes = 80,
                 exact_bytes = 1200;

/// Of a cell of zones, all included, and of the grid above them.
constexpr double zone_bytes = 600, lattice_bytes = 40;

/// Before zones of the volume are taken instead of others, which are given back.
void require_memory_of(const Zones& zones, double bytes, double before) {
  const Box& box = zones.around();
  require_memory(bytes - before, "the plastic zone, " + std::to_string(box.nx) + " x " +
                                     std::to_string(box.ny) + " x " + std::to_string(box.nz) +
                                     " cells,");
}

/// Sum of the backstresses of a cell: xx, yy, yz, xz, xy.
std::array<double, 5> centre(const Field& backstress, std::size_t cells, std::size_t cell) {
  std::array<double, 5> sum{};
  int c = 0;
  for (std::size_t at = cell; at < backstress.size(); at += cells) sum[c++ % 5] += backstress[at];
  return sum;
}

}  // namespace

PlasticBody::PlasticBody(const State& from, int index, std::uint8_t number, int copies,
                         fft::Symmetry symmetry, const operators::Heating& heating)
    : scene_(from.scene()),
      index_(index),
      number_(number),
      copies_(copies),
      method_(from.method),
      symmetry_(symmetry),
      heating_(heating),
      choice_(scene_.grid, symmetry),
      strength_(scene_.strength(index, from.travel)),
      history_(unfolded(from.plastic[index], scene_.grid, symmetry)),
      met_(from.met[index] ? unfolded(from.met[index], scene_.grid, symmetry) : history_),
      offset_(from.placement().offset[index]) {
  if (!history_) return;
  tensor_ = history_->tensor();
  strained_ = true;
}

Box PlasticBody::near_yield(const YieldScan& scan, const HeatOfIncrement& heat) const {
  const YieldLimit limit{strength_, weakest_, near, near_weak, heat.deviator(index_)};
  return scan.box(tractions(), sign(), limit);
}

Box PlasticBody::yield_below(const YieldScan& scan, const HeatOfIncrement& heat) const {
  const YieldLimit limit{strength_, 1.0, 1.0, beyond_weak, heat.deviator(index_)};
  const Box below = scan.box_below(tractions(), sign(), limit);
  // Flow above may have brought a weak layer to yield in the grid as well.
  return strength_.weakens() ? below.united(scan.box(tractions(), sign(), limit)) : below;
}

bool PlasticBody::yields_everywhere(const YieldScan& scan) const {
  return scan.is_beyond_everywhere(tractions(), sign(), {strength_, 1.0, 1.0, 1.0});
}

const Columns& PlasticBody::yielding_columns(const YieldScan& scan, const HeatOfIncrement& heat) {
  const bool known =
      yielding_ && yielding_->softening == weakest_ && yielding_->tractions == tractions();
  if (!known) {
    const YieldLimit limit{strength_, weakest_, 1.0, beyond_weak, heat.deviator(index_)};
    yielding_ = Yielding{tractions(), weakest_, columns_beyond(limit, scan)};
  }
  return yielding_->columns;
}

Columns PlasticBody::columns_beyond(const YieldLimit& limit, const YieldScan& scan) const {
  if (scene_.grid.surface_size() <= large_surface) {
    return scan.columns(tractions(), sign(), limit);
  }
  return scene_.zone_scan(index_, heating_)->columns(tractions(), sign(), limit);
}

std::vector<Box> PlasticBody::history_boxes() const {
  return history_ ? history_->zones().boxes() : std::vector<Box>{};
}

double PlasticBody::bytes_of(const Zones& zones, bool split) const {
  if (zones.empty()) return 0.0;
  const double backstresses = backstress_bytes * static_cast<double>(body().backstresses());
  const Box& box = zones.around();
  if (split) {
    const auto surface = static_cast<double>(Box::surface(scene_.grid).united(box).surface_size());
    return static_cast<double>(zones.cells()) * (zone_bytes + backstresses) +
           surface * box.nz * lattice_bytes;
  }
  const auto stored = static_cast<double>(box.volume_size()),
             whole = static_cast<double>(choice_.whole(box).volume_size());
  // What does not repeat itself is padded to twice its length.
  const Period& period = scene_.grid.period;
  const double planes = period.x > 0 && period.y > 0 ? 0.25 : 1.0;
  const bool exact = method_ == operators::ResidualMethod::exact;
  return stored * (cell_bytes + backstresses + planes * spectrum_bytes) +
         whole * planes * (table_bytes + (exact ? exact_bytes : 0.0));
}

void PlasticBody::set_zones(const Zones& zones, bool split, std::span<Source* const> sources,
                            ActiveCells& active) {
  require_memory_of(zones, bytes_of(zones, split), bytes_of(zones_, split_));
  // The old one first: the two together may not fit.
  volume_.reset();
  const int parts = operators::count(tensor_);
  const std::size_t cells = zones.cells();
  const std::size_t terms = body().backstresses();
  PlasticFields fields = history_ ? history_->fields(zones)
                                  : PlasticFields{zones, Field(parts * cells, 0.0),
                                                  Field(cells, 0.0), Field(cells * 5 * terms, 0.0)};
  const Field before = met_ && axes().size() > 1 ? met_->strain(zones) : Field{};
  // What is in the zones by now includes the last guess.
  for (int c = 0; c < parts; ++c) {
    copy_common(strain_.data() + c * zones_.cells(), zones_, fields.strain.data() + c * cells,
                zones);
  }
  strain_ = std::move(fields.strain);
  equivalent_ = std::move(fields.equivalent);
  backstress_ = std::move(fields.backstress);
  active.move(number_, zones_, zones);
  active_.assign(cells, -1);
  for (std::size_t n = 0; n < active.size(); ++n) {
    if (active.cells[n].body == number_) active_[active.cells[n].cell] = static_cast<int>(n);
  }
  zones_ = zones;
  factor_.clear();
  material_.clear();
  split_ = split;
  const auto tables = split ? scene_.zone_tables(index_, tensor_, heating_) : nullptr;
  if (split) {
    volume_ = std::make_unique<SplitVolume>(tables, zones_);
  } else if (!zones_.empty()) {
    volume_ =
        std::make_unique<BoxVolume>(scene_, index_, zones_, tensor_, method_, symmetry_, heating_);
  }
  find_slid_before(before);
  given_stress_.assign(zones_.count(), {});
  for (Source* source : sources) {
    for (std::size_t zone = 0; zone < zones_.count(); ++zone) {
      source->stress(index_, zones_.boxes()[zone], tensor_, given_stress_[zone]);
    }
  }
  for (std::size_t zone = 0; zone < zones_.count(); ++zone) {
    const Box& box = zones_.boxes()[zone];
    strength_.add_stress(box, tensor_, given_stress_[zone]);
    const Field factor = strength_.factor(box);
    factor_.insert(factor_.end(), factor.begin(), factor.end());
    const auto materials = strength_.materials(box);
    material_.insert(material_.end(), materials.begin(), materials.end());
  }
  if (!history_) return;
  outside_ = split ? outside_strain_in_zones(tables, *history_, zones_, scene_.reach)
                   : outside_strain(scene_, index_, *history_, zones_, method_);
  for (std::size_t zone = 0; zone < outside_.stress.size(); ++zone) {
    add_to(given_stress_[zone], std::move(outside_.stress[zone]));
  }
}

void PlasticBody::set_strain(std::uint32_t cell, const plasticity::Tensor& strain) {
  const auto places = operators::components(tensor_);
  const std::size_t cells = zones_.cells();
  for (std::size_t c = 0; c < places.size(); ++c) strain_[c * cells + cell] = strain[places[c]];
}

void PlasticBody::transform(bool active) {
  strained_ = (strained_ || active) && volume_;
  if (strained_) volume_->transform(strain_, axes());
}

void PlasticBody::meet(const operators::Tractions& tractions) {
  tractions_ = &tractions;
  if (offset_ != 0) seen_ = seen_from_body(tractions, scene_.grid, offset_);
}

void PlasticBody::soften(std::shared_ptr<const BoxField> factor) {
  softening_ = std::move(factor);
  if (!softening_) return;
  weakest_ = *std::min_element(softening_->values.begin(), softening_->values.end());
}

void PlasticBody::activate(std::uint32_t cell, const plasticity::Tensor& deviator,
                           ActiveCells& active) {
  active_[cell] = static_cast<int>(active.size());
  plasticity::Tensor before{};
  const auto places = operators::components(tensor_);
  for (std::size_t c = 0; c < places.size(); ++c) {
    before[places[c]] = strain_[c * zones_.cells() + cell];
  }
  if (tensor_ == Tensor::deviator) before[2] = -(before[0] + before[1]);
  active.append({number_, cell}, before, deviator);
}

PlasticBody::Limits PlasticBody::first_limits() const {
  Limits limits{{}, INFINITY};
  for (int n = 0; n < body().count(); ++n) {
    const plasticity::Material& material = body().material(n);
    const double first = material.hardening.yield_stress(0.0), bound = first * first / 3;
    const auto& profile = material.yield_profile;
    const double weakest = profile ? weakest_ * profile->smallest() : weakest_;
    limits.first.push_back(bound);
    limits.weakest = std::min(limits.weakest, bound * weakest * weakest);
  }
  return limits;
}

double PlasticBody::find_stress(ActiveCells& active) {
  const Limits limits = first_limits();
  std::vector<std::vector<Seen>> seen;  // by zone and layer
  for (const Box& box : zones_.boxes()) seen.emplace_back(box.nz);
  const auto look = [&](std::size_t zone, int k, const double* layer) {
    const Field sum = with_given_stress(zone, k, layer);
    const std::size_t plane = zones_.boxes()[zone].surface_size();
    seen[zone][k] = look_at_layer(zones_.first(zone) + k * plane, plane,
                                  sum.empty() ? layer : sum.data(), limits, active);
  };
  volume_->for_each_layer(strained_, strain_, tractions(), sign(), look);
  double largest = 0.0;
  for (const auto& layers : seen) {
    for (const Seen& layer : layers) {
      largest = std::max(largest, layer.largest);
      for (const auto& [cell, deviator] : layer.yielding) activate(cell, deviator, active);
    }
  }
  return 1 - std::sqrt(largest);
}

Field PlasticBody::with_given_stress(std::size_t zone, int k, const double* layer) const {
  const Field& given = given_stress_[zone];
  if (given.empty()) return {};
  const Box& box = zones_.boxes()[zone];
  const std::size_t parts = operators::count(tensor_), plane = box.surface_size();
  Field sum(layer, layer + parts * plane);
  for (std::size_t c = 0; c < parts; ++c) {
    const double* more = given.data() + (c * box.nz + k) * plane;
    for (std::size_t i = 0; i < plane; ++i) sum[c * plane + i] += more[i];
  }
  return sum;
}

PlasticBody::Seen PlasticBody::look_at_layer(std::size_t first, std::size_t plane,
                                             const double* layer, const Limits& limits,
                                             ActiveCells& active) const {
  const std::size_t cells = zones_.cells();
  const bool deviator = tensor_ == Tensor::deviator, kinematic = !backstress_.empty();
  const double* s[6];
  for (int c = 0; c < 6; ++c) s[c] = layer + (deviator ? (c < 3 ? c : c - 1) : c) * plane;
  Seen seen;
  double highest = 0.0;
  for (std::size_t i = 0; i < plane; ++i) {
    const std::size_t cell = first + i;
    double xx = s[0][i], yy = s[1][i];
    if (!deviator) {
      const double mean = (xx + yy + s[2][i]) / 3;
      xx -= mean;
      yy -= mean;
    }
    const int number = active_[cell];
    if (number < 0) {
      std::array<double, 5> effective{xx, yy, s[3][i], s[4][i], s[5][i]};
      if (kinematic) {
        const auto x = centre(backstress_, cells, cell);
        for (int c = 0; c < 5; ++c) effective[c] -= x[c];
      }
      const double second =
          second_invariant(effective[0], effective[1], effective[2], effective[3], effective[4]);
      const bool own = second > limits.weakest && (softening_ || equivalent_[cell] > 0);
      double limit =
          own ? yield_limit(static_cast<std::uint32_t>(cell)) : limits.first[material_number(cell)];
      if (!own && !factor_.empty()) limit *= factor_[cell] * factor_[cell];
      highest = std::max(highest, second / limit);
      if (second <= limit) continue;
    }
    const plasticity::Tensor t{xx, yy, -(xx + yy), s[3][i], s[4][i], s[5][i]};
    if (number >= 0) {
      active.stress[number] = t;
    } else {
      seen.yielding.emplace_back(static_cast<std::uint32_t>(cell), t);
    }
  }
  seen.largest = highest;
  return seen;
}

double PlasticBody::yield_limit(std::uint32_t cell) const {
  const double yield_stress =
      material(cell).hardening.yield_stress(equivalent_[cell]) * strength_of(cell);
  return yield_stress * yield_stress / 3;
}

double PlasticBody::strength_of(std::uint32_t cell) const {
  const double factor = factor_.empty() ? 1.0 : factor_[cell];
  if (!softening_) return factor;
  const auto [i, j, k] = zones_.cell(cell);
  return factor * softening_->at(i, j, k);
}

std::span<const plasticity::Tensor> PlasticBody::backstresses(std::uint32_t cell,
                                                              plasticity::Tensors& place) const {
  const std::size_t cells = zones_.cells(), terms = material(cell).backstresses.size();
  for (std::size_t n = 0; n < terms; ++n) {
    const double* x = backstress_.data() + 5 * n * cells + cell;
    place[n] = {x[0], x[cells], -(x[0] + x[cells]), x[2 * cells], x[3 * cells], x[4 * cells]};
  }
  return {place.data(), terms};
}

plasticity::Return PlasticBody::return_map(std::uint32_t cell, const plasticity::Tensor& deviator,
                                           const plasticity::Tensor& guess) const {
  plasticity::Tensors place;
  return plasticity::radial_return(deviator, guess, equivalent_[cell], material(cell),
                                   backstresses(cell, place), strength_of(cell));
}

double PlasticBody::strain_scale() const {
  return history_ ? std::max(strain_at_yield(), history_->max_equivalent()) : strain_at_yield();
}

void PlasticBody::flow(std::uint32_t cell, const plasticity::Tensor& increment, double equivalent) {
  equivalent_[cell] += equivalent;
  plasticity::Tensors place;
  std::size_t to = cell;
  auto law = material(cell).backstresses.begin();
  for (const auto& before : backstresses(cell, place)) {
    const auto x = plasticity::advanced(before, *law++, increment, equivalent);
    for (const int c : operators::components(Tensor::deviator)) {
      backstress_[to] = x[c];
      to += zones_.cells();
    }
  }
}

std::shared_ptr<const PlasticState> PlasticBody::finish() {
  const Box box = from_planes_on(zones_.around(), scene_.grid, symmetry_);
  // Before there is memory for the history twice.
  volume_.reset();
  given_stress_.clear();
  const PlasticFields fields{std::move(zones_), std::move(strain_), std::move(equivalent_),
                             std::move(backstress_)};
  return std::make_shared<const PlasticState>(history_.get(), symmetry_, tensor_, fields, box);
}

}  // namespace samcontact::simulation
