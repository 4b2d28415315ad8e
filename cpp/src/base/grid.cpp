// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/grid.hpp"

#include <cmath>
#include <stdexcept>

#include "samcontact/base/errors.hpp"

namespace samcontact {
namespace {

void require_size(const char* name, double value) {
  require(std::isfinite(value) && value > 0, name, "a finite number > 0 [m]", value);
  require_moderate(name, value, "[m]");
}

/// Lattice sums of cells that are much longer than the period in the other direction are slow and
/// meaningless.
constexpr double longest_cell = 8.0;

void require_short(const char* name, double cell, const char* of, double period) {
  require(cell <= longest_cell * period, name,
          "at most " + to_short_text(longest_cell) + " periods " + of + " of the grid, " +
              to_text(longest_cell * period) + " m, unless there is one cell along the period",
          cell);
}

std::vector<double> centres(int n, double d) {
  std::vector<double> c(n);
  for (int i = 0; i < n; ++i) c[i] = (i - 0.5 * (n - 1)) * d;
  return c;
}

}  // namespace

Grid::Grid(int nx_, int ny_, double dx_, double dy_, int nz_, double dz_)
    : nx(nx_), ny(ny_), nz(nz_), dx(dx_), dy(dy_), dz(dz_) {
  require(nx > 0, "nx", "an integer > 0", nx);
  require(ny > 0, "ny", "an integer > 0", ny);
  require(nz >= 0, "nz", "an integer >= 0", nz);
  require_size("dx", dx);
  require_size("dy", dy);
  if (nz > 0 || dz != 0) require_size("dz", dz);
}

Grid Grid::made_periodic(bool along_x, bool along_y) const {
  const auto require_even = [](const char* name, int cells) {
    require(cells == 1 || cells % 2 == 0, name, "even, or 1, along a periodic direction", cells);
  };
  if (along_x) require_even("nx", nx);
  if (along_y) require_even("ny", ny);
  if (along_x && along_y && nx == 1 && ny == 1) {
    throw std::invalid_argument("nx and ny must not both be 1 on a periodic grid");
  }
  if (along_y && ny > 1) require_short("dx", dx, "ny dy", ny * dy);
  if (along_x && nx > 1) require_short("dy", dy, "nx dx", nx * dx);
  Grid grid = *this;
  grid.period = {along_x ? nx : 0, along_y ? ny : 0, 0.0};
  if (along_x != along_y) grid.period.reference = along_x ? ny * dy : nx * dx;
  return grid;
}

bool Grid::can_be_coarsened(int factor) const {
  const auto fits = [factor](int cells) { return cells % (2 * factor) == 0; };
  return fits(period.x) && fits(period.y);
}

std::vector<double> Grid::x() const { return centres(nx, dx); }
std::vector<double> Grid::y() const { return centres(ny, dy); }

std::vector<double> Grid::z(int layers) const {
  std::vector<double> c(layers);
  for (int k = 0; k < layers; ++k) c[k] = (k0 + k + 0.5) * dz;
  return c;
}

}  // namespace samcontact
