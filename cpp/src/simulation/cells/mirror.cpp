// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/cells/mirror.hpp"

#include <algorithm>
#include <cmath>

namespace samcontact::simulation {

fft::Symmetry symmetry_of(const operators::HeatingPair& heating) {
  auto symmetry = fft::Symmetry::xy;
  for (const auto& h : heating) {
    if (!h.is_on()) continue;
    if (h.speed_x != 0) symmetry = common(symmetry, fft::Symmetry::y);
    if (h.speed_y != 0) symmetry = fft::Symmetry::none;
  }
  return symmetry;
}

fft::Symmetry symmetry_of(const Field& field, const Grid& grid, kernels::Parity parity) {
  const auto at = [&](int i, int j) { return field[static_cast<std::size_t>(i) * grid.ny + j]; };
  double largest = 0.0;
  for (const double value : field) {
    // A gap is infinite in cells without a body.
    if (std::isfinite(value)) largest = std::max(largest, std::fabs(value));
  }
  const double rounding = 1e-10 * largest;
  const double sign_x = parity.odd_x ? -1.0 : 1.0, sign_y = parity.odd_y ? -1.0 : 1.0;
  const auto same = [&](double a, double b) { return a == b || std::fabs(a - b) <= rounding; };
  bool x = true, y = true;
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = 0; j < grid.ny; ++j) {
      y = y && same(at(i, j), sign_y * at(i, grid.ny - 1 - j));
      x = x && same(at(i, j), sign_x * at(grid.nx - 1 - i, j));
    }
  }
  if (!y) return fft::Symmetry::none;
  return x ? fft::Symmetry::xy : fft::Symmetry::y;
}

fft::Symmetry symmetry_of(const operators::Tractions& tractions, const Grid& grid) {
  auto symmetry = fft::Symmetry::xy;
  for (const operators::Traction kind : operators::all_tractions) {
    const Field& field = tractions.of(kind);
    if (field.empty()) continue;
    symmetry = common(symmetry, symmetry_of(field, grid, operators::vector_parity(kind)));
  }
  return symmetry;
}

fft::Symmetry symmetry_of(const contact::TangentialDrive& drive) {
  if (drive[1].value != 0 || drive[2].value != 0) return fft::Symmetry::none;
  return drive[0].value != 0 ? fft::Symmetry::y : fft::Symmetry::xy;
}

fft::Symmetry symmetry_of(const contact::Drive& drive) {
  if (drive.tilt[0].value != 0) return fft::Symmetry::none;
  return drive.tilt[1].value != 0 ? fft::Symmetry::y : fft::Symmetry::xy;
}

fft::Symmetry common(fft::Symmetry a, fft::Symmetry b) { return std::min(a, b); }

Box stored_part(const Grid& grid, fft::Symmetry symmetry) {
  Box part = Box::whole(grid);
  if (symmetry != fft::Symmetry::none) {
    part.j0 = grid.ny / 2;
    part.ny = grid.ny - part.j0;
  }
  if (symmetry == fft::Symmetry::xy) {
    part.i0 = grid.nx / 2;
    part.nx = grid.nx - part.i0;
  }
  return part;
}

Box whole_box(const Box& stored, const Grid& grid, fft::Symmetry symmetry) {
  Box whole = stored;
  if (symmetry != fft::Symmetry::none) {
    whole.j0 = grid.ny - (stored.j0 + stored.ny);
    whole.ny = grid.ny - 2 * whole.j0;
  }
  if (symmetry == fft::Symmetry::xy) {
    whole.i0 = grid.nx - (stored.i0 + stored.nx);
    whole.nx = grid.nx - 2 * whole.i0;
  }
  return whole;
}

Box part_of(const Box& whole, const Grid& grid, fft::Symmetry symmetry) {
  const Box part = stored_part(grid, symmetry);
  Box out = whole;
  if (symmetry != fft::Symmetry::none) {
    out.j0 = std::max(whole.j0, part.j0);
    out.ny = std::max(0, whole.j0 + whole.ny - out.j0);
  }
  if (symmetry == fft::Symmetry::xy) {
    out.i0 = std::max(whole.i0, part.i0);
    out.nx = std::max(0, whole.i0 + whole.nx - out.i0);
  }
  return out;
}

Box from_planes_on(const Box& box, const Grid& grid, fft::Symmetry symmetry) {
  if (symmetry == fft::Symmetry::none || box.empty()) return box;
  const Box part = stored_part(grid, symmetry);
  const int i0 = symmetry == fft::Symmetry::xy ? part.i0 : box.i0;
  return box.united({i0, part.j0, 1, 1, 0});
}

std::vector<Box> whole_boxes(const std::vector<Box>& stored, const Grid& grid,
                             fft::Symmetry symmetry) {
  const Box part = stored_part(grid, symmetry);
  std::vector<Box> all;
  for (Box box : stored) {
    const Box whole = whole_box(box, grid, symmetry);
    const bool off_plane_x = symmetry == fft::Symmetry::xy && box.i0 > part.i0;
    const bool off_plane_y = symmetry != fft::Symmetry::none && box.j0 > part.j0;
    if (!off_plane_x) box.i0 = whole.i0, box.nx = whole.nx;
    if (!off_plane_y) box.j0 = whole.j0, box.ny = whole.ny;
    all.push_back(box);
    Box image = box;
    image.i0 = whole.i0;
    if (off_plane_x) all.push_back(image);
    image.j0 = whole.j0;
    if (off_plane_x && off_plane_y) all.push_back(image);
    image.i0 = box.i0;
    if (off_plane_y) all.push_back(image);
  }
  return all;
}

std::vector<Box> parts_of(const std::vector<Box>& whole, const Grid& grid, fft::Symmetry symmetry) {
  std::vector<Box> parts;
  for (const Box& box : whole) {
    const Box part = part_of(box, grid, symmetry);
    if (!part.empty()) parts.push_back(part);
  }
  return parts;
}

void unfold(const double* from, const Box& stored, fft::Symmetry had, bool odd_x, bool odd_y,
            double* to, const Box& box, const Grid& grid) {
  for (int i = 0; i < box.nx; ++i) {
    for (int j = 0; j < box.ny; ++j) {
      int gi = box.i0 + i, gj = box.j0 + j;
      bool negative = false;
      if (gi < stored.i0 && had == fft::Symmetry::xy) {
        gi = grid.nx - 1 - gi;
        negative = odd_x;
      }
      if (gj < stored.j0) {
        gj = grid.ny - 1 - gj;
        negative = negative != odd_y;
      }
      const double value =
          from[static_cast<std::size_t>(gi - stored.i0) * stored.ny + (gj - stored.j0)];
      to[static_cast<std::size_t>(i) * box.ny + j] = negative ? -value : value;
    }
  }
}

}  // namespace samcontact::simulation
