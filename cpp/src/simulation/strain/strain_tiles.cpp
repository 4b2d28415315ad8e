// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/strain/strain_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace samcontact::simulation {

using operators::Tensor;

namespace {

bool is_zero(const double* values, std::size_t n) {
  return std::all_of(values, values + n, [](double v) { return v == 0; });
}

/// Part of a box, from the surface down, outside of which all its fields are zero.
Box part_in_use(const Field& values, const Box& box) {
  Box used;
  const double* row = values.data();
  for (std::size_t n = 0; n < values.size() / box.ny; ++n, row += box.ny) {
    if (is_zero(row, box.ny)) continue;
    const int i = static_cast<int>(n % box.nx), k = static_cast<int>(n / box.nx % box.nz);
    int j0 = 0, j1 = box.ny;
    while (row[j0] == 0) ++j0;
    while (row[j1 - 1] == 0) --j1;
    used = used.united({box.i0 + i, box.j0 + j0, 1, j1 - j0, k + 1});
  }
  return used;
}

}  // namespace

void StrainTiles::put(const Box& box, const std::vector<const double*>& fields, const Box& inside) {
  for_each_tile(inside, [&](const Tile& tile, const Box& part) {
    const auto found = tiles_.find(tile);
    const Part* before = found == tiles_.end() ? nullptr : found->second.get();
    const Box both = (before != nullptr ? before->box.united(part) : part).from_surface();
    Field values(fields.size() * both.volume_size(), 0.0);
    for (std::size_t p = 0; p < fields.size(); ++p) {
      double* to = values.data() + p * both.volume_size();
      if (before != nullptr) {
        copy_common(before->values.data() + p * before->box.volume_size(), before->box, to, both);
      }
      copy_common(fields[p], box, to, both);
    }
    const Box used = part_in_use(values, both);
    if (used.empty()) {
      tiles_.erase(tile);
      return;
    }
    Field kept(fields.size() * used.volume_size());
    for (std::size_t p = 0; p < fields.size(); ++p) {
      extract(values.data() + p * both.volume_size(), both, kept.data() + p * used.volume_size(),
              used);
    }
    if (before != nullptr && before->box == used && before->values == kept) return;
    tiles_[tile] = finished(used, std::move(kept));
  });
}

void StrainTiles::copy(std::size_t first, std::size_t count, const Box& box, double* to,
                       std::size_t stride) const {
  auto tile = tiles_.lower_bound({tile_of(box.i0), std::numeric_limits<int>::min()});
  for (; tile != tiles_.end() && tile->first.first <= tile_of(box.i0 + box.nx - 1); ++tile) {
    const Part& part = *tile->second;
    for (std::size_t p = 0; p < count; ++p) {
      copy_common(part.values.data() + (first + p) * part.box.volume_size(), part.box,
                  to + p * stride, box);
    }
  }
}

std::shared_ptr<const StrainTiles::Part> StrainTiles::finished(const Box& box, Field values) const {
  auto part = std::make_shared<Part>();
  const std::size_t cells = box.volume_size();
  const double* e = values.data();
  const double* g = e + strain_parts() * cells;
  part->max_equivalent = *std::max_element(g, g + cells);
  double largest = 0.0;
  const bool full = tensor_ == Tensor::full;
  for (std::size_t n = 0; n < cells; ++n) {
    const double xx = e[n], yy = e[cells + n], zz = full ? e[2 * cells + n] : -(xx + yy);
    const double* shear = e + (full ? 3 : 2) * cells + n;
    const double yz = shear[0], xz = shear[cells], xy = shear[2 * cells];
    largest = std::max(largest, xx * xx + yy * yy + zz * zz + 2 * (yz * yz + xz * xz + xy * xy));
  }
  part->max_strain = std::sqrt(2.0 / 3 * largest);
  part->box = box;
  part->values = std::move(values);
  return part;
}

int StrainTiles::first_layer() const {
  int first = std::numeric_limits<int>::max();
  for (const auto& [tile, part] : tiles_) {
    const Box& box = part->box;
    const std::size_t plane = box.surface_size(), fields = part->values.size() / box.volume_size();
    const double* values = part->values.data();
    const auto is_empty = [&](int k) {
      for (std::size_t p = 0; p < fields; ++p) {
        if (!is_zero(values + (p * box.layers() + k) * plane, plane)) return false;
      }
      return true;
    };
    int k = 0;
    while (k < box.layers() && is_empty(k)) ++k;
    first = std::min(first, box.k0 + k);
  }
  return first;
}

double StrainTiles::max_equivalent() const {
  double largest = 0.0;
  for (const auto& [tile, part] : tiles_) largest = std::max(largest, part->max_equivalent);
  return largest;
}

std::size_t StrainTiles::yielded_cells() const {
  std::size_t count = 0;
  for (const auto& [tile, part] : tiles_) {
    const auto cells = static_cast<std::ptrdiff_t>(part->box.volume_size());
    const auto first = part->values.begin() + strain_parts() * cells;
    count += std::count_if(first, first + cells, [](double g) { return g > 0; });
  }
  return count;
}

double StrainTiles::max_strain() const {
  double largest = 0.0;
  for (const auto& [tile, part] : tiles_) largest = std::max(largest, part->max_strain);
  return largest;
}

std::size_t StrainTiles::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [tile, part] : tiles_) bytes += part->values.size() * sizeof(double);
  return bytes;
}

}  // namespace samcontact::simulation
