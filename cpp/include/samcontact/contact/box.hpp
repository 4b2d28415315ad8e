// SPDX-License-Identifier: GPL-3.0-or-later
// A rectangle of cells of a grid: contact often fills a small part of it.
#pragma once

#include "samcontact/base/aligned.hpp"

namespace samcontact::contact {

/// Cells i0 <= i < i0 + nx, j0 <= j < j0 + ny.
struct Box {
  int i0, j0, nx, ny;

  bool contains(const Box& other) const;
  bool operator==(const Box&) const = default;
};

/// The smallest box around the cells with pressure or penetration of an nx x ny grid; the whole
/// grid if there are none.
Box possible_contact(int nx, int ny, const Field& pressure, const Field& gap);

/// The box with a margin for contact that moves, its sides multiples of 8 so that few different
/// sizes occur, and with `present` in it; the whole grid where a box saves little.
Box with_margin(int nx, int ny, const Box& box, const Box& present);

/// The part of a field of rows of ny cells that lies in the box.
Field extract(const Box& box, const Field& field, int ny);
/// A field of the given size: the part in the box, zero elsewhere.
Field embed(const Box& box, const Field& part, int ny, std::size_t size);

}  // namespace samcontact::contact
