// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/laws/gross_sliding.hpp"

#include <cmath>
#include <utility>

#include "samcontact/base/errors.hpp"

namespace samcontact::contact {

GrossSliding::GrossSliding(double friction) : friction_(friction) {
  require(std::isfinite(friction) && friction >= 0, "friction", "a finite number >= 0", friction);
}

operators::Tractions GrossSliding::tractions(Field pressure) const {
  operators::Tractions tractions{std::move(pressure), {}, {}};
  if (!is_on()) return tractions;
  tractions.shear_x = tractions.pressure;
  for (double& s : tractions.shear_x) s *= shear_over_pressure(1);
  return tractions;
}

}  // namespace samcontact::contact
