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
  static const auto points = [] {
    auto nodes = kernels::gauss_legendre(60);
    for (auto& [at, weight] : nodes) {
      at = window_width * (at - 0.5);
      weight *= window_width * window(at);
    }
    return nodes;
  }();
  double sum = 0.0;
  // The window is even: half of the points.
  for (std::size_t n = points.size() / 2; n < points.size(); ++n) {
    sum += 2 * points[n].weight * std::cos(k * points[n].at);
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

// Cells of one phase are `factor` apart and reach nodes one after the other.

void Nodes::spread(const double* cells, int first_cell, int count, double* nodes) const {
  const int origin = place(first_cell);
  std::vector<double> line(count / factor_ + 1);
  for (int r = 0; r < std::min(factor_, count); ++r) {
    const auto& w = weights(first_cell + r);
    const int n = (count - r + factor_ - 1) / factor_;
    for (int t = 0; t < n; ++t) line[t] = cells[r + t * factor_];
    double* to = nodes + place(first_cell + r) - origin;
    for (int m = 0; m < window_width; ++m) {
      for (int t = 0; t < n; ++t) to[t + m] += w[m] * line[t];
    }
  }
}

void Nodes::gather(const double* nodes, int first_cell, int count, double* cells) const {
  const int origin = place(first_cell);
  for (int r = 0; r < std::min(factor_, count); ++r) {
    const auto& w = weights(first_cell + r);
    const int n = (count - r + factor_ - 1) / factor_;
    const double* from = nodes + place(first_cell + r) - origin;
    for (int t = 0; t < n; ++t) {
      double sum = 0.0;
      for (int m = 0; m < window_width; ++m) sum += w[m] * from[t + m];
      cells[r + t * factor_] += sum;
    }
  }
}

void NodeSpread::spread(const double* cells, int cell_pitch, const Box& box, double* nodes,
                        int pitch) const {
  const int b0 = y_.place(box.j0), width = y_.place(box.j0 + box.ny - 1) + window_width - b0;
  std::vector<double> row(width);
  for (int i = 0; i < box.nx; ++i) {
    const double* from = cells + static_cast<std::size_t>(i) * cell_pitch;
    if (std::all_of(from, from + box.ny, [](double v) { return v == 0; })) continue;
    std::fill(row.begin(), row.end(), 0.0);
    y_.spread(from, box.j0, box.ny, row.data());
    const auto& weights = x_.weights(box.i0 + i);
    for (int m = 0; m < window_width; ++m) {
      double* to = nodes + static_cast<std::size_t>(x_.place(box.i0 + i) + m) * pitch + b0;
      for (int b = 0; b < width; ++b) to[b] += weights[m] * row[b];
    }
  }
}

void NodeSpread::gather(const double* nodes, int pitch, const Box& box, double* cells) const {
  const int b0 = y_.place(box.j0), width = y_.place(box.j0 + box.ny - 1) + window_width - b0;
  std::vector<double> row(width);
  for (int i = 0; i < box.nx; ++i) {
    const double* from = nodes + static_cast<std::size_t>(x_.place(box.i0 + i)) * pitch + b0;
    const auto& w = x_.weights(box.i0 + i);
    for (int b = 0; b < width; ++b) {
      double sum = 0.0;
      for (int m = 0; m < window_width; ++m) sum += w[m] * from[m * pitch + b];
      row[b] = sum;
    }
    y_.gather(row.data(), box.j0, box.ny, cells + static_cast<std::size_t>(i) * box.ny);
  }
}

}  // namespace samcontact::operators
