// SPDX-License-Identifier: GPL-3.0-or-later
// The law of the contact along the surface: gross sliding of body 1 over body 2 towards +x, or no
// friction. The only place where shear is made of pressure.
#pragma once

#include "samcontact/fft/mirrored_transform.hpp"
#include "samcontact/operators/influence/tractions.hpp"

namespace samcontact::contact {

class GrossSliding {
 public:
  /// friction: coefficient mu [-]; 0: none. Throws std::invalid_argument unless it is finite and
  /// not negative.
  explicit GrossSliding(double friction);

  bool is_on() const { return friction_ > 0; }
  /// Shear s_x over the pressure on body 1 or 2 (index 0 or 1): mu on body 2, -mu on body 1.
  double shear_over_pressure(int body) const { return operators::shear_sign(body) * friction_; }
  /// Tractions on body 2 under a pressure [Pa]; no shear without friction.
  operators::Tractions tractions(Field pressure) const;
  /// Mirror planes that it leaves.
  fft::Symmetry symmetry() const { return is_on() ? fft::Symmetry::y : fft::Symmetry::xy; }

 private:
  double friction_;
};

}  // namespace samcontact::contact
