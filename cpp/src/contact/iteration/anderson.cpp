// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/contact/iteration/anderson.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <utility>

#include "samcontact/base/reduce.hpp"
#include "samcontact/base/threads.hpp"

namespace samcontact::contact {

double norm(const Field& v) { return std::sqrt(ordered_dot(v.data(), v.data(), v.size())); }

namespace {

/// Without room for further growth, which would double the memory.
template <class Vector>
void lengthen(Vector& v, std::size_t n) {
  v.reserve(n);
  v.resize(n);
}

}  // namespace

template <class Number>
void AndersonOf<Number>::reset() {
  last_f_ = Field{};
  last_dx_ = Vector{};
  steps_.clear();
  gram_.resize(0, 0);
}

template <class Number>
void AndersonOf<Number>::remember(const Field& f) {
  const std::size_t n = f.size();
  lengthen(last_f_, n);
  for (Step& step : steps_) {
    lengthen(step.dx, n);
    lengthen(step.df, n);
  }
  Eigen::Index m = gram_.rows();
  Step step{std::move(last_dx_), {}};
  while (static_cast<int>(steps_.size()) >= depth_) {
    step.df = std::move(steps_.front().df);
    last_dx_ = std::move(steps_.front().dx);
    steps_.pop_front();
    gram_ = gram_.bottomRightCorner(m - 1, m - 1).eval();
    --m;
  }
  lengthen(step.dx, n);
  lengthen(step.df, n);
  for_each_cell(std::ssize(f),
                [&](std::ptrdiff_t i) { step.df[i] = static_cast<Number>(f[i] - last_f_[i]); });
  steps_.push_back(std::move(step));
  gram_.conservativeResize(m + 1, m + 1);
  const auto& df = steps_.back().df;
  for (Eigen::Index a = 0; a <= m; ++a) {
    gram_(a, m) = gram_(m, a) = ordered_dot(steps_[a].df.data(), df.data(), n);
  }
}

template <class Number>
void AndersonOf<Number>::next(Field& x, Field f) {
  if (!last_f_.empty()) remember(f);
  last_f_ = std::move(f);
  advance(x);
}

template <class Number>
Field AndersonOf<Number>::last_x(const Field& x) const {
  Field last(x);
  for (std::size_t i = 0; i < last_dx_.size(); ++i) last[i] -= last_dx_[i];
  return last;
}

template <class Number>
void AndersonOf<Number>::advance(Field& x) {
  const Field& f = last_f_;
  const int m = static_cast<int>(steps_.size());
  const std::size_t n = x.size();
  Eigen::VectorXd gamma(m);
  if (m > 0) {
    for (int a = 0; a < m; ++a) gamma(a) = ordered_dot(steps_[a].df.data(), f.data(), n);
    // Columns shrink as the iteration converges: scale them, then drop nearly dependent directions.
    const Eigen::VectorXd scale = gram_.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-10);
    solver.compute(scale.asDiagonal() * gram_ * scale.asDiagonal());
    gamma = scale.asDiagonal() * solver.solve(Eigen::VectorXd(scale.asDiagonal() * gamma));
  }
  lengthen(last_dx_, n);
  for_each_cell(std::ssize(x), [&](std::ptrdiff_t i) {
    double next = x[i] + f[i];
    for (int a = 0; a < m; ++a) {
      next -= gamma(a) * (static_cast<double>(steps_[a].dx[i]) + steps_[a].df[i]);
    }
    last_dx_[i] = static_cast<Number>(next - x[i]);
    x[i] = next;
  });
}

template class AndersonOf<float>;
template class AndersonOf<double>;

}  // namespace samcontact::contact
