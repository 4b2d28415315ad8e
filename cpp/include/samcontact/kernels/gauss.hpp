// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Legendre quadrature on the unit interval.
#pragma once

#include <vector>

namespace samcontact::kernels {

/// Node of a quadrature: its position and its weight.
struct QuadratureNode {
  double at, weight;
};

/// The n nodes on (0, 1), ascending; exact for polynomials of degree 2 n - 1.
std::vector<QuadratureNode> gauss_legendre(int n);

}  // namespace samcontact::kernels
