// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/iteration/gmres.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <utility>
#include <vector>

#include "samcontact/base/interrupt.hpp"
#include "samcontact/base/reduce.hpp"

namespace samcontact::contact {
namespace {

double product(const Field& a, const Field& b) { return ordered_dot(a.data(), b.data(), a.size()); }

/// Makes q orthogonal to the vectors and normalises it; stores the scalar products and, below them,
/// the length of q.
Eigen::VectorXd orthogonalise(const std::vector<Field>& vectors, Field& q) {
  const auto count = static_cast<Eigen::Index>(vectors.size());
  Eigen::VectorXd column(count + 1);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Field& v = vectors[i];
    column[i] = product(v, q);
    for (std::size_t k = 0; k < q.size(); ++k) q[k] -= column[i] * v[k];
  }
  column[count] = std::sqrt(product(q, q));
  if (column[count] > 0) {
    for (double& value : q) value /= column[count];
  }
  return column;
}

/// images: preconditioned vectors that are kept; null: the preconditioner is linear.
int solve(const LinearMap& apply, const LinearMap& precondition, const Field& b, double gain,
          int max_steps, Field& x, std::vector<Field>* images) {
  x.assign(b.size(), 0.0);
  const double first = std::sqrt(product(b, b));
  if (!(first > 0)) return 0;
  std::vector<Field> vectors{b};
  for (double& value : vectors[0]) value /= first;
  Eigen::MatrixXd triangle = Eigen::MatrixXd::Zero(max_steps + 1, max_steps);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(max_steps + 1);
  right[0] = first;
  std::vector<Eigen::JacobiRotation<double>> rotations;
  Field z(b.size()), q(b.size());
  int steps = 0;
  while (steps < max_steps && std::fabs(right[steps]) > gain * first) {
    check_interrupt();
    precondition(vectors.back(), z);
    apply(z, q);
    if (images != nullptr) images->push_back(z);
    Eigen::VectorXd column = orthogonalise(vectors, q);
    const bool exact = !(column[steps + 1] > 0);
    for (int i = 0; i < steps; ++i) column.applyOnTheLeft(i, i + 1, rotations[i].adjoint());
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(column[steps], column[steps + 1]);
    column.applyOnTheLeft(steps, steps + 1, rotation.adjoint());
    right.applyOnTheLeft(steps, steps + 1, rotation.adjoint());
    rotations.push_back(rotation);
    triangle.col(steps).head(steps + 1) = column.head(steps + 1);
    ++steps;
    if (exact) break;
    vectors.push_back(q);
  }
  const Eigen::VectorXd shares =
      triangle.topLeftCorner(steps, steps).triangularView<Eigen::Upper>().solve(right.head(steps));
  std::fill(q.begin(), q.end(), 0.0);
  for (int i = 0; i < steps; ++i) {
    const Field& v = images != nullptr ? (*images)[i] : vectors[i];
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += shares[i] * v[k];
  }
  if (images != nullptr) {
    x = std::move(q);
  } else {
    precondition(q, x);
  }
  return steps;
}

}  // namespace

int gmres(const LinearMap& apply, const LinearMap& precondition, const Field& b, double gain,
          int max_steps, Field& x) {
  return solve(apply, precondition, b, gain, max_steps, x, nullptr);
}

int flexible_gmres(const LinearMap& apply, const LinearMap& precondition, const Field& b,
                   double gain, int max_steps, Field& x) {
  std::vector<Field> images;
  return solve(apply, precondition, b, gain, max_steps, x, &images);
}

}  // namespace samcontact::contact
