// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/strain/plastic_state.hpp"

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

/// The part of a box outside of which all its fields are zero; from the surface down.
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

/// Cells from a mirror plane on, seen in it, but for those in the plane.
void reflect(int cells, int& begin, int& count) {
  const int end = cells - begin;
  begin = end - count;
  count = std::min(end, cells / 2) - begin;
}

}  // namespace

PlasticState::PlasticState(const PlasticState* before, fft::Symmetry symmetry, Tensor tensor,
                           const PlasticFields& fields, const Box& around, Origin origin)
    : box_(fields.zones.around().united(around)),
      symmetry_(symmetry),
      tensor_(tensor),
      origin_(before != nullptr ? before->origin_ : origin) {
  const std::size_t cells = fields.zones.cells();
  if (cells > 0) backstress_parts_ = fields.backstress.size() / cells;
  if (before != nullptr) {
    box_ = before->box_.united(box_);
    tiles_ = before->tiles_;
    backstress_parts_ = before->backstress_parts_;
  }
  for (std::size_t zone = 0; zone < fields.zones.count(); ++zone) {
    std::vector<const double*> of_zone;
    for (const Field* field : {&fields.strain, &fields.equivalent, &fields.backstress}) {
      for (std::size_t n = fields.zones.first(zone); n < field->size(); n += cells) {
        of_zone.push_back(field->data() + n);
      }
    }
    put(of_body(fields.zones.boxes()[zone]), of_zone);
  }
}

