// SPDX-License-Identifier: GPL-3.0-or-later
// Prescribed quantities of a contact (load or approach, moments or tilts), and the resulting
// rigid-body motion.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/grid.hpp"
#include "samcontact/contact/laws/contact_law.hpp"

namespace samcontact::contact {

/// One degree of freedom of the rigid-body motion: the motion itself, or the corresponding force.
struct Given {
  enum class Kind { motion, force } kind;
  double value;  // [m] or [N]; of a rotation [rad] or [N m]

  static constexpr Given motion(double metre) { return {Kind::motion, metre}; }
  static constexpr Given force(double newton) { return {Kind::force, newton}; }
  bool is_force() const { return kind == Kind::force; }
};

/// About x and y: right-handed rotations of body 1 relative to body 2 [rad], with z into body 2, or
/// moments on body 2 at the origin of the grid [N m]: (sum of p y, -sum of p x) over the area.
using AboutAxes = std::array<double, 2>;

/// Motion of body 1 relative to body 2 since the undeformed bodies touched: body 1 is lowered by
/// approach + tilt[0] y - tilt[1] x.
struct RigidMotion {
  double approach = 0.0;  // at the origin of the grid [m]
  AboutAxes tilt{};       // [rad]

  bool is_tilted() const { return tilt != AboutAxes{}; }
};

/// Prescribed values of all degrees of freedom that the contact law leaves open. Full sliding
/// leaves only the normal one and the tilts.
struct Drive {
  Given normal{};
  std::array<Given, 2> tilt{Given::motion(0.0), Given::motion(0.0)};  // about x and y
  /// Compliance of the machine that prescribes the approach [m/N]: the approach of the bodies is
  /// smaller by the compression of the machine under the load.
  double spring = 0.0;

  static Drive load(double newton) { return {Given::force(newton)}; }
  static Drive approach(double metre) { return {Given::motion(metre)}; }

  /// Whether a moment is prescribed.
  bool tilts_freely() const { return tilt[0].is_force() || tilt[1].is_force(); }
  /// The prescribed part of the tilt.
  RigidMotion held() const;
};

/// Lowering of body 1 at each cell due to a rigid motion [m].
class Lowering {
 public:
  Lowering(const Grid& grid, const RigidMotion& motion);
  double operator()(std::size_t cell) const {
    return tilted_ ? along_x_[cell / along_y_.size()] + along_y_[cell % along_y_.size()]
                   : approach_;
  }

 private:
  double approach_;
  bool tilted_;
  std::vector<double> along_x_, along_y_{0.0};
};

/// Text that describes the drive, for messages.
std::string describe(const Drive& drive);

/// Throws std::invalid_argument with the name of the argument if the drive is not possible with
/// this contact law on this grid: negative loads require an attraction, moments a load, and tilts
/// about an axis a surface that is not periodic across it.
void require_valid(const Drive& drive, const ContactLaw& law, const Grid& grid);
/// Throws std::invalid_argument with both moments if the line of action of the load lies beyond the
/// cells of finite gap, so that no pressure is in equilibrium with it.
void require_reach(const Drive& drive, const Grid& grid, const Field& gap);
/// Throws std::invalid_argument unless a surface field has the shape of the grid and is finite.
void require_surface(const Field& field, const Grid& grid, const std::string& name);
/// Throws std::invalid_argument unless a gap has the shape of the grid and is finite in at least
/// one cell, and finite or +inf (no body) in all others.
void require_gap(const Field& gap, const Grid& grid, const std::string& name);

}  // namespace samcontact::contact
