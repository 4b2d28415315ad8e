// SPDX-License-Identifier: GPL-3.0-or-later
// Quadrature nodes for the integrals over Gaussians of a heat source (heat_sum.hpp).
//
// An element of heat of age x = kappa tau spreads over Gaussians exp(-w^2 S) with S = v^2 >= x. The
// angle phi orders the ages under one width, x = S sin^2 phi. All panels have Gauss points; they
// double in v, because erf(x/2v) is equally smooth in ln v at every scale.
#pragma once

#include <vector>

#include "samcontact/kernels/gauss.hpp"
#include "samcontact/kernels/heat_sum.hpp"

namespace samcontact::kernels {

/// One width of Gaussians, its weight in an integral over v, and the angle of the oldest age,
/// sin^2 angle = min(1, kappa t / v^2).
struct HeatWidth {
  double v, weight, angle;
};

class HeatQuadrature {
 public:
  explicit HeatQuadrature(double tol);

  /// Number of widths from their edges within which terms are evaluated.
  double reach() const { return reach_; }
  /// For integrals over v from 0 to sqrt(kappa t), age v^2: ends early if the source has passed. A
  /// fast source crosses its own width between two nodes, hence more panels.
  std::vector<HeatWidth> newest_ages(const HeatSource& source, const HeatSum& sum, double z) const;
  /// For integrals over v from 0 to infinity, with all ages up to v^2.
  std::vector<HeatWidth> all_widths(const HeatSource& source, const HeatSum& sum, double z) const;
  /// For integrals over phi from 0 to the angle of a width, as far as the points are reached, with
  /// panels that shrink towards pi/2 down to `finest`.
  std::vector<QuadratureNode> angles(const HeatSource& source, const HeatSum& sum,
                                     const HeatWidth& width, double finest) const;

 private:
  void add_panel(std::vector<QuadratureNode>& nodes, double from, double to) const;
  static double next_width(const HeatSource& source, const HeatSum& sum, double v);
  double first_width(const HeatSource& source, const HeatSum& sum, double z) const;

  double tol_, reach_;
  std::vector<QuadratureNode> rule_;
};

}  // namespace samcontact::kernels
