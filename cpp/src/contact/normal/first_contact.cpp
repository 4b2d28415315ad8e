// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/first_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {
namespace {

/// Gaps that differ by less than this fraction of the approach count as equal.
constexpr double same_gap = 1e-6;

/// Newly contacting cells in the order of increasing gap.
std::vector<std::size_t> new_cells(const Growth& growth) {
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < growth.gap.size(); ++i) {
    const bool touches = in_contact(growth.pressure[i]) && !in_contact(growth.before[i]);
    if (touches && growth.gap[i] > 0) cells.push_back(i);
  }
  std::stable_sort(cells.begin(), cells.end(),
                   [&](std::size_t a, std::size_t b) { return growth.gap[a] < growth.gap[b]; });
  return cells;
}

/// For each new cell, the previous number of cells in contact over the number when the contact
/// reaches this cell. The gaps of mirror images differ by rounding: such cells are reached
/// together.
std::vector<double> touching_fraction(const Growth& growth, const std::vector<std::size_t>& cells) {
  const auto before =
      static_cast<double>(std::count_if(growth.before.begin(), growth.before.end(), in_contact));
  std::vector<double> shares;
  while (shares.size() < cells.size()) {
    const std::size_t first = shares.size();
    const double max_gap = growth.gap[cells[first]] + same_gap * growth.closer;
    std::size_t last = first + 1;
    while (last < cells.size() && growth.gap[cells[last]] <= max_gap) ++last;
    const double reached = before + 0.5 * static_cast<double>(first + last);
    shares.resize(last, before / reached);
  }
  return shares;
}

/// For a round contact whose radius grows from a fraction of r to r, under shear proportional to
/// the new pressure: the dependence on the angle of the tangential displacement at r, over the
/// closed gap; 1/4 for growth from zero, 1/2 at the edge. Integrals of a sqrt(r^2 - a^2)/(pi r^2)
/// and of 1 - 2/pi asin(a/r) over a da, from Boussinesq's and Cerruti's solutions.
double slid_by_angle(double share) {
  if (share > 0.999) return 0.5;
  constexpr double pi = std::numbers::pi;
  const double square = share * share, root = std::sqrt(1 - square), angle = std::asin(share);
  const double closed =
      1 - square - 2 / pi * (pi / 4 - (square - 0.5) * angle - 0.5 * share * root);
  const double slid = (pi / 2 - angle + share * root * (1 - 2 * square)) / (4 * pi);
  return slid / closed;
}

/// Normal of the contact edge that reaches a cell: the direction in which its gap opens.
std::array<double, 2> edge_normal(const Grid& grid, const Field& gap, std::size_t at) {
  const int i = static_cast<int>(at) / grid.ny, j = static_cast<int>(at) % grid.ny;
  const auto of = [&](int a, int b) {
    const double there = gap[static_cast<std::size_t>(std::clamp(a, 0, grid.nx - 1)) * grid.ny +
                             std::clamp(b, 0, grid.ny - 1)];
    // Beyond the end of a body, the gap of the cell itself is used.
    return std::isfinite(there) ? there : gap[at];
  };
  const double x = (of(i + 1, j) - of(i - 1, j)) / grid.dx,
               y = (of(i, j + 1) - of(i, j - 1)) / grid.dy, length = std::hypot(x, y);
  return length > 0 ? std::array{x / length, y / length} : std::array{1.0, 0.0};
}

}  // namespace

double crosswise_compliance(const Grid& grid, const operators::TangentialInfluence& influence) {
  // Distance from a load [cells] at which the displacement ahead of the load is compared with the
  // displacement to its side.
  constexpr int far = 100;
  const double side = std::min(grid.dx, grid.dy);
  const Grid square(1, 1, side, side);
  const auto at = [&](int i, int j) {
    return influence.table(operators::Traction::shear_x, operators::Axis::x, square, {{i}, {j}})[0];
  };
  return at(far, 0) / at(0, far);
}

Field slip_after_contact(const Grid& grid, const Growth& growth, double crosswise) {
  const std::vector<std::size_t> cells = new_cells(growth);
  if (cells.empty()) return {};
  const std::size_t n = growth.gap.size();
  Field parts(3 * n, 1.0);
  std::fill_n(parts.begin() + static_cast<std::ptrdiff_t>(n), n, 0.0);
  const double sheared = growth.slid > growth.max_slid ? growth.max_slid / growth.slid : 1.0;
  const double twist = sheared * 2 * (crosswise - 1) / (crosswise + 1);
  const std::vector<double> before = touching_fraction(growth, cells);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::size_t i = cells[c];
    const double share = std::min(growth.gap[i] / growth.closer, 1.0);
    const double angular = share * twist * slid_by_angle(std::sqrt(before[c]));
    const auto [x, y] = edge_normal(grid, growth.gap, i);
    parts[i] -= share - angular * (x * x - y * y);
    parts[n + i] += angular * 2 * x * y;
    parts[2 * n + i] -= share + angular * (x * x - y * y);
  }
  return parts;
}

}  // namespace samcontact::contact
