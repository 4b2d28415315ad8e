// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/thermal.hpp"

#include <cmath>

#include "samcontact/base/errors.hpp"

namespace samcontact {

Thermal Thermal::of(double conductivity, double expansion, double diffusivity) {
  require(std::isfinite(conductivity) && conductivity > 0, "conductivity",
          "a finite number > 0 [W/(m K)]", conductivity);
  require(std::isfinite(expansion) && expansion >= 0, "expansion", "a finite number >= 0 [1/K]",
          expansion);
  require(std::isfinite(diffusivity) && diffusivity > 0, "diffusivity",
          "a finite number > 0 [m^2/s]", diffusivity);
  return {conductivity, expansion, diffusivity};
}

}  // namespace samcontact
