// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/increment/target.hpp"

namespace samcontact::simulation {

std::string describe(const Target& target) {
  return target.is_prescribed() ? "the prescribed tractions" : contact::describe(target.drive);
}

}  // namespace samcontact::simulation
