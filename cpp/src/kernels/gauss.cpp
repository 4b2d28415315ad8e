// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/gauss.hpp"

#include <cmath>
#include <numbers>

namespace samcontact::kernels {

std::vector<QuadratureNode> gauss_legendre(int n) {
  std::vector<QuadratureNode> nodes(n);
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 1;
    for (int step = 0; step < 8; ++step) {
      double before = 1, p = x;  // Legendre polynomials of degrees m - 1 and m
      for (int m = 1; m < n; ++m) {
        const double next = ((2 * m + 1) * x * p - m * before) / (m + 1);
        before = p;
        p = next;
      }
      slope = n * (before - x * p) / (1 - x * x);
      x -= p / slope;
    }
    nodes[i] = {(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)};
  }
  return nodes;
}

}  // namespace samcontact::kernels
