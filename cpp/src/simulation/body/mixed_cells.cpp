// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/body/mixed_cells.hpp"

#include <algorithm>
#include <utility>

#include "samcontact/simulation/cells/mirror.hpp"

namespace samcontact::simulation {

using operators::Tensor;

MixedCells::MixedCells(const Setup& setup, int body, int first, fft::Symmetry symmetry,
                       const Flows& before)
    : setup_(setup),
      inclusions_(setup.inclusions[body]),
      first_(first),
      symmetry_(symmetry),
      matrix_(setup.bodies[body]),
      before_{unfolded(before.own, setup.grid, symmetry),
              unfolded(before.of_matrix, setup.grid, symmetry)} {
  if (!inclusions_) return;
  for (int n = 0; n < matrix_.count(); ++n) laws_.emplace_back(matrix_.material(n), are_strong());
}

Box MixedCells::box() const {
  return inclusions_ ? inclusions_->in_grid(setup_.grid, first_) : Box{};
}

Columns MixedCells::columns() const {
  Columns columns{box(), {}};
  const Box& window = columns.window;
  columns.depth.assign(window.surface_size(), 0);
  std::size_t n = 0;
  for (int i = window.i0; i < window.i0 + window.nx; ++i) {
    for (int j = window.j0; j < window.j0 + window.ny; ++j, ++n) {
      const auto fills = [&](int k) {
        return inclusions_->at(i, j, k, first_, setup_.grid.period) != nullptr;
      };
      int depth = window.nz;
      while (depth > window.k0 && !fills(depth - 1)) --depth;
      columns.depth[n] = depth > window.k0 ? depth : 0;
    }
  }
  return columns;
}

void MixedCells::take(const Zones& zones) {
  if (!inclusions_) return;
  zones_ = zones;
  cells_.assign(zones.cells(), nullptr);
  numbers_.clear();
  const Box solved = box();
  for (std::size_t n = 0; n < cells_.size(); ++n) {
    const auto [i, j, k] = zones.cell(n);
    // Beyond the grid the eigenstrain stays as it is.
    if (i < solved.i0 || i >= solved.i0 + solved.nx) continue;
    cells_[n] = inclusions_->at(i, j, k, first_, setup_.grid.period);
    if (cells_[n] != nullptr) numbers_.push_back(static_cast<std::uint32_t>(n));
  }
  plastic_ = before_.own ? before_.own->strain(zones) : Field{};
  const auto& of_matrix = before_.of_matrix;
  matrix_plastic_ = of_matrix ? of_matrix->strain(zones) : Field{};
  inclusion_equivalent_ = of_matrix ? of_matrix->equivalent(zones) : Field{};
}

plasticity::MixedReturn MixedCells::step(std::uint32_t cell, const plasticity::Tensor& stress,
                                         const plasticity::Tensor& eigenstrain,
                                         plasticity::MixedHistory before) const {
  const auto strain = [&](const Field& field) -> plasticity::Tensor {
    if (field.empty()) return {};
    const std::size_t cells = zones_.cells();
    const double* e = field.data() + cell;
    return {e[0], e[cells], -(e[0] + e[cells]), e[2 * cells], e[3 * cells], e[4 * cells]};
  };
  before.plastic = strain(plastic_);
  before.matrix_plastic = strain(matrix_plastic_);
  if (!inclusion_equivalent_.empty()) before.inclusion_equivalent = inclusion_equivalent_[cell];
  const plasticity::MixedCell& mixed = *cells_[cell];
  const plasticity::Material* const material = inclusions_->material(mixed);
  if (rise_.values.empty() || mixed.expansion == 0) {
    return law_of(cell).step(mixed, material, stress, eigenstrain, before);
  }
  const auto [i, j, k] = zones_.cell(cell);
  plasticity::MixedCell warm = mixed;
  for (int c = 0; c < 3; ++c) warm.misfit[c] += mixed.expansion * rise_.at(i, j, k);
  return law_of(cell).step(warm, material, stress, eigenstrain, before);
}

const plasticity::MixedLaw& MixedCells::law_of(std::uint32_t cell) const {
  if (!matrix_.is_layered()) return laws_.front();
  return laws_[matrix_.number_at((zones_.cell(cell).k + 0.5) * setup_.grid.dz)];
}

void MixedCells::flow(std::uint32_t cell, const plasticity::MixedReturn& step) {
  const std::size_t cells = zones_.cells();
  const auto add_strain = [&](const plasticity::Tensor& increment, Field& field) {
    field.resize(5 * cells, 0.0);
    std::size_t at = cell;
    for (const int c : operators::components(Tensor::deviator)) {
      field[at] += increment[c];
      at += cells;
    }
  };
  // A history without strain would have no zones.
  const auto flows = [](const plasticity::Tensor& increment) {
    return std::ranges::any_of(increment, [](double part) { return part != 0; });
  };
  if (flows(step.plastic)) {
    add_strain(step.plastic, plastic_);
    flowed_ = true;
  }
  if (!cells_[cell]->has_two_phases()) return;
  if (!flows(step.matrix_plastic) && step.inclusion_equivalent == 0) return;
  add_strain(step.matrix_plastic, matrix_plastic_);
  inclusion_equivalent_.resize(cells, 0.0);
  inclusion_equivalent_[cell] += step.inclusion_equivalent;
  matrix_flowed_ = true;
}

MixedCells::Flows MixedCells::finish() const {
  const Box box = from_planes_on(zones_.around(), setup_.grid, symmetry_);
  const auto history = [&](const PlasticState* before, const Field& strain, Field equivalent) {
    const PlasticFields fields{zones_, strain, std::move(equivalent), {}};
    return std::make_shared<const PlasticState>(before, symmetry_, Tensor::deviator, fields, box,
                                                Lattice{{}, setup_.grid.period.x});
  };
  Flows after = before_;
  if (flowed_) after.own = history(before_.own.get(), plastic_, Field(zones_.cells(), 0.0));
  if (matrix_flowed_) {
    after.of_matrix =
        history(before_.of_matrix.get(), matrix_plastic_, Field(inclusion_equivalent_));
  }
  return after;
}

}  // namespace samcontact::simulation
