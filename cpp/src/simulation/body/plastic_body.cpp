// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/body/plastic_body.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "samcontact/base/deviator.hpp"
#include "samcontact/base/memory.hpp"
#include "samcontact/simulation/strain/box_volume.hpp"
#include "samcontact/simulation/strain/split_volume.hpp"

namespace samcontact::simulation {
namespace {

using operators::Tensor;

/// Memory of an increment with plastic flow in the whole box that is subdivided, measured (parts in
/// docs/developer/data_layout.md): per stored cell; per plane wavenumber and layer; per coefficient
/// there, which mirrors do not reduce; per backstress; for the exact method.
constexpr double cell_bytes = 290, spectrum_bytes = 160, table_bytes = 120, backstress_bytes = 80,
                 exact_bytes = 1200;

/// Memory of zones [byte]: per cell of a zone; per cell of the grid in each of their layers; of the
/// tables of close cells.
constexpr double zone_bytes = 220, lattice_bytes = 22, close_bytes = 1e7;

/// Called before the volume operators of zones replace others, which are released.
void require_memory_of(const Zones& zones, double bytes, double before) {
  const Box& box = zones.around();
  require_memory(bytes - before, "the plastic zone, " + std::to_string(box.nx) + " x " +
                                     std::to_string(box.ny) + " x " + std::to_string(box.nz) +
                                     " cells,");
}

/// Memory of an increment in the zones of a body [byte].
double bytes_of(const Zones& zones, bool split, const Grid& grid, fft::Symmetry symmetry,
                std::size_t terms, operators::ResidualMethod method) {
  if (zones.empty()) return 0.0;
  const double backstresses = backstress_bytes * static_cast<double>(terms);
  const Box& box = zones.around();
  if (split) {
    const auto surface = static_cast<double>(Box::surface(grid).united(box).surface_size());
    return static_cast<double>(zones.cells()) * (zone_bytes + backstresses) +
           surface * box.nz * lattice_bytes + close_bytes;
  }
  const auto stored = static_cast<double>(box.volume_size()),
             whole = static_cast<double>(whole_box(box, grid, symmetry).volume_size());
  // Directions that are not periodic are padded to twice their length.
  const Period& period = grid.period;
  const double planes = period.x > 0 && period.y > 0 ? 0.25 : 1.0;
  const bool exact = method == operators::ResidualMethod::exact;
  return stored * (cell_bytes + backstresses + planes * spectrum_bytes) +
         whole * planes * (table_bytes + (exact ? exact_bytes : 0.0));
}

/// Stress of layer k of a box [component][i][j] plus given stress [component][k][i][j]; empty if
/// nothing is given.
Field with_given_stress(const Field& given, const Box& box, int k, const double* layer) {
  if (given.empty()) return {};
  const std::size_t plane = box.surface_size(), parts = given.size() / box.volume_size();
  Field sum(layer, layer + parts * plane);
  for (std::size_t c = 0; c < parts; ++c) {
    const double* more = given.data() + (c * box.layers() + k) * plane;
    for (std::size_t i = 0; i < plane; ++i) sum[c * plane + i] += more[i];
  }
  return sum;
}

/// Part of a single zone with strain or active cells; the whole zone if there are none.
Box acting_part(const Zones& zones, const Field& strain, std::uint8_t number,
                const ActiveCells& active) {
  Box part = nonzero_part(strain, zones.around());
  for (const ActiveCells::Cell& own : active.cells) {
    if (own.body != number) continue;
    const auto [i, j, k] = zones.cell(own.cell);
    part = part.united({i, j, 1, 1, k + 1, k});
  }
  return part.empty() ? zones.around() : part;
}

/// Number of layers of a box above all cells that can yield, without inclusions.
int elastic_layers(const plasticity::Body& body, const Strength& strength, const Box& box) {
  const auto materials = strength.materials(box);
  const auto plastic = std::ranges::find_if(
      materials, [&](std::uint16_t number) { return body.material(number).is_plastic(); });
  if (plastic == materials.end()) return 0;
  return static_cast<int>(static_cast<std::size_t>(plastic - materials.begin()) /
                          box.surface_size());
}

/// Moves the active cells of a body, and its strain including the last estimate, to other zones.
/// Only unknowns differ from the history (null: none): fields of the old and the new zones are not
/// kept at the same time.
void move_strain(std::uint8_t number, const PlasticState* history, const Zones& from,
                 const Zones& to, std::size_t parts, ActiveCells& active, Field& strain) {
  Field estimates;
  for (const ActiveCells::Cell& own : active.cells) {
    if (own.body != number) continue;
    for (std::size_t c = 0; c < parts; ++c) {
      estimates.push_back(strain[c * from.cells() + own.cell]);
    }
  }
  strain = Field{};
  strain = history != nullptr ? history->strain(to) : Field(parts * to.cells(), 0.0);
  active.move(number, from, to);
  auto estimate = estimates.begin();
  for (const ActiveCells::Cell& own : active.cells) {
    if (own.body != number) continue;
    for (std::size_t c = 0; c < parts; ++c) strain[c * to.cells() + own.cell] = *estimate++;
  }
}

}  // namespace

PlasticBody::PlasticBody(const State& from, int index, std::uint8_t number, int copies,
                         fft::Symmetry symmetry, const operators::Heating& heating)
    : setup_(from.setup()),
      index_(index),
      number_(number),
      method_(from.method),
      symmetry_(symmetry),
      heating_(heating),
      strength_(setup_.strength(index, from.travel)),
      history_(unfolded(from.plastic[index], setup_.grid, symmetry)),
      met_(from.met[index] ? unfolded(from.met[index], setup_.grid, symmetry) : history_),
      rests_(from.advance == Travel{}),
      offset_(from.placement().offset[index]),
      cells_(setup_.bodies[index],
             MixedCells(setup_, index, from.placement().first[index], symmetry,
                        {from.inclusions_flow[index], from.matrix_flow[index]})),
      search_(setup_, index, heating, strength_),
      surface_(setup_, index, copies, symmetry, offset_) {
  // Eigenstrain due to a mismatch of bulk moduli has a trace.
  if (cells_.mixed().is_on()) tensor_ = Tensor::full;
  if (!history_) return;
  tensor_ = history_->tensor();
  strained_ = true;
}

void PlasticBody::set_zones(const Zones& zones, bool split, const Sources& sources,
                            ActiveCells& active) {
  const std::size_t terms = setup_.bodies[index_].backstresses();
  const auto bytes = [&](const Zones& of, bool are_split) {
    return bytes_of(of, are_split, setup_.grid, symmetry_, terms, method_);
  };
  const auto tables = split ? setup_.cache.zone_tables(index_, tensor_, heating_) : nullptr;
  double before = bytes(this->zones(), split_);
  // The tables of the last increment are kept.
  if (split && this->zones().empty()) before = static_cast<double>(tables->held_bytes());
  require_memory_of(zones, bytes(zones, split), before);
  // Release the old one first: both together may exceed the memory.
  volume_.reset();
  move_strain(number_, history_.get(), cells_.zones(), zones, operators::count(tensor_), active,
              strain_);
  const Field strain_before = met_ && surface_.axes().size() > 1 ? met_->strain(zones) : Field{};
  active_ = std::vector<int>{};
  active_.assign(zones.cells(), -1);
  for (std::size_t n = 0; n < active.size(); ++n) {
    if (active.cells[n].body == number_) active_[active.cells[n].cell] = static_cast<int>(n);
  }
  cells_.take(zones, history_.get(), terms, strength_);
  // Cells with inclusions always have unknowns.
  for (const std::uint32_t cell : cells_.mixed().numbers()) {
    if (active_number(cell) >= 0) continue;
    active.mixed.push_back(active.size());
    activate(cell, {}, active);
  }
  split_ = split;
  if (split) {
    volume_ = std::make_unique<SplitVolume>(tables, zones);
  } else if (!zones.empty()) {
    // While a body moves, a first guess may strain cells of an elastic matrix.
    const bool some = rests_ && zones.count() == 1 && !setup_.bodies[index_].is_plastic();
    Box needed = some ? acting_part(zones, strain_, number_, active) : zones.around();
    if (!cells_.mixed().is_on()) {
      needed.k0 += elastic_layers(setup_.bodies[index_], strength_, needed);
    }
    volume_ = std::make_unique<BoxVolume>(setup_, index_, zones, tensor_, method_, symmetry_,
                                          heating_, needed);
  }
  surface_.begin(volume_.get(), split, strain_before);
  given_stress_.assign(zones.count(), {});
  for (std::size_t zone = 0; zone < zones.count(); ++zone) {
    sources.stress(index_, zones.boxes()[zone], tensor_, given_stress_[zone]);
  }
  if (!history_) return;
  OutsideStrain outside = known_outside_ ? std::move(*known_outside_)
                          : split ? outside_strain_in_zones(tables, *history_, zones, setup_.reach)
                                  : outside_strain(setup_, index_, *history_, zones, method_);
  known_outside_.reset();
  for (std::size_t zone = 0; zone < outside.stress.size(); ++zone) {
    add_to(given_stress_[zone], std::move(outside.stress[zone]));
  }
  surface_.take(std::move(outside));
}

void PlasticBody::set_zones(const Zones& zones, std::shared_ptr<const PlasticState> history,
                            OutsideStrain outside, const Sources& sources, ActiveCells& active) {
  history_ = std::move(history);
  known_outside_ = std::move(outside);
  set_zones(zones, false, sources, active);
}

void PlasticBody::set_strain(std::uint32_t cell, const plasticity::Tensor& strain) {
  const auto places = operators::components(tensor_);
  const std::size_t cells = zones().cells();
  for (std::size_t c = 0; c < places.size(); ++c) strain_[c * cells + cell] = strain[places[c]];
}

void PlasticBody::transform(bool active) {
  strained_ = (strained_ || active) && volume_;
  surface_.set_strained(strained_);
  if (strained_) volume_->transform(strain_, surface_.axes());
}

void PlasticBody::set_tractions(const operators::Tractions& tractions) {
  tractions_ = &tractions;
  if (offset_ != 0) seen_ = seen_from_body(tractions, setup_.grid, offset_);
}

void PlasticBody::soften(std::shared_ptr<const BoxField> factor) {
  cells_.soften(std::move(factor));
  search_.soften(cells_.weakest());
}

void PlasticBody::activate(std::uint32_t cell, const plasticity::Tensor& deviator,
                           ActiveCells& active) {
  active_[cell] = static_cast<int>(active.size());
  plasticity::Tensor before{};
  const auto places = operators::components(tensor_);
  for (std::size_t c = 0; c < places.size(); ++c) {
    before[places[c]] = strain_[c * zones().cells() + cell];
  }
  if (tensor_ == Tensor::deviator) before[2] = -(before[0] + before[1]);
  active.append({number_, cell}, before, deviator);
}

double PlasticBody::find_stress(ActiveCells& active) {
  const CellHistory::Limits limits = cells_.first_limits();
  std::vector<std::vector<LayerCheck>> checked;  // by zone and layer
  for (const Box& box : zones().boxes()) checked.emplace_back(box.layers());
  const auto check = [&](std::size_t zone, int k, const double* layer) {
    const Field sum = with_given_stress(given_stress_[zone], zones().boxes()[zone], k, layer);
    const std::size_t plane = zones().boxes()[zone].surface_size();
    checked[zone][k] = check_layer(zones().first(zone) + k * plane, plane,
                                   sum.empty() ? layer : sum.data(), limits, active);
  };
  volume_->for_each_layer(strained_, strain_, tractions(), operators::shear_sign(index_), check);
  double largest = 0.0;
  std::size_t count = active.size();
  for (const auto& layers : checked) {
    for (const LayerCheck& layer : layers) count += layer.yielding.size();
  }
  active.reserve(count);
  for (const auto& layers : checked) {
    for (const LayerCheck& layer : layers) {
      largest = std::max(largest, layer.largest);
      for (const auto& [cell, deviator] : layer.yielding) activate(cell, deviator, active);
    }
  }
  return 1 - std::sqrt(largest);
}

PlasticBody::LayerCheck PlasticBody::check_layer(std::size_t first, std::size_t plane,
                                                 const double* layer,
                                                 const CellHistory::Limits& limits,
                                                 ActiveCells& active) const {
  const bool deviator = tensor_ == Tensor::deviator, kinematic = cells_.has_backstress();
  const double* s[6];
  for (int c = 0; c < 6; ++c) s[c] = layer + (deviator ? (c < 3 ? c : c - 1) : c) * plane;
  LayerCheck checked;
  double highest = 0.0;
  for (std::size_t i = 0; i < plane; ++i) {
    const std::size_t cell = first + i;
    double xx = s[0][i], yy = s[1][i], mean = 0.0;
    if (!deviator) {
      mean = (xx + yy + s[2][i]) / 3;
      xx -= mean;
      yy -= mean;
    }
    const int number = active_[cell];
    if (number < 0) {
      std::array<double, 5> effective{xx, yy, s[3][i], s[4][i], s[5][i]};
      if (kinematic) {
        const auto x = cells_.centre(cell);
        for (int c = 0; c < 5; ++c) effective[c] -= x[c];
      }
      const double second =
          second_invariant(effective[0], effective[1], effective[2], effective[3], effective[4]);
      const double limit = cells_.limit(cell, second, limits);
      highest = std::max(highest, second / limit);
      if (second <= limit) continue;
    }
    if (number < 0 || cells_.mixed().at(cell) == nullptr) mean = 0.0;
    const plasticity::Tensor t{xx + mean, yy + mean, mean - (xx + yy), s[3][i], s[4][i], s[5][i]};
    if (number >= 0) {
      active.stress[number] = t;
    } else {
      checked.yielding.emplace_back(static_cast<std::uint32_t>(cell), t);
    }
  }
  checked.largest = highest;
  return checked;
}

std::shared_ptr<const PlasticState> PlasticBody::finish() {
  const Box box = from_planes_on(zones().around(), setup_.grid, symmetry_);
  // Release before the history is copied.
  volume_.reset();
  given_stress_.clear();
  const PlasticFields fields = cells_.finish(std::move(strain_));
  return std::make_shared<const PlasticState>(history_.get(), symmetry_, tensor_, fields, box,
                                              Lattice{{}, setup_.grid.period.x});
}

}  // namespace samcontact::simulation
