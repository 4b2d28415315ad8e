// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/plastic_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace samcontact::simulation {

using operators::Tensor;

namespace {

/// One column of a box moved into that of another, [part][k][j]; zero where it was not.
Field fitted(const Field& column, const Box& from, const Box& to, std::size_t parts) {
  Box a = from, b = to;
  a.i0 = b.i0 = 0;
  a.nx = b.nx = 1;
  Field out(parts * b.volume_size(), 0.0);
  for (std::size_t p = 0; p < parts; ++p) {
    copy_common(column.data() + p * a.volume_size(), a, out.data() + p * b.volume_size(), b);
  }
  return out;
}

/// Whether columns of both boxes have the same cells.
bool aligned(const Box& a, const Box& b) { return a.j0 == b.j0 && a.ny == b.ny && a.nz == b.nz; }

}  // namespace

PlasticState::PlasticState(const PlasticState* before, fft::Symmetry symmetry, Tensor tensor,
                           const PlasticFields& fields)
    : box_(before != nullptr ? before->box_.united(fields.box) : fields.box),
      symmetry_(symmetry),
      tensor_(tensor),
      backstress_parts_(static_cast<int>(fields.backstress.size() / fields.box.volume_size())),
      columns_(box_.nx) {
  if (before != nullptr) {
    const bool as_they_are = aligned(before->box_, box_);
    for (int i = 0; i < before->box_.nx; ++i) {
      const auto& column = before->columns_[i];
      auto& place = columns_[before->box_.i0 + i - box_.i0];
      place = as_they_are || !column
                  ? column
                  : finished(fitted(column->values, before->box_, box_, parts()));
    }
  }
  const Box& from = fields.box;
  const std::size_t column_size = static_cast<std::size_t>(box_.nz) * box_.ny;
  for (int i = 0; i < from.nx; ++i) {
    auto& place = columns_[from.i0 + i - box_.i0];
    Field values = place ? place->values : Field(parts() * column_size, 0.0);
    double* to = values.data();
    for (const Field* field : {&fields.strain, &fields.equivalent, &fields.backstress}) {
      for (std::size_t plane = 0; plane < field->size(); plane += from.volume_size()) {
        for (int k = 0; k < from.nz; ++k) {
          std::copy_n(field->data() + plane + (static_cast<std::size_t>(k) * from.nx + i) * from.ny,
                      from.ny, to + static_cast<std::size_t>(k) * box_.ny + from.j0 - box_.j0);
        }
        to += column_size;
      }
    }
    if (!place || place->values != values) place = finished(std::move(values));
  }
}

std::shared_ptr<const PlasticState::Column> PlasticState::finished(Field values) const {
  if (std::all_of(values.begin(), values.end(), [](double v) { return v == 0; })) return nullptr;
  auto column = std::make_shared<Column>();
  const std::size_t cells = static_cast<std::size_t>(box_.nz) * box_.ny;
  const double* e = values.data();
  const double* g = e + strain_parts() * cells;
  column->max_equivalent = *std::max_element(g, g + cells);
  double largest = 0.0;
  const bool full = tensor_ == Tensor::full;
  for (std::size_t n = 0; n < cells; ++n) {
    const double xx = e[n], yy = e[cells + n], zz = full ? e[2 * cells + n] : -(xx + yy);
    const double* shear = e + (full ? 3 : 2) * cells + n;
    const double yz = shear[0], xz = shear[cells], xy = shear[2 * cells];
    largest = std::max(largest, xx * xx + yy * yy + zz * zz + 2 * (yz * yz + xz * xz + xy * xy));
  }
  column->max_strain = std::sqrt(2.0 / 3 * largest);
  column->values = std::move(values);
  return column;
}

