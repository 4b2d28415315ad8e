// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/sources/eigenstrain.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "samcontact/base/deviator.hpp"
#include "samcontact/simulation/cells/box_choice.hpp"
#include "samcontact/simulation/cells/zone_choice.hpp"

namespace samcontact::simulation {
namespace {

using operators::Tensor;

/// Components of a tensor, from all six of a stress.
Field components_of(const Field& stress, Tensor tensor) {
  if (tensor == Tensor::full) return stress;
  const std::size_t cells = stress.size() / 6;
  Field out;
  out.reserve(5 * cells);
  for (const int c : operators::components(tensor)) {
    for (std::size_t n = 0; n < cells; ++n) {
      const double mean = (stress[n] + stress[cells + n] + stress[2 * cells + n]) / 3;
      out.push_back(stress[c * cells + n] - (c < 3 ? mean : 0.0));
    }
  }
  return out;
}

/// Box of all cells of a region whose stress [6][k][i][j] exceeds the limits of its layers.
Box cells_beyond(const Field& stress, const Box& region, const std::vector<LayerLimit>& limits) {
  const Field s = components_of(stress, Tensor::deviator);
  const std::size_t cells = region.volume_size();
  Box found;
  std::size_t n = 0;
  for (int k = 0; k < region.nz; ++k) {
    const double bound = limits[k].stress * limits[k].stress / 3;
    for (int i = region.i0; i < region.i0 + region.nx; ++i) {
      for (int j = region.j0; j < region.j0 + region.ny; ++j, ++n) {
        const double second = second_invariant(s[n], s[cells + n], s[2 * cells + n],
                                               s[3 * cells + n], s[4 * cells + n]);
        if (second > bound) found = found.united({i, j, 1, 1, k + 1});
      }
    }
  }
  return found;
}

/// Whether a box reaches the end of a region, other than at the ends of the grid.
bool reaches_end(const Box& box, const Box& region, const Grid& grid) {
  const int i1 = region.i0 + region.nx, j1 = region.j0 + region.ny;
  return (box.i0 == region.i0 && region.i0 > 0) || (box.j0 == region.j0 && region.j0 > 0) ||
         (box.i0 + box.nx == i1 && i1 < grid.nx) || (box.j0 + box.ny == j1 && j1 < grid.ny) ||
         (box.nz == region.nz && (grid.nz == 0 || region.nz < grid.nz));
}

}  // namespace

std::shared_ptr<const PlasticState> sum_of(const std::shared_ptr<const PlasticState>& before,
                                           const Box& box, int k0, const Field& strain,
                                           const Grid& grid) {
  Box down = box;
  down.nz += k0;
  const Zones zones({down});
  const std::size_t cells = down.volume_size(), given = box.volume_size();
  Field sum = before ? before->strain(zones) : Field(6 * cells, 0.0);
  for (std::size_t c = 0; c < 6; ++c) {
    double* to = sum.data() + c * cells + k0 * box.surface_size();
    for (std::size_t n = 0; n < given; ++n) to[n] += strain[c * given + n];
  }
  const auto found = std::make_shared<const PlasticState>(
      before.get(), fft::Symmetry::none, Tensor::full,
      PlasticFields{zones, std::move(sum), Field(cells, 0.0), {}}, Box{},
      Lattice{{}, grid.period.x});
  return found->zones().empty() ? nullptr : found;
}

void require_followed(const Eigenstrains& strains, const Setup& setup, const Travel& travel) {
  if (setup.followed() >= 0) return;
  for (int b = 0; b < 2; ++b) {
    const bool follows = setup.friction.sticks() ? travel.x[0] == travel.x[1]
                                                 : travel.x[b] == std::round(travel.x[b]);
    if (!strains[b] || follows) continue;
    throw std::invalid_argument(
        "a body with an eigenstrain must advance by whole cells (under partial slip, both bodies "
        "by equal distances) if no body is elastic-plastic or has a relief: change advance, or "
        "set a relief of zeros for body " +
        std::to_string(b + 1));
  }
}

void Eigenstrain::displace(int body, Field& sum) const {
  if (!acts_on(body)) return;
  Field& own = displacement_[body];
  if (own.empty()) {
    own =
        displacement_of(*strains_[body], setup_, body, method_, operators::Axis::z, offsets_[body]);
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += own[i];
}

void Eigenstrain::stress(int body, const Box& box, Tensor tensor, Field& sum) const {
  if (!acts_on(body)) return;
  add_to(sum, components_of(stress_of(*strains_[body], setup_, body, method_, box), tensor));
}

Box Eigenstrain::box_beyond(int body, const Strength& strength, double softening,
                            double share) const {
  if (!acts_on(body)) return {};
  const Grid& grid = setup_.grid;
  Box window{0, 0, grid.nx, grid.ny, grid.nz};
  const Box own = strains_[body]->zones().around();
  for (int margin = std::max({own.nx, own.ny, own.nz}) / 2 + 1;; margin *= 2) {
    Box region = widened(own, margin);
    if (grid.nz == 0) window.nz = region.nz;
    region = region.intersected(window);
    if (region.empty()) return {};
    std::vector<LayerRange> layers;
    layers.reserve(region.nz);
    for (int k = 0; k < region.nz; ++k) layers.push_back({k, k, k + 1});
    const Box found = cells_beyond(stress_of(*strains_[body], setup_, body, method_, region),
                                   region, strength.limits(layers, softening, share, share));
    if (!reaches_end(found, region, grid) || is_unbounded(region, grid)) return found;
  }
}

}  // namespace samcontact::simulation
