// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/cells/traction_window.hpp"

#include <algorithm>

namespace samcontact::simulation {

Box window_of(const operators::Tractions& tractions, const Grid& grid) {
  Box window;
  for (const Field* field : {&tractions.pressure, &tractions.shear_x, &tractions.shear_y}) {
    if (field->empty()) continue;
    Box box = bounding_box(grid, [&](std::size_t at) { return (*field)[at] != 0; });
    box.nz = 0;
    window = window.united(box);
  }
  return window;
}

operators::Tractions window(const operators::Tractions& tractions, const Grid& grid,
                            const Box& box) {
  const Box surface = Box::surface(grid);
  const Box part = box.layer();
  if (part == surface) return tractions;
  operators::Tractions out;
  const auto cut = [&](const Field& from, Field& to) {
    if (from.empty()) return;
    to.assign(box.surface_size(), 0.0);
    copy_common(from.data(), surface, to.data(), part);
  };
  cut(tractions.pressure, out.pressure);
  cut(tractions.shear_x, out.shear_x);
  cut(tractions.shear_y, out.shear_y);
  return out;
}

Field shear_vectors(const operators::Tractions& tractions) {
  const auto& [pressure, along_x, along_y] = tractions;
  if (along_x.empty() && along_y.empty()) return {};
  const std::size_t n = pressure.size();
  Field both(2 * n, 0.0);
  std::copy(along_x.begin(), along_x.end(), both.begin());
  std::copy(along_y.begin(), along_y.end(), both.begin() + static_cast<std::ptrdiff_t>(n));
  return both;
}

}  // namespace samcontact::simulation
