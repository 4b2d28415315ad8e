// SPDX-License-Identifier: GPL-3.0-or-later
// Normal surface displacement due to the reflections between two parallel free faces of a body.
#pragma once

#include <memory>
#include <vector>

#include "samcontact/base/grid.hpp"

namespace samcontact::operators {

/// Displacement of a slab between two free faces, less that of the half-space and of the effects of
/// each face alone. It varies over the distance of the faces, so that few waves along x and
/// few nodes along y describe it. Symmetric in load and displacement; its mean and its rotation,
/// changes of approach and tilt, are omitted: they are not finite for an infinitely deep slab.
class FacePair {
 public:
  /// Faces at low and high [m]; bodies of one Poisson's ratio, with the sum of their 1/E [1/Pa].
  FacePair(const Grid& grid, double low, double high, double nu, double softness);

  /// displacement [m] += effect of pressure [Pa], both [i][j], different arrays.
  void add(const double* pressure, double* displacement) const;
  /// Operations of one application.
  double cost() const;

 private:
  /// Node below a row inside the body, and the share of the next node.
  struct Place {
    int row, node;
    double share;
  };
  struct Waves;

  int nx_, ny_;
  double factor_;                       // force of a cell per pressure, over E and the distance
  std::shared_ptr<const Waves> waves_;  // of unit distance and E
  std::vector<Place> places_;
  std::vector<double> harmonics_;  // by wave, cosine and sine: [i]

  static std::shared_ptr<const Waves> waves_of(double nu);
};

}  // namespace samcontact::operators
