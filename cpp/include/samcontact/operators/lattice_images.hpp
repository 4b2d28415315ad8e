// SPDX-License-Identifier: GPL-3.0-or-later
// The smooth part of a lattice sum: what images do that are too many and too far to be added one by
// one. A window divides the wavenumbers. Of short waves nothing of these images arrives; of the
// long ones, which their symbol gives, all images are the sum over the waves of the lattice less
// the integral over all waves, the cell itself.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {

/// Offsets 0, d, .. (cells - 1) d along one axis, of a lattice that repeats after `period` [m].
struct LatticeAxis {
  double d = 1.0;
  int cells = 1;
  double period = 0.0;  // 0: none
  int apart = 0;        // images up to this one are added one by one

  double extent() const { return (cells - 1) * d; }
  /// From the farthest offset to the first image that is not added.
  double distance() const { return (apart + 1) * period - extent(); }
};

class LatticeImages {
 public:
  using Wave = std::function<void(double kx, double ky, double* components)>;

  /// Of cells, y periodic; without a period along x, waves that are uniform along y are left out.
  static LatticeImages of_cells(const LatticeAxis& x, const LatticeAxis& y);
  /// Of strips that are uniform along y, x periodic. One row of offsets.
  static LatticeImages of_strips(const LatticeAxis& x);

  /// Adds the images to a table [component][j][i], even components to a constant.
  void add(const Wave& wave, const std::vector<kernels::Parity>& parities, Field& table) const;

 private:
  struct Modes {
    std::vector<double> kx, ky, weight;
    void push(double x, double y, double w);
    /// The sum over the waves of a lattice, windowed at q1.
    void add_lattice(const LatticeAxis& x, const LatticeAxis& y, double q1);
    /// Less the integral over all waves, for a cell and the images that are added one by one.
    void subtract_integral(const LatticeAxis& x, const LatticeAxis& y, double q1);
  };
  /// Values at points along an axis from those at its Chebyshev points > 0, by parity.
  struct Points {
    std::vector<double> nodes;
    Eigen::MatrixXd even, odd;  // offset x node
    /// ratio: by which the error falls with each point on both sides.
    Points(const LatticeAxis& axis, double ratio);
  };
  /// Factors of even and odd components at the nodes: node x mode.
  struct Factors {
    Eigen::MatrixXd even, odd;
    Factors(const std::vector<double>& nodes, const std::vector<double>& wavenumbers,
            double subtracted);
  };
  LatticeImages(Modes modes, Points x, Points y, double subtracted);

  Modes modes_;
  Points x_, y_;
  Factors along_x_, along_y_;
};

}  // namespace samcontact::operators
