// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/outline.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {

namespace {

/// Line of n cells, `stride` apart.
struct Line {
  const double* first;
  int n;
  std::ptrdiff_t stride;

  double operator[](int i) const { return first[i * stride]; }
};

/// Adds the side between cell i and the next one (after the last cell, the first).
void add_side(const Line& p, int i, double rise, Outline& found) {
  const int next = i + 1 < p.n ? i + 1 : 0;
  if (in_contact(p[i]) == in_contact(p[next])) return;
  ++found.sides;
  const bool ascends = in_contact(p[next]);
  const int own = ascends ? next : i;
  const int inner = ascends ? (next + 1) % p.n : (i + p.n - 1) % p.n;
  found.rises |= in_contact(p[inner]) && p[own] > rise * p[inner];
}

void add_line(const Line& p, bool periodic, double rise, Outline& found) {
  for (int i = 0; i + 1 < p.n; ++i) add_side(p, i, rise, found);
  if (periodic && p.n > 1) add_side(p, p.n - 1, rise, found);
}

/// Smaller distance from a cell in contact to the two ends of its run of cells in contact.
int reach(const Line& p, int at) {
  int before = at, behind = at;
  while (before > 0 && in_contact(p[before - 1])) --before;
  while (behind + 1 < p.n && in_contact(p[behind + 1])) ++behind;
  return std::min(at - before, behind - at + 1);
}

}  // namespace

Outline outline(std::span<const double> pressure, const Cells& cells, double rise) {
  Outline found;
  const double* p = pressure.data();
  const auto row = [&](int i) {
    return Line{p + static_cast<std::ptrdiff_t>(i) * cells.ny, cells.ny, 1};
  };
  const auto column = [&](int j) { return Line{p + j, cells.nx, cells.ny}; };
  found.cells =
      static_cast<std::size_t>(std::count_if(pressure.begin(), pressure.end(), in_contact));
  if (found.cells == 0) return found;
  for (int i = 0; i < cells.nx; ++i) add_line(row(i), cells.along_y, rise, found);
  for (int j = 0; j < cells.ny; ++j) add_line(column(j), cells.along_x, rise, found);
  const auto peak = std::max_element(pressure.begin(), pressure.end()) - pressure.begin();
  const int i = static_cast<int>(peak / cells.ny), j = static_cast<int>(peak % cells.ny);
  found.largest = *(pressure.begin() + peak);
  found.reach = std::min(reach(column(j), i), reach(row(i), j));
  return found;
}

}  // namespace samcontact::contact
