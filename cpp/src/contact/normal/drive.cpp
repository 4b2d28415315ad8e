// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/normal/drive.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/errors.hpp"
#include "samcontact/contact/normal/rigid_modes.hpp"

namespace samcontact::contact {
namespace {

constexpr const char* axis_names[] = {"x", "y"};

void require_valid_tilts(const Drive& drive, const Grid& grid) {
  for (int k = 0; k < 2; ++k) {
    const Given& tilt = drive.tilt[k];
    const std::string about = std::string(" about ") + axis_names[k];
    const std::string name = (tilt.is_force() ? "moment" : "tilt") + about;
    require(std::isfinite(tilt.value), name,
            tilt.is_force() ? "a finite number [N m]" : "a finite number [rad]", tilt.value);
    const bool across = (k == 0 ? grid.period.y : grid.period.x) > 0;
    if (across && (tilt.is_force() || tilt.value != 0)) {
      throw std::invalid_argument(name + " is not possible on a grid that is periodic along " +
                                  axis_names[1 - k] +
                                  ": a tilted surface does not repeat, so the tilt must be 0");
    }
    if (tilt.is_force() && !drive.normal.is_force()) {
      throw std::invalid_argument(name +
                                  " cannot be combined with approach: prescribe load and moment, "
                                  "or approach and tilt");
    }
  }
}

}  // namespace

RigidMotion Drive::held() const {
  RigidMotion motion;
  for (int k = 0; k < 2; ++k) motion.tilt[k] = tilt[k].is_force() ? 0.0 : tilt[k].value;
  return motion;
}

Lowering::Lowering(const Grid& grid, const RigidMotion& motion)
    : approach_(motion.approach), tilted_(motion.is_tilted()) {
  if (!tilted_) return;
  along_x_ = grid.x();
  along_y_ = grid.y();
  for (double& x : along_x_) x = motion.approach - motion.tilt[1] * x;
  for (double& y : along_y_) y *= motion.tilt[0];
}

std::string describe(const Drive& drive) {
  const Given& normal = drive.normal;
  const std::string value = to_short_text(normal.value, 6);
  std::string text = normal.is_force() ? "load " + value + " N" : "approach " + value + " m";
  for (int k = 0; k < 2; ++k) {
    const Given& tilt = drive.tilt[k];
    if (!tilt.is_force() && tilt.value == 0) continue;
    text += std::string(tilt.is_force() ? ", moment " : ", tilt ") + to_short_text(tilt.value, 6) +
            (tilt.is_force() ? " N m about " : " rad about ") + axis_names[k];
  }
  return text;
}

void require_valid(const Drive& drive, const ContactLaw& law, const Grid& grid) {
  require_valid_tilts(drive, grid);
  const double value = drive.normal.value;
  if (drive.normal.is_force()) {
    const bool pulls = law.attracts();
    require(std::isfinite(value) && (pulls || value >= 0), "load",
            pulls ? "a finite number [N]" : "a finite number >= 0 [N]", value);
    if (value != 0) require_moderate("load", std::fabs(value), "[N], or 0");
    for (const Given& tilt : drive.tilt) {
      if (!tilt.is_force() || tilt.value == 0 || value != 0 || pulls) continue;
      throw std::invalid_argument("moment must be 0 N m without load, got " +
                                  to_short_text(tilt.value, 6) +
                                  " N m: separated bodies transmit no moment");
    }
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

void require_reach(const Drive& drive, const Grid& grid, const Field& gap) {
  const RigidModes modes(drive, grid);
  if (!modes.tilts()) return;
  Field body(gap.size());
  for (std::size_t i = 0; i < gap.size(); ++i) body[i] = std::isfinite(gap[i]) ? 1.0 : 0.0;
  if (modes.meet(body)) return;
  const double load = drive.normal.value;
  const auto arm = [&](int k, double sign) {
    const Given& tilt = drive.tilt[k];
    return tilt.is_force() ? to_short_text(tilt.value == 0 ? 0.0 : sign * tilt.value / load, 4)
                           : std::string("any");
  };
  throw std::invalid_argument(
      "moment is too large for the load: at " + describe(drive) +
      " the resultant of the pressure would act at y = moment about x / load = " + arm(0, 1.0) +
      " m, x = -moment about y / load = " + arm(1, -1.0) +
      " m, beyond the cells of finite gap (grid of " + to_short_text(grid.nx * grid.dx, 4) +
      " m x " + to_short_text(grid.ny * grid.dy, 4) +
      " m): no contact pressure is in equilibrium with it; reduce the moment, increase the load, "
      "or enlarge a grid that is smaller than the bodies");
}

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