Field PlasticState::gather(int first, int count, const Box& box) const {
  Field out(count * box.volume_size(), 0.0);
  const Box common = box_.intersected(box);
  if (common.empty()) return out;
  const std::size_t column_size = static_cast<std::size_t>(box_.nz) * box_.ny;
  for (int i = common.i0; i < common.i0 + common.nx; ++i) {
    const auto& column = columns_[i - box_.i0];
    if (!column) continue;
    for (int c = 0; c < count; ++c) {
      const double* from =
          column->values.data() + (first + c) * column_size + (common.j0 - box_.j0);
      double* to = out.data() + c * box.volume_size() +
                   static_cast<std::size_t>(i - box.i0) * box.ny + (common.j0 - box.j0);
      for (int k = 0; k < common.nz; ++k) {
        std::copy_n(from + static_cast<std::size_t>(k) * box_.ny, common.ny,
                    to + k * box.surface_size());
      }
    }
  }
  return out;
}

Field PlasticState::strain(const Box& box) const { return gather(0, strain_parts(), box); }

Field PlasticState::equivalent(const Box& box) const { return gather(strain_parts(), 1, box); }

Field PlasticState::backstress(const Box& box) const {
  return gather(strain_parts() + 1, backstress_parts_, box);
}

PlasticFields PlasticState::fields(const Box& box) const {
  return {box, strain(box), equivalent(box), backstress(box)};
}

double PlasticState::max_equivalent() const {
  double largest = 0.0;
  for (const auto& column : columns_) {
    if (column) largest = std::max(largest, column->max_equivalent);
  }
  return largest;
}

double PlasticState::max_strain() const {
  double largest = 0.0;
  for (const auto& column : columns_) {
    if (column) largest = std::max(largest, column->max_strain);
  }
  return largest;
}

std::size_t PlasticState::bytes() const {
  std::size_t bytes = 0;
  for (const auto& column : columns_) {
    if (column) bytes += column->values.size() * sizeof(double);
  }
  return bytes;
}

std::shared_ptr<const PlasticState> PlasticState::moved(int cells) const {
  auto out = std::make_shared<PlasticState>(*this);
  out->box_.i0 += cells;
  return out;
}

PlasticState PlasticState::unfolded(const Grid& grid, fft::Symmetry symmetry) const {
  Box whole = whole_box(box_, grid, symmetry_);
  // From the planes that remain on.
  const Box part = stored_part(grid, symmetry);
  if (symmetry != fft::Symmetry::none) {
    whole.ny -= part.j0 - whole.j0;
    whole.j0 = part.j0;
  }
  const PlasticFields had = fields(box_);
  PlasticFields out{whole, Field(strain_parts() * whole.volume_size()), Field(whole.volume_size()),
                    Field(backstress_parts_ * whole.volume_size())};
  const std::size_t from = box_.surface_size(), to = whole.surface_size();
  const auto copy = [&](const Field& old, Field& young, int c, bool odd_x, bool odd_y) {
    for (int k = 0; k < box_.nz; ++k) {
      unfold(old.data() + (c * box_.nz + k) * from, box_, symmetry_, odd_x, odd_y,
             young.data() + (c * box_.nz + k) * to, whole, grid);
    }
  };
  const auto copy_tensors = [&](const Field& old, Field& young, int count, Tensor tensor) {
    const auto places = operators::components(tensor);
    for (int c = 0; c < count; ++c) {
      const int place = places[c % places.size()];
      copy(old, young, c, place == 4 || place == 5, place == 3 || place == 5);
    }
  };
  copy(had.equivalent, out.equivalent, 0, false, false);
  copy_tensors(had.strain, out.strain, strain_parts(), tensor_);
  copy_tensors(had.backstress, out.backstress, backstress_parts_, Tensor::deviator);
  return {nullptr, symmetry, tensor_, out};
}

bool PlasticState::operator==(const PlasticState& other) const {
  if (box_ != other.box_ || symmetry_ != other.symmetry_ || tensor_ != other.tensor_) return false;
  return std::equal(
      columns_.begin(), columns_.end(), other.columns_.begin(),
      [](const auto& a, const auto& b) { return a == b || (a && b && a->values == b->values); });
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
