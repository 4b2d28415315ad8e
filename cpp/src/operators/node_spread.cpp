// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/node_spread.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/kernels/gauss.hpp"

namespace samcontact::operators {
namespace {

constexpr double half_width = 0.5 * window_width, steepness = 2.3 * window_width;

double window(double nodes) {
  const double u = nodes / half_width;
  return std::fabs(u) < 1 ? std::exp(steepness * (std::sqrt(1 - u * u) - 1)) : 0.0;
}

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

}  // namespace

double window_transform(double k) {
  static const auto points = kernels::gauss_legendre(60);
  double sum = 0.0;
  for (const auto& [at, weight] : points) {
    const double u = window_width * (at - 0.5);
    sum += weight * window_width * std::cos(k * u) * window(u);
  }
  return sum;
}

Nodes::Nodes(int factor, int first_cell, int cells) : factor_(factor) {
  for (int r = 0; r < factor; ++r) {
    const double u = (r - 0.5 * (factor - 1)) / factor;
    Phase phase{1 - window_width / 2 - (u < 0 ? 1 : 0), {}};
    for (int m = 0; m < window_width; ++m) phase.weights[m] = window(u - (phase.shift + m));
    phases_.push_back(phase);
  }
  first_ = 0;
  const int begin = place(first_cell), end = place(first_cell + cells - 1) + window_width;
  first_ = begin;
  count_ = end - begin;
}

int Nodes::place(int cell) const {
  const int a = floor_div(cell, factor_);
  return a + phases_[cell - a * factor_].shift - first_;
}

const std::array<double, window_width>& Nodes::weights(int cell) const {
  return phases_[cell - floor_div(cell, factor_) * factor_].weights;
}

NodeSpread::NodeSpread(int factor, const Box& cells)
    : x_(factor, cells.i0, cells.nx), y_(factor, cells.j0, cells.ny) {}

void NodeSpread::spread(const double* cells, const Box& box, double* nodes, int pitch) const {
  const int b0 = y_.place(box.j0), b1 = y_.place(box.j0 + box.ny - 1) + window_width;
  std::vector<double> row(b1 - b0);
  for (int i = 0; i < box.nx; ++i) {
    std::fill(row.begin(), row.end(), 0.0);
    const double* from = cells + static_cast<std::size_t>(i) * box.ny;
    bool any = false;
    for (int j = 0; j < box.ny; ++j) {
      if (from[j] == 0) continue;
      any = true;
      double* to = row.data() + y_.place(box.j0 + j) - b0;
      const auto& weights = y_.weights(box.j0 + j);
      for (int m = 0; m < window_width; ++m) to[m] += weights[m] * from[j];
    }
    if (!any) continue;
    const int a0 = x_.place(box.i0 + i);
    const auto& weights = x_.weights(box.i0 + i);
    for (int m = 0; m < window_width; ++m) {
      double* to = nodes + static_cast<std::size_t>(a0 + m) * pitch + b0;
      for (int b = 0; b < b1 - b0; ++b) to[b] += weights[m] * row[b];
    }
  }
}

void NodeSpread::gather(const double* nodes, int pitch, const Box& box, double* cells) const {
  const int b0 = y_.place(box.j0), b1 = y_.place(box.j0 + box.ny - 1) + window_width;
  std::vector<double> row(b1 - b0);
  for (int i = 0; i < box.nx; ++i) {
    std::fill(row.begin(), row.end(), 0.0);
    const int a0 = x_.place(box.i0 + i);
    const auto& weights = x_.weights(box.i0 + i);
    for (int m = 0; m < window_width; ++m) {
      const double* from = nodes + static_cast<std::size_t>(a0 + m) * pitch + b0;
      for (int b = 0; b < b1 - b0; ++b) row[b] += weights[m] * from[b];
    }
    double* to = cells + static_cast<std::size_t>(i) * box.ny;
    for (int j = 0; j < box.ny; ++j) {
      const double* from = row.data() + y_.place(box.j0 + j) - b0;
      const auto& along = y_.weights(box.j0 + j);
      for (int m = 0; m < window_width; ++m) to[j] += along[m] * from[m];
    }
  }
}

}  // namespace samcontact::operators
