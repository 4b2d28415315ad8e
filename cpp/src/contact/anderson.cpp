// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/anderson.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <utility>

#include "samcontact/base/reduce.hpp"

namespace samcontact::contact {

double norm(const Field& v) { return std::sqrt(ordered_dot(v.data(), v.data(), v.size())); }

void Anderson::reset() {
  last_x_.clear();
  last_f_.clear();
  steps_.clear();
  gram_.resize(0, 0);
}

void Anderson::remember(const Field& x, const Field& f) {
  const std::size_t n = x.size();
  last_x_.resize(n, 0.0);
  last_f_.resize(n, 0.0);
  for (Step& step : steps_) {
    step.dx.resize(n, 0.0F);
    step.df.resize(n, 0.0F);
  }
  Step step{std::vector<float>(n), std::vector<float>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    step.dx[i] = static_cast<float>(x[i] - last_x_[i]);
    step.df[i] = static_cast<float>(f[i] - last_f_[i]);
  }
  steps_.push_back(std::move(step));
  Eigen::Index m = gram_.rows();
  if (static_cast<int>(steps_.size()) > depth_) {
    steps_.pop_front();
    gram_ = gram_.bottomRightCorner(m - 1, m - 1).eval();
    --m;
  }
  gram_.conservativeResize(m + 1, m + 1);
  const auto& df = steps_.back().df;
  for (Eigen::Index a = 0; a <= m; ++a) {
    gram_(a, m) = gram_(m, a) = ordered_dot(steps_[a].df.data(), df.data(), n);
  }
}

void Anderson::next(Field& x, const Field& f) {
  if (!last_x_.empty()) remember(x, f);
  last_x_ = x;
  last_f_ = f;

  const int m = static_cast<int>(steps_.size());
  const std::size_t n = x.size();
  for (std::size_t i = 0; i < n; ++i) x[i] += f[i];
  if (m == 0) return;
  Eigen::VectorXd rhs(m);
  for (int a = 0; a < m; ++a) rhs(a) = ordered_dot(steps_[a].df.data(), f.data(), n);
  // Columns shrink as the iteration converges: scale them, then drop near-dependent directions.
  const Eigen::VectorXd scale = gram_.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-10);
  solver.compute(scale.asDiagonal() * gram_ * scale.asDiagonal());
  const Eigen::VectorXd gamma =
      scale.asDiagonal() * solver.solve(Eigen::VectorXd(scale.asDiagonal() * rhs));
  for (int a = 0; a < m; ++a) {
    const double c = gamma(a);
    const float *dx = steps_[a].dx.data(), *df = steps_[a].df.data();
    for (std::size_t i = 0; i < n; ++i) x[i] -= c * (static_cast<double>(dx[i]) + df[i]);
  }
}

}  // namespace samcontact::contact
