// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/medium.hpp"

namespace samcontact::operators {

std::optional<double> Medium::normal_ratio(Traction, const Medium& other) const {
  return *this == other ? std::optional(1.0) : std::nullopt;
}

}  // namespace samcontact::operators
