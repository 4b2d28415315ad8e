// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/body/mixed_cells.hpp"

#include <algorithm>
#include <utility>

#include "samcontact/simulation/cells/mirror.hpp"

namespace samcontact::simulation {

using operators::Tensor;

MixedCells::MixedCells(const Setup& setup, int body, int first, fft::Symmetry symmetry,
                       const std::shared_ptr<const PlasticState>& own)
    : setup_(setup),
      inclusions_(setup.inclusions[body]),
      first_(first),
      symmetry_(symmetry),
      own_(unfolded(own, setup.grid, symmetry)) {
  if (inclusions_) law_.emplace(setup.bodies[body].material(0));
}

Box MixedCells::box() const {
  return inclusions_ ? inclusions_->in_grid(setup_.grid, first_) : Box{};
}

void MixedCells::take(const Zones& zones) {
  if (!inclusions_) return;
  zones_ = zones;
  cells_.assign(zones.cells(), nullptr);
  const Box solved = box();
  for (std::size_t n = 0; n < cells_.size(); ++n) {
    const auto [i, j, k] = zones.cell(n);
    // Beyond the grid the eigenstrain stays as it is.
    if (i < solved.i0 || i >= solved.i0 + solved.nx) continue;
    cells_[n] = inclusions_->at(i, j, k, first_, setup_.grid.period);
  }
  plastic_ = own_ ? own_->strain(zones) : Field{};
}

plasticity::MixedReturn MixedCells::step(std::uint32_t cell, const plasticity::Tensor& stress,
                                         const plasticity::Tensor& eigenstrain,
                                         plasticity::MixedHistory before) const {
  if (!plastic_.empty()) {
    const std::size_t cells = zones_.cells();
    const double* e = plastic_.data() + cell;
    before.plastic = {e[0], e[cells], -(e[0] + e[cells]), e[2 * cells], e[3 * cells], e[4 * cells]};
  }
  const plasticity::MixedCell& mixed = *cells_[cell];
  return law_->step(mixed, inclusions_->material(mixed), stress, eigenstrain, before);
}

void MixedCells::flow(std::uint32_t cell, const plasticity::Tensor& increment) {
  const std::size_t cells = zones_.cells();
  plastic_.resize(5 * cells, 0.0);
  std::size_t at = cell;
  for (const int c : operators::components(Tensor::deviator)) {
    plastic_[at] += increment[c];
    at += cells;
  }
  flowed_ = true;
}

std::shared_ptr<const PlasticState> MixedCells::finish() const {
  if (!flowed_) return own_;
  const PlasticFields fields{zones_, plastic_, Field(zones_.cells(), 0.0), {}};
  const Box box = from_planes_on(zones_.around(), setup_.grid, symmetry_);
  return std::make_shared<const PlasticState>(own_.get(), symmetry_, Tensor::deviator, fields, box,
                                              Lattice{{}, setup_.grid.period.x});
}

}  // namespace samcontact::simulation
