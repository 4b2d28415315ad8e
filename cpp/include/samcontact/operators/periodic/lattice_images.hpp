// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth part of a lattice sum: images that are too many and too far away to be added one by one.
// Offsets may be arbitrary.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"
#include "samcontact/operators/periodic/lattice_modes.hpp"

namespace samcontact::operators {

class LatticeImages {
 public:
  using Wave = std::function<void(double kx, double ky, double* components)>;

  /// For cells, y periodic; without a period along x, modes that are uniform along y are omitted.
  /// like: of another grid, whose factors are reused if they are equal.
  static LatticeImages of_cells(const LatticeAxis& x, const LatticeAxis& y,
                                const LatticeImages* like = nullptr);
  /// For strips that are uniform along y, x periodic. One row of offsets.
  static LatticeImages of_strips(const LatticeAxis& x);

  /// Adds the images to a table [component][j][i]; even components up to a constant.
  void add(const Wave& wave, const std::vector<kernels::Parity>& parities, Field& table) const;

 private:
  /// Values at points along an axis from those at its Chebyshev points > 0, by parity.
  struct Points {
    std::vector<double> nodes;
    Eigen::MatrixXd even, odd;  // offset x node
    /// ratio: factor by which the error decreases with each point on both sides.
    Points(const LatticeAxis& axis, double ratio);
  };
  /// Factors of even and odd components at the nodes: node x mode.
  struct Factors {
    Eigen::MatrixXd even, odd;
    Factors(const std::vector<double>& nodes, const std::vector<double>& wavenumbers,
            double subtracted);
  };
  LatticeImages(LatticeModes modes, Points x, Points y, double subtracted,
                const LatticeImages* like = nullptr);

  LatticeModes modes_;
  Points x_, y_;
  std::shared_ptr<const Factors> along_x_, along_y_;
};

}  // namespace samcontact::operators
