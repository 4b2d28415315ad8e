// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of influence coefficients split in two: what lies near the source, in a few cells, and the
// rest, so smooth that a coarser lattice holds it.
#pragma once

#include <Eigen/Core>
#include <array>

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {

/// Replaces a table inside |x|, |y| < cells by what makes it smoothest: least in the wavenumbers
/// with |kx| or |ky| beyond a part, clear_band, of the highest of a lattice `factor` times as
/// coarse, which holds what is below as it is. Beyond that square it stays. The weights of least
/// squares are those of a square of cells on all of the plane, sines of the difference over it, so
/// that its eigenvectors are products of Slepian's sequences (1978,
/// doi:10.1002/j.1538-7305.1978.tb02104.x).
class SmoothContinuation {
 public:
  /// step: of rest().
  SmoothContinuation(int factor, int cells, double clear_band, int step);

  int cells() const { return cells_; }
  /// Offsets 0..reach() - 1 of a table that are looked at: beyond, it is smooth.
  int reach() const { return reach_; }
  /// table: [j][i], offsets 0..reach() - 1 in both directions. Returns the values inside, [j][i] of
  /// 0..cells() - 1.
  Field inside(const double* table, kernels::Parity parity) const;
  /// What the coarse lattice cannot hold of a table that is smooth inside, [j][i] of every step-th
  /// offset below reach(): little, around the edge of the square.
  Field rest(const double* table, kernels::Parity parity) const;

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  /// Of sequences that are even or odd: those on the offsets inside, orthonormal.
  struct Axis {
    Eigen::MatrixXd vectors;   // [offset inside][number]
    Eigen::VectorXd values;    // how much of each lies within the band
    Eigen::MatrixXd seen;      // [offset inside][offset]: the band's part of a table
    Eigen::VectorXd per_unit;  // of an orthonormal sequence, its value at an offset
    Eigen::MatrixXd low;       // [every step-th offset][offset]: what the coarse lattice holds
  };
  static Axis make_axis(int cells, int reach, double cut, bool odd);
  /// filter: of differences of offsets.
  Eigen::MatrixXd make_low(const Eigen::VectorXd& filter, bool odd) const;

  /// A table that fades out.
  Rows faded(const double* table) const;

  int cells_, reach_, step_;
  Eigen::VectorXd fade_;  // [offset]
  std::array<Axis, 2> axes_;
};

}  // namespace samcontact::operators
