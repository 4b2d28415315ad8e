// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/drive.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/errors.hpp"

namespace samcontact::contact {

std::string describe(const Drive& drive) {
  const Given& normal = drive.normal;
  return normal.is_force() ? "load " + to_text(normal.value) + " N"
                           : "approach " + to_text(normal.value) + " m";
}

void require_valid(const Drive& drive) {
  const double value = drive.normal.value;
  if (drive.normal.is_force()) {
    require(std::isfinite(value) && value >= 0, "load", "a finite number >= 0 [N]", value);
    if (value > 0) require_moderate("load", value, "[N], or 0");
  } else {
    require(std::isfinite(value), "approach", "a finite number [m]", value);
  }
}

void require_surface(const Field& field, const Grid& grid, const std::string& name) {
  if (field.size() != grid.surface_size()) {
    throw std::invalid_argument(name + " must have shape (" + std::to_string(grid.nx) + ", " +
                                std::to_string(grid.ny) + ")");
  }
  if (!std::all_of(field.begin(), field.end(), [](double v) { return std::isfinite(v); })) {
    throw std::invalid_argument(name + " must be finite everywhere");
  }
}

}  // namespace samcontact::contact
