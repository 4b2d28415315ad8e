// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/strain/plastic_state.hpp"

#include <algorithm>
#include <utility>

namespace samcontact::simulation {

using operators::Tensor;

namespace {

/// Mirror image of cells on one side of a mirror plane, without those in the plane.
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
      origin_(before != nullptr ? before->origin_ : origin),
      tiles_(tensor) {
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
    tiles_.put(of_body(fields.zones.boxes()[zone]), of_zone);
  }
}

Zones PlasticState::zones() const {
  std::vector<Box> boxes;
  boxes.reserve(tiles_.tiles().size());
  for (const auto& [tile, part] : tiles_.tiles()) boxes.push_back(of_grid(part->box));
  return Zones(std::move(boxes));
}

Field PlasticState::gather(std::size_t first, std::size_t count, const Zones& zones) const {
  const std::size_t cells = zones.cells();
  Field out(count * cells, 0.0);
  if (out.empty()) return out;
  for (std::size_t zone = 0; zone < zones.count(); ++zone) {
    tiles_.copy(first, count, of_body(zones.boxes()[zone]), out.data() + zones.first(zone), cells);
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
  for (const auto& [tile, part] : tiles_.tiles()) {
    const Zones own({of_grid(part->box)});
    const std::size_t cells = own.cells();
    Box beyond;
    for (std::size_t n = 0; n < cells; ++n) {
      const Cell cell = own.cell(n);
      if (zones.number(cell) >= 0) continue;
      bool strained = false;
      for (std::size_t p = 0; p < strain_parts(); ++p) {
        strained = strained || part->values[p * cells + n] != 0;
      }
      if (strained) beyond = beyond.united({cell.i, cell.j, 1, 1, cell.k + 1});
    }
    if (!beyond.empty()) found.push_back(beyond);
  }
  return found;
}

std::shared_ptr<const PlasticState> PlasticState::moved(int along_x, int along_y) const {
  auto out = std::make_shared<PlasticState>(*this);
  out->box_ = box_.moved(along_x, along_y);
  out->origin_ = {origin_[0] + along_x, origin_[1] + along_y};
  return out;
}

PlasticState PlasticState::unfolded(const Grid& grid, fft::Symmetry symmetry) const {
  Box whole = whole_box(box_, grid, symmetry_);
  // On one side of the remaining planes.
  const Box stored = stored_part(grid, symmetry);
  if (symmetry != fft::Symmetry::none) {
    whole.ny -= stored.j0 - whole.j0;
    whole.j0 = stored.j0;
  }
  PlasticState out(this, symmetry, tensor_, {}, whole);
  const bool across_x = symmetry_ == fft::Symmetry::xy, across_y = symmetry == fft::Symmetry::none;
  for (const auto& [tile, part] : tiles_.tiles()) {
    if (across_x) out.put_image(*part, true, false, grid);
    if (across_y) out.put_image(*part, false, true, grid);
    if (across_x && across_y) out.put_image(*part, true, true, grid);
  }
  return out;
}

void PlasticState::put_image(const StrainTiles::Part& part, bool across_x, bool across_y,
                             const Grid& grid) {
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
  tiles_.put(of_body(image), fields);
}

bool PlasticState::operator==(const PlasticState& other) const {
  if (box_ != other.box_ || symmetry_ != other.symmetry_ || tensor_ != other.tensor_ ||
      backstress_parts_ != other.backstress_parts_) {
    return false;
  }
  if (origin_ == other.origin_ && tiles_.tiles() == other.tiles_.tiles()) return true;
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
