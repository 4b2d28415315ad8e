// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/elastic.hpp"

#include <cmath>

#include "samcontact/base/errors.hpp"

namespace samcontact {

Elastic Elastic::isotropic(double E, double nu) {
  require(std::isfinite(E) && E > 0, "E", "a finite number > 0 [Pa]", E);
  require_moderate("E", E, "[Pa]");
  require(std::isfinite(nu) && nu >= 0 && nu < 0.5, "nu", "in [0, 0.5)", nu);
  return {E, nu};
}

}  // namespace samcontact
