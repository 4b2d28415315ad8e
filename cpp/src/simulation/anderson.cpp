// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/anderson.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "samcontact/base/reduce.hpp"

namespace samcontact::simulation {
namespace {

double dot(const Field& a, const Field& b) {
  return ordered_sum(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

}  // namespace

double norm(const Field& v) { return std::sqrt(dot(v, v)); }

void Anderson::reset() {
  last_x_.clear();
  dx_.clear();
  df_.clear();
}

void Anderson::next(Field& x, const Field& f) {
  if (!last_x_.empty()) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      last_x_[i] = x[i] - last_x_[i];
      last_f_[i] = f[i] - last_f_[i];
    }
    dx_.push_back(std::move(last_x_));
    df_.push_back(std::move(last_f_));
    if (static_cast<int>(dx_.size()) > depth_) {
      dx_.erase(dx_.begin());
      df_.erase(df_.begin());
    }
  }
  last_x_ = x;
  last_f_ = f;

  const int m = static_cast<int>(dx_.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += f[i];
  if (m == 0) return;
  Eigen::MatrixXd gram(m, m);
  Eigen::VectorXd rhs(m);
  for (int a = 0; a < m; ++a) {
    for (int b = 0; b <= a; ++b) gram(a, b) = gram(b, a) = dot(df_[a], df_[b]);
    rhs(a) = dot(df_[a], f);
  }
  // Columns shrink as the iteration converges: scale them, then drop near-dependent directions.
  const Eigen::VectorXd scale = gram.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-10);
  solver.compute(scale.asDiagonal() * gram * scale.asDiagonal());
  const Eigen::VectorXd gamma =
      scale.asDiagonal() * solver.solve(Eigen::VectorXd(scale.asDiagonal() * rhs));
  for (int a = 0; a < m; ++a) {
    const double c = gamma(a);
    const Field &dx = dx_[a], &df = df_[a];
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= c * (dx[i] + df[i]);
  }
}

}  // namespace samcontact::simulation
