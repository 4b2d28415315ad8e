// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/talbot.hpp"

#include <cmath>
#include <numbers>

namespace samcontact::kernels {

std::vector<TalbotNode> talbot_nodes(double t, int count) {
  const double all = 2.0 * count;
  std::vector<TalbotNode> nodes;
  for (int n = 0; n < count; ++n) {
    const double angle = (2 * n + 1) * std::numbers::pi / all;
    const double turned = 0.6407 * angle;
    const double cotangent = 1 / std::tan(turned), sine = std::sin(turned);
    const std::complex<double> s(all / t * (0.5017 * angle * cotangent - 0.6122),
                                 all / t * 0.2645 * angle);
    const std::complex<double> slope(
        all / t * (0.5017 * cotangent - 0.5017 * turned / (sine * sine)), all / t * 0.2645);
    nodes.push_back({s, 2 / all * std::exp(s * t) * slope});
  }
  return nodes;
}

}  // namespace samcontact::kernels
