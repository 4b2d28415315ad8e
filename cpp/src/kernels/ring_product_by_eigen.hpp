// SPDX-License-Identifier: GPL-3.0-or-later
// Definition of the product, compiled for the instruction set of the file that includes it.
#pragma once

#include <Eigen/Core>

#include "samcontact/kernels/ring_product.hpp"

namespace samcontact::kernels {

/// Version: a type for each instruction set, so that the linker keeps their functions apart.
template <class Version>
void ring_product_by_eigen(const RingProduct& of, double* result) {
  using Known = Eigen::Map<const Eigen::MatrixXd>;
  const Known left(of.left, of.rows, of.inner), middle(of.middle, of.inner, of.across),
      right(of.right, of.columns, of.across);
  const Eigen::MatrixXd half = left * middle;
  Eigen::Map<Eigen::MatrixXd>(result, of.rows, of.columns).noalias() = half * right.transpose();
}

}  // namespace samcontact::kernels
