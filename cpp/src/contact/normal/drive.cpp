// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/drive.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/errors.hpp"

namespace samcontact::contact {

std::string describe(const Drive& drive) {
  const Given& normal = drive.normal;
  const std::string value = to_short_text(normal.value, 6);
  return normal.is_force() ? "load " + value + " N" : "approach " + value + " m";
}

void require_valid(const Drive& drive, const ContactLaw& law) {
  const double value = drive.normal.value;
  if (drive.normal.is_force()) {
    const bool pulls = law.attracts();
    require(std::isfinite(value) && (pulls || value >= 0), "load",
            pulls ? "a finite number [N]" : "a finite number >= 0 [N]", value);
    if (value != 0) require_moderate("load", std::fabs(value), "[N], or 0");
  } else {
    require(std::isfinite(value), "approach", "a finite number [m]", value);
  }
}

namespace {

void require_shape(const Field& field, const Grid& grid, const std::string& name) {
  if (field.size() == grid.surface_size()) return;
  throw std::invalid_argument(name + " must have shape (" + std::to_string(grid.nx) + ", " +
                              std::to_string(grid.ny) + ")");
}

}  // namespace

void require_surface(const Field& field, const Grid& grid, const std::string& name) {
  require_shape(field, grid, name);
  if (!std::all_of(field.begin(), field.end(), [](double v) { return std::isfinite(v); })) {
    throw std::invalid_argument(name + " must be finite everywhere");
  }
}

void require_gap(const Field& gap, const Grid& grid, const std::string& name) {
  require_shape(gap, grid, name);
  const auto is_known = [](double v) { return std::isfinite(v) || v == INFINITY; };
  const auto is_body = [](double v) { return std::isfinite(v); };
  if (!std::all_of(gap.begin(), gap.end(), is_known) ||
      !std::any_of(gap.begin(), gap.end(), is_body)) {
    throw std::invalid_argument(name +
                                " must be finite, or +inf where there is no body, and finite "
                                "in at least one cell");
  }
}

}  // namespace samcontact::contact
