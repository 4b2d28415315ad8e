// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/joint/joint_preconditioner.hpp"

#include <Eigen/Dense>

#include "samcontact/operators/surface/kernel_floor.hpp"
#include "samcontact/operators/surface/near_displacement.hpp"
#include "samcontact/operators/surface/relative_displacement.hpp"

namespace samcontact::contact {
namespace {

/// Inverse of a symmetric matrix with its eigenvalues raised to at least `least`.
Eigen::Matrix3d inverse_of(const Eigen::Matrix3d& matrix, double least) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  const Eigen::Vector3d inverted = solver.eigenvalues().cwiseMax(least).cwiseInverse();
  return solver.eigenvectors() * inverted.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

JointPreconditioner::JointPreconditioner(const Grid& grid,
                                         const operators::TangentialInfluence& influence)
    : convolution_(grid, operators::short_period_x(grid), operators::short_period_y(grid)),
      inverse_(operators::relative_kernels(grid, influence, convolution_.offsets())) {
  for (auto& entry : inverse_) convolution_.transform(entry.kernel);
  const double least = operators::kernel_floor(grid, influence);
  // Spectra contain 1/(mx my) of two transforms. A factor i on the tangential components makes the
  // matrix real and symmetric; that of a doubly odd kernel leaves a sign.
  const double points = static_cast<double>(convolution_.mx()) * convolution_.my();
  for (std::size_t k = 0; k < inverse_[0].kernel.quarter.size(); ++k) {
    const auto value = [&](int row, int column) -> double& {
      return inverse_[3 * row + column].kernel.quarter[k];
    };
    Eigen::Matrix3d matrix;
    matrix << value(0, 0), value(0, 1), value(0, 2),  //
        value(0, 1), value(1, 1), -value(1, 2),       //
        value(0, 2), -value(1, 2), value(2, 2);
    const Eigen::Matrix3d inverse = inverse_of(points * matrix, least) / points;
    for (int row = 0; row < 3; ++row) value(row, row) = inverse(row, row);
    for (int axis = 1; axis < 3; ++axis) {
      value(0, axis) = inverse(0, axis);
      value(axis, 0) = -inverse(0, axis);
    }
    value(1, 2) = value(2, 1) = -inverse(1, 2);
  }
}

}  // namespace samcontact::contact
