// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include "samcontact/base/magnitude.hpp"
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

/// Six consecutive cells, each the first of n cells of the other direction.
using SixCells = std::array<const double*, 6>;

/// Number of steps between the third and the fourth of six cells.
int count_steps(const SixCells& h, int n, double ratio) {
  int count = 0;  // without a branch, for vector instructions
  for (int i = 0; i < n; ++i) {
    const double before = h[1][i] - h[0][i], into = h[2][i] - h[1][i], rise = h[3][i] - h[2][i],
                 out = h[4][i] - h[3][i], after = h[5][i] - h[4][i];
    const double bends = std::max(std::fabs(into - before), std::fabs(after - out));
    const double height = std::fabs(rise - 0.5 * (into + out));
    count += static_cast<int>(height > std::max(std::fabs(out - into), ratio * bends));
  }
  return count;
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

bool may_have_steps(std::span<const double> heights, const Cells& cells, double ratio) {
  if (!magnitude_of(heights).is_finite) return true;
  constexpr int more = std::tuple_size_v<SixCells> - 1;
  const auto row = [&](int i) {
    return heights.data() + static_cast<std::ptrdiff_t>(i % cells.nx) * cells.ny;
  };
  for (int i = 0; i < cells.nx - (cells.along_x ? 0 : more); ++i) {
    if (count_steps({row(i), row(i + 1), row(i + 2), row(i + 3), row(i + 4), row(i + 5)}, cells.ny,
                    ratio) > 0)
      return true;
  }
  std::vector<double> line;
  for (int i = 0; i < cells.nx; ++i) {
    const double* h = row(i);
    if (cells.along_y) {  // few cells are repeated after the end of the period
      line.assign(h, h + cells.ny);
      for (int j = 0; j < more; ++j) line.push_back(line[j]);
      h = line.data();
    }
    const int count = cells.ny - (cells.along_y ? 0 : more);
    if (count_steps({h, h + 1, h + 2, h + 3, h + 4, h + 5}, count, ratio) > 0) return true;
  }
  return false;
}

}  // namespace samcontact::contact
