// SPDX-License-Identifier: GPL-3.0-or-later
// Inverse Laplace transform on Talbot's contour, for transforms whose singularities lie on the
// negative real axis.
#pragma once

#include <complex>
#include <vector>

namespace samcontact::kernels {

/// f(t) is the sum of Im(weight F(s)) over the nodes s [1/s].
struct TalbotNode {
  std::complex<double> s, weight;
};

/// Nodes for one time t > 0 [s]; the contour of J. A. C. Weideman, SIAM J. Numer. Anal. 44 (2006)
/// 2342, half of which is used by symmetry. The error is about 10^(-0.6 * 2 count).
std::vector<TalbotNode> talbot_nodes(double t, int count);

}  // namespace samcontact::kernels
