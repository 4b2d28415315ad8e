// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/body/cell_history.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace samcontact::simulation {

using operators::Tensor;

void CellHistory::take(const Zones& zones, const PlasticState* history, std::size_t terms,
                       const Strength& strength) {
  // Release the old fields first.
  equivalent_ = Field{};
  backstress_ = Field{};
  const std::size_t cells = zones.cells();
  if (history != nullptr) {
    take(zones, history->equivalent(zones), history->backstress(zones), strength);
  } else {
    take(zones, Field(cells, 0.0), Field(5 * terms * cells, 0.0), strength);
  }
}

void CellHistory::take(const Zones& zones, Field equivalent, Field backstress,
                       const Strength& strength) {
  zones_ = zones;
  mixed_.take(zones);
  equivalent_ = std::move(equivalent);
  backstress_ = std::move(backstress);
  factor_.clear();
  material_.clear();
  for (const Box& box : zones_.boxes()) {
    const Field factor = strength.factor(box);
    factor_.insert(factor_.end(), factor.begin(), factor.end());
    const auto materials = strength.materials(box);
    material_.insert(material_.end(), materials.begin(), materials.end());
  }
}

void CellHistory::soften(std::shared_ptr<const BoxField> factor) {
  softening_ = std::move(factor);
  if (!softening_) return;
  weakest_ = *std::min_element(softening_->values.begin(), softening_->values.end());
}

CellHistory::Limits CellHistory::first_limits() const {
  Limits limits{{}, INFINITY};
  for (int n = 0; n < body_.count(); ++n) {
    const plasticity::Material& material = body_.material(n);
    const double first = material.hardening.yield_stress(0.0), bound = first * first / 3;
    const auto& profile = material.yield_profile;
    const double weakest = profile ? weakest_ * profile->smallest() : weakest_;
    limits.first.push_back(bound);
    limits.weakest = std::min(limits.weakest, bound * weakest * weakest);
  }
  return limits;
}

double CellHistory::yield_limit(std::uint32_t cell) const {
  const double yield_stress =
      material(cell).hardening.yield_stress(equivalent_[cell]) * strength_of(cell);
  return yield_stress * yield_stress / 3;
}

double CellHistory::strength_of(std::uint32_t cell) const {
  const double factor = factor_.empty() ? 1.0 : factor_[cell];
  if (!softening_) return factor;
  const auto [i, j, k] = zones_.cell(cell);
  return factor * softening_->at(i, j, k);
}

std::span<const plasticity::Tensor> CellHistory::backstresses(std::uint32_t cell,
                                                              plasticity::Tensors& place) const {
  const std::size_t cells = zones_.cells(), terms = material(cell).backstresses.size();
  for (std::size_t n = 0; n < terms; ++n) {
    const double* x = backstress_.data() + 5 * n * cells + cell;
    place[n] = {x[0], x[cells], -(x[0] + x[cells]), x[2 * cells], x[3 * cells], x[4 * cells]};
  }
  return {place.data(), terms};
}

plasticity::Return CellHistory::return_map(std::uint32_t cell, const plasticity::Tensor& deviator,
                                           const plasticity::Tensor& guess) const {
  plasticity::Tensors place;
  const plasticity::Material& law = material(cell);
  const double G = mixed_.matrix_part(material_number(cell)) * law.elastic.shear_modulus();
  return plasticity::radial_return(deviator, guess, equivalent_[cell], G, law,
                                   backstresses(cell, place), strength_of(cell));
}

void CellHistory::flow(std::uint32_t cell, const plasticity::Tensor& increment, double equivalent) {
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

PlasticFields CellHistory::finish(Field strain) {
  return {std::move(zones_), std::move(strain), std::move(equivalent_), std::move(backstress_)};
}

}  // namespace samcontact::simulation
