// SPDX-License-Identifier: GPL-3.0-or-later
// What pressure on one cell, with the friction and heat that it brings, does to the normal
// displacement of the cells around it: the coefficients behind all contact operators, on any grid.
#pragma once

#include <vector>

#include "samcontact/operators/heating.hpp"
#include "samcontact/operators/surface_convolution.hpp"

namespace samcontact::operators {

class SurfaceInfluence {
 public:
  /// Compliances [1/Pa] as in base/elastic.hpp, summed over the bodies; shear_compliance with the
  /// sign of each body's shear, and times shear over pressure.
  explicit SurfaceInfluence(double normal_compliance, double shear_compliance = 0.0);

  /// Adds the heat of a body; nu its Poisson's ratio.
  void add(const Heating& heating, double nu);

  /// The part that is even in x and y: quarter [j][i] of offsets i dx, j dy [m/Pa].
  Field even(double dx, double dy, int nx, int ny) const;
  /// The same at any offsets.
  Field even(double dx, double dy, const Offsets& offsets) const;
  /// The elastic part of it, which is positive definite.
  Field elastic(double dx, double dy, int nx, int ny) const;

  /// All that is not even.
  std::vector<ParityKernel> rest(double dx, double dy, int nx, int ny) const;
  bool has_rest() const;
  /// Whether heat enters a body: the operator may then be indefinite.
  bool is_heated() const { return !heated_.empty(); }
  double normal_compliance() const { return normal_; }

 private:
  struct Heated {
    Heating heating;
    double nu = 0.0;
  };
  double normal_, shear_;
  std::vector<Heated> heated_;
};

}  // namespace samcontact::operators