void PlasticState::put(const Box& box, const std::vector<const double*>& fields) {
  for_each_tile(box, [&](const Tile& tile, const Box& part) {
    const auto found = tiles_.find(tile);
    const Part* before = found == tiles_.end() ? nullptr : found->second.get();
    const Box both = before != nullptr ? before->box.united(part) : part;
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

std::shared_ptr<const PlasticState::Part> PlasticState::finished(const Box& box,
                                                                 Field values) const {
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

Zones PlasticState::zones() const {
  std::vector<Box> boxes;
  boxes.reserve(tiles_.size());
  for (const auto& [tile, part] : tiles_) boxes.push_back(of_grid(part->box));
  return Zones(std::move(boxes));
}

Field PlasticState::gather(std::size_t first, std::size_t count, const Zones& zones) const {
  const std::size_t cells = zones.cells();
  Field out(count * cells, 0.0);
  for (std::size_t zone = 0; zone < zones.count(); ++zone) {
    const Box box = of_body(zones.boxes()[zone]);
    auto tile = tiles_.lower_bound({tile_of(box.i0), std::numeric_limits<int>::min()});
    for (; tile != tiles_.end() && tile->first.first <= tile_of(box.i0 + box.nx - 1); ++tile) {
      const Part& part = *tile->second;
      for (std::size_t p = 0; p < count; ++p) {
        copy_common(part.values.data() + (first + p) * part.box.volume_size(), part.box,
                    out.data() + p * cells + zones.first(zone), box);
      }
    }
  }
  return out;
}

Field PlasticState::strain(const Zones& zones) const { return gather(0, strain_parts(), zones); }

Field PlasticState::equivalent(const Zones& zones) const {
  return gather(strain_parts(), 1, zones);
}

Field PlasticState::backstress(const Zones& zones) const {
  return gather(strain_parts() + 1, backstress_parts_, zones);
}

PlasticFields PlasticState::fields(Zones zones) const {
  Field e = strain(zones), g = equivalent(zones), x = backstress(zones);
  return {std::move(zones), std::move(e), std::move(g), std::move(x)};
}

std::vector<Box> PlasticState::boxes_beyond(const Zones& zones) const {
  std::vector<Box> found;
  for (const auto& [tile, part] : tiles_) {
    const Zones own({of_grid(part->box)});
    const std::size_t cells = own.cells();
    Box beyond;
    for (std::size_t n = 0; n < cells; ++n) {
      const Cell cell = own.cell(n);
      if (zones.number(cell) >= 0) continue;
      bool strained = false;
      for (int p = 0; p < strain_parts(); ++p) {
        strained = strained || part->values[p * cells + n] != 0;
      }
      if (strained) beyond = beyond.united({cell.i, cell.j, 1, 1, cell.k + 1});
    }
    if (!beyond.empty()) found.push_back(beyond);
  }
  return found;
}

double PlasticState::max_equivalent() const {
  double largest = 0.0;
  for (const auto& [tile, part] : tiles_) largest = std::max(largest, part->max_equivalent);
  return largest;
}

std::size_t PlasticState::yielded_cells() const {
  std::size_t count = 0;
  for (const auto& [tile, part] : tiles_) {
    const auto cells = static_cast<std::ptrdiff_t>(part->box.volume_size());
    const auto first = part->values.begin() + strain_parts() * cells;
    count += std::count_if(first, first + cells, [](double g) { return g > 0; });
  }
  return count;
}

double PlasticState::max_strain() const {
  double largest = 0.0;
  for (const auto& [tile, part] : tiles_) largest = std::max(largest, part->max_strain);
  return largest;
}

std::size_t PlasticState::bytes() const {
  std::size_t bytes = 0;
  for (const auto& [tile, part] : tiles_) bytes += part->values.size() * sizeof(double);
  return bytes;
}

std::shared_ptr<const PlasticState> PlasticState::moved(int along_x, int along_y) const {
  auto out = std::make_shared<PlasticState>(*this);
  out->box_ = box_.moved(along_x, along_y);
  out->origin_ = {origin_[0] + along_x, origin_[1] + along_y};
  return out;
}

PlasticState PlasticState::unfolded(const Grid& grid, fft::Symmetry symmetry) const {
  Box whole = whole_box(box_, grid, symmetry_);
  // From the planes that remain on.
  const Box stored = stored_part(grid, symmetry);
  if (symmetry != fft::Symmetry::none) {
    whole.ny -= stored.j0 - whole.j0;
    whole.j0 = stored.j0;
  }
  PlasticState out(this, symmetry, tensor_, {}, whole);
  const bool across_x = symmetry_ == fft::Symmetry::xy, across_y = symmetry == fft::Symmetry::none;
  for (const auto& [tile, part] : tiles_) {
    if (across_x) out.put_image(*part, true, false, grid);
    if (across_y) out.put_image(*part, false, true, grid);
    if (across_x && across_y) out.put_image(*part, true, true, grid);
  }
  return out;
}

void PlasticState::put_image(const Part& part, bool across_x, bool across_y, const Grid& grid) {
  const Box from = of_grid(part.box);
  Box image = from;
  if (across_x) reflect(grid.nx, image.i0, image.nx);
  if (across_y) reflect(grid.ny, image.j0, image.ny);
  if (image.empty()) return;
  std::vector<int> places(operators::components(tensor_).begin(),
                          operators::components(tensor_).end());
  places.push_back(0);
  const auto deviator = operators::components(Tensor::deviator);
  for (std::size_t p = places.size(); p < parts(); ++p) {
    places.push_back(deviator[(p - strain_parts() - 1) % deviator.size()]);
  }
  Field values;
  values.reserve(parts() * image.volume_size());
  std::vector<const double*> fields;
  for (std::size_t p = 0; p < parts(); ++p) {
    const bool odd_x = across_x && (places[p] == 4 || places[p] == 5);
    const bool odd_y = across_y && (places[p] == 3 || places[p] == 5);
    const double sign = odd_x != odd_y ? -1.0 : 1.0;
    fields.push_back(values.data() + values.size());
    for (int k = 0; k < image.nz; ++k) {
      for (int i = image.i0; i < image.i0 + image.nx; ++i) {
        const int si = (across_x ? grid.nx - 1 - i : i) - from.i0;
        const double* row = part.values.data() + p * from.volume_size() +
                            (static_cast<std::size_t>(k) * from.nx + si) * from.ny;
        for (int j = image.j0; j < image.j0 + image.ny; ++j) {
          values.push_back(sign * row[(across_y ? grid.ny - 1 - j : j) - from.j0]);
        }
      }
    }
  }
  put(of_body(image), fields);
}

bool PlasticState::operator==(const PlasticState& other) const {
  if (box_ != other.box_ || symmetry_ != other.symmetry_ || tensor_ != other.tensor_ ||
      backstress_parts_ != other.backstress_parts_) {
    return false;
  }
  if (origin_ == other.origin_ && tiles_ == other.tiles_) return true;
  const auto holds = [](const PlasticState& a, const PlasticState& b) {
    const Zones zones = a.zones();
    return a.gather(0, a.parts(), zones) == b.gather(0, a.parts(), zones);
  };
  return holds(*this, other) && holds(other, *this);
}

bool same(const std::shared_ptr<const PlasticState>& a,
          const std::shared_ptr<const PlasticState>& b) {
  return a == b || (a && b && *a == *b);
}

std::shared_ptr<const PlasticState> unfolded(const std::shared_ptr<const PlasticState>& history,
                                             const Grid& grid, fft::Symmetry symmetry) {
  if (!history || history->symmetry() == symmetry) return history;
  return std::make_shared<const PlasticState>(history->unfolded(grid, symmetry));
}

}  // namespace samcontact::simulation
