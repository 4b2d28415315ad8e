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

int within(int n, int period) { return (n % period + period) % period; }

}  // namespace

std::vector<Box> Lattice::of_body(const Box& box) const {
  const Box first = box.moved(-origin[0], -origin[1]);
  if (period == 0) return {first};
  std::vector<Box> found;
  for (int i0 = within(first.i0, period) - (first.nx + period - 1) / period * period; i0 < period;
       i0 += period) {
    if (i0 + first.nx > 0) found.push_back(first.moved(i0 - first.i0, 0));
  }
  return found;
}

std::vector<Box> Lattice::of_grid(const Box& box) const {
  Box first = box.moved(origin[0], origin[1]);
  if (period == 0) return {first};
  first.i0 = within(first.i0, period);
  const int beyond = std::max(first.i0 + first.nx - period, 0);
  if (beyond == 0) return {first};
  first.nx -= beyond;
  return {first, {0, first.j0, beyond, first.ny, first.nz}};
}

PlasticState::PlasticState(const PlasticState* before, fft::Symmetry symmetry, Tensor tensor,
                           const PlasticFields& fields, const Box& around, const Lattice& lattice)
    : box_(fields.zones.around().united(around).from_surface()),
      symmetry_(symmetry),
      tensor_(tensor),
      lattice_(before != nullptr ? before->lattice_ : lattice),
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
    put(fields.zones.boxes()[zone], of_zone);
  }
}

void PlasticState::put(const Box& box, const std::vector<const double*>& fields) {
  for (const Box& part : lattice_.of_body(box)) {
    Box inside = part;
    if (lattice_.period > 0) {
      inside = part.intersected({0, part.j0, lattice_.period, part.ny, part.nz});
    }
    tiles_.put(part, fields, inside);
  }
}

Zones PlasticState::zones() const {
  std::vector<Box> boxes;
  boxes.reserve(tiles_.tiles().size());
  for (const auto& [tile, part] : tiles_.tiles()) {
    for (const Box& box : lattice_.of_grid(part->box)) boxes.push_back(box);
  }
  return Zones(std::move(boxes));
}

Field PlasticState::gather(std::size_t first, std::size_t count, const Zones& zones) const {
  const std::size_t cells = zones.cells();
  Field out(count * cells, 0.0);
  if (out.empty()) return out;
  for (std::size_t zone = 0; zone < zones.count(); ++zone) {
    for (const Box& box : lattice_.of_body(zones.boxes()[zone])) {
      tiles_.copy(first, count, box, out.data() + zones.first(zone), cells);
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
  const Zones all = this->zones();
  for (const Box& box : all.boxes()) {
    const Zones own({box});
    const std::size_t cells = own.cells();
    const Field strain = this->strain(own);
    Box beyond;
    for (std::size_t n = 0; n < cells; ++n) {
      const Cell cell = own.cell(n);
      if (zones.number(cell) >= 0) continue;
      bool strained = false;
      for (std::size_t p = 0; p < strain_parts(); ++p) {
        strained = strained || strain[p * cells + n] != 0;
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
  out->lattice_.origin = {lattice_.origin[0] + along_x, lattice_.origin[1] + along_y};
  if (const int period = lattice_.period; period > 0) {
    out->lattice_.origin[0] = within(out->lattice_.origin[0], period);
    Box& box = out->box_;
    box.i0 = within(box.i0, period);
    if (box.i0 + box.nx > period) box = {0, box.j0, period, box.ny, box.nz};
  }
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
  const Zones all = zones();
  for (const Box& box : all.boxes()) {
    const Field values = gather(0, parts(), Zones({box}));
    if (across_x) out.put_image(box, values, true, false, grid);
    if (across_y) out.put_image(box, values, false, true, grid);
    if (across_x && across_y) out.put_image(box, values, true, true, grid);
  }
  return out;
}

void PlasticState::put_image(const Box& from, const Field& of_part, bool across_x, bool across_y,
                             const Grid& grid) {
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
        const double* row = of_part.data() + p * from.volume_size() +
                            (static_cast<std::size_t>(k) * from.nx + si) * from.ny;
        for (int j = image.j0; j < image.j0 + image.ny; ++j) {
          values.push_back(sign * row[(across_y ? grid.ny - 1 - j : j) - from.j0]);
        }
      }
    }
  }
  put(image, fields);
}

bool PlasticState::operator==(const PlasticState& other) const {
  if (box_ != other.box_ || symmetry_ != other.symmetry_ || tensor_ != other.tensor_ ||
      backstress_parts_ != other.backstress_parts_) {
    return false;
  }
  if (lattice_ == other.lattice_ && tiles_.tiles() == other.tiles_.tiles()) return true;
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
