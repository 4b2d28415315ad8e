// SPDX-License-Identifier: GPL-3.0-or-later
// Splitting of tables of influence coefficients: a part near the source, in a few cells, and the
// remainder, which is so smooth that a coarser lattice represents it.
#pragma once

#include <Eigen/Core>
#include <array>

#include "samcontact/base/aligned.hpp"
#include "samcontact/kernels/eigenstrain.hpp"

namespace samcontact::operators {

/// Replaces a table inside |x|, |y| < cells by its smoothest continuation: the one with the least
/// energy at wavenumbers with |kx| or |ky| above the fraction passband_fraction of the highest
/// wavenumber of a lattice `factor` times as coarse, which represents lower wavenumbers exactly.
/// The table is unchanged outside that square. The least-squares weights are those of a square of
/// cells in the infinite plane, sines of the difference over it, so that its eigenvectors are
/// products of Slepian's sequences (1978, doi:10.1002/j.1538-7305.1978.tb02104.x).
class SmoothContinuation {
 public:
  /// step: of rest().
  SmoothContinuation(int factor, int cells, double passband_fraction, int step);

  int cells() const { return cells_; }
  /// Offsets 0..reach() - 1 of a table are used: beyond, it is smooth.
  int reach() const { return reach_; }
  /// table: [j][i], offsets 0..reach() - 1 in both directions. Returns the continuation inside,
  /// [j][i] of 0..cells() - 1.
  Field inside(const double* table, kernels::Parity parity) const;
  /// Part of a table, smooth inside, that the coarse lattice cannot represent, [j][i] of every
  /// step-th offset below reach(): small, around the edge of the square.
  Field rest(const double* table, kernels::Parity parity) const;

 private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  /// Orthonormal even or odd sequences on the offsets inside.
  struct Axis {
    Eigen::MatrixXd vectors;   // [offset inside][number]
    Eigen::VectorXd values;    // part of the energy of each sequence within the passband
    Eigen::MatrixXd seen;      // [offset inside][offset]: passband part of a table
    Eigen::VectorXd per_unit;  // value of a normalised sequence at an offset
    Eigen::MatrixXd low;  // [every step-th offset][offset]: part represented by the coarse lattice
  };
  static Axis make_axis(int cells, int reach, double cut, bool odd);
  /// filter: as a function of the difference of offsets.
  Eigen::MatrixXd make_low(const Eigen::VectorXd& filter, bool odd) const;

  /// Table multiplied by fade_.
  Rows faded(const double* table) const;

  int cells_, reach_, step_;
  Eigen::VectorXd fade_;  // [offset]
  std::array<Axis, 2> axes_;
};

}  // namespace samcontact::operators
