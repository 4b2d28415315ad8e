// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/repeated_cells.hpp"

#include <cstdlib>
#include <utility>

namespace samcontact::operators {
namespace {

Grid nodes_of(const Grid& cells, int step) {
  Grid nodes(cells.period.x / step, cells.period.y / step, step * cells.dx, step * cells.dy);
  nodes.period = {nodes.nx, nodes.ny, 0.0};
  return nodes;
}

/// Acting cells of nodes whose axes may be exchanged.
Grid rotated_if(bool rotated, const Grid& cells) { return rotated ? exchanged(cells) : cells; }

}  // namespace

RepeatedCells::RepeatedCells(SharedMedium medium, const Grid& cells, int step)
    : medium_(std::move(medium)), cells_(cells), nodes_(nodes_of(cells, step)), step_(step) {
  cells_.period = {};
}

CellOffsets RepeatedCells::offsets(int nx, int ny) const {
  CellOffsets at = CellOffsets::lattice(nx, ny);
  for (int& i : at.x) i *= step_;
  for (int& j : at.y) j *= step_;
  return at;
}

Field RepeatedCells::sum(const PeriodicSums::Make& make) const {
  const auto of_nodes = [&](const Grid& own, bool rotated) {
    CellInfluence influence = make(own, rotated);
    for (double& uniform : influence.uniform) uniform /= static_cast<double>(step_) * step_;
    return influence;
  };
  return sums_.sum(nodes_, CellOffsets::lattice(nodes_.nx / 2 + 1, nodes_.ny / 2 + 1), of_nodes,
                   exchanged_components, -1, step_);
}

Field RepeatedCells::stress(Traction traction, double z, Tensor tensor) const {
  const auto make = [&](const Grid&, bool rotated) {
    const Grid cells = rotated_if(rotated, cells_);
    const Traction kind = rotated ? exchanged(traction) : traction;
    CellInfluence influence = medium_->stress_influence(kind, cells, z);
    influence.cell = [this, kind, cells, z](int nx, int ny) {
      return medium_->stress(kind, cells, offsets(nx, ny), z, Tensor::full);
    };
    return influence;
  };
  return selected(sum(make), tensor);
}

Field RepeatedCells::residual_displacement(Axis axis, int layer) const {
  return sum([&](const Grid&, bool rotated) {
    const Grid cells = rotated_if(rotated, cells_);
    const Axis along = rotated ? exchanged(axis) : axis;
    CellInfluence influence = medium_->residual_influence(along, cells, layer);
    influence.cell = [this, along, cells, layer](int nx, int ny) {
      return medium_->residual_displacement(along, cells, offsets(nx, ny), layer);
    };
    return influence;
  });
}

void add_folded(const double* table, int size, kernels::Parity parity, const KernelOffsets& offsets,
                double* to) {
  const int mx = 2 * (offsets.nx - 1), my = 2 * (offsets.ny - 1);
  for (int j = 1 - size; j < size; ++j) {
    const int y = ((j % my) + my) % my;
    if (y >= offsets.ny) continue;
    for (int i = 1 - size; i < size; ++i) {
      const int x = ((i % mx) + mx) % mx;
      if (x >= offsets.nx) continue;
      const bool negative = (parity.odd_x && i < 0) != (parity.odd_y && j < 0);
      const double value = table[static_cast<std::ptrdiff_t>(std::abs(j)) * size + std::abs(i)];
      to[static_cast<std::ptrdiff_t>(y) * offsets.nx + x] += negative ? -value : value;
    }
  }
}

double total(const double* table, int nx, int ny, bool half_of_period) {
  const auto times = [half_of_period](int n, int count) {
    return n == 0 || (half_of_period && n == count - 1) ? 1.0 : 2.0;
  };
  double sum = 0.0;
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) sum += times(i, nx) * times(j, ny) * *table++;
  }
  return sum;
}

}  // namespace samcontact::operators
