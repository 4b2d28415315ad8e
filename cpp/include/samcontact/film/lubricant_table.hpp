// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of a lubricant over the pressure at one temperature, as tables with slopes.
#pragma once

#include "samcontact/base/aligned.hpp"

namespace samcontact::film {

/// Reduced pressure Q(p), the integral of density over viscosity from 0 to p, and density. The flux
/// between cells follows from the difference of Q, which is the exact mean of density over
/// viscosity between two pressures (Scharfetter & Gummel 1969, doi:10.1109/T-ED.1969.16566).
class LubricantTable {
 public:
  /// Values at pressures scale (exp(n step) - 1), n = 0, 1, ...; density relative to that at p = 0.
  struct Nodes {
    double scale, step;            // [Pa], [-]
    Field reduced;                 // [1/s]
    Field fluidity;                // density over viscosity [1/(Pa s)]
    Field density, density_slope;  // [-], [1/Pa]
  };
  struct Values {
    double reduced, fluidity, density, density_slope;
  };

  /// Throws std::invalid_argument unless all tables have the same length, at least 2.
  explicit LubricantTable(Nodes nodes);

  /// Cubic between the nodes, straight beyond the last.
  Values at(double pressure) const;

  double largest_pressure() const { return pressures_.back(); }

 private:
  Nodes nodes_;
  Field pressures_;
};

}  // namespace samcontact::film
