// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/node_spread.hpp"

#include <algorithm>
#include <cmath>

#include "samcontact/base/multiversion.hpp"
#include "samcontact/kernels/gauss.hpp"

namespace samcontact::operators {
namespace {

constexpr double half_width = 0.5 * window_width, steepness = 2.3 * window_width;

double window(double nodes) {
  const double u = nodes / half_width;
  return std::fabs(u) < 1 ? std::exp(steepness * (std::sqrt(1 - u * u) - 1)) : 0.0;
}

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// Numbers of one thread and one user: what it has once taken stays with it.
template <int user>
double* scratch(std::size_t count) {
  static thread_local Field buffer;
  if (buffer.size() < count) buffer.resize(count);
  return buffer.data();
}

static_assert(window_width == 6);
/// Weighted sums of six numbers in a row are added.
SAMCONTACT_MULTIVERSION
void add_windows(const double* from, const double* w, int count, double* to) {
  for (int t = 0; t < count; ++t) {
    to[t] += w[0] * from[t] + w[1] * from[t + 1] + w[2] * from[t + 2] + w[3] * from[t + 3] +
             w[4] * from[t + 4] + w[5] * from[t + 5];
  }
}

SAMCONTACT_MULTIVERSION
void add_reversed_windows(const double* from, const double* w, int count, double* to) {
  for (int t = 0; t < count; ++t) {
    to[t] += w[5] * from[t] + w[4] * from[t + 1] + w[3] * from[t + 2] + w[2] * from[t + 3] +
             w[1] * from[t + 4] + w[0] * from[t + 5];
  }
}

SAMCONTACT_MULTIVERSION
void add_to_rows(const double* row, const double* w, int width, double* to, std::ptrdiff_t pitch) {
  for (int m = 0; m < window_width; ++m, to += pitch) {
    for (int b = 0; b < width; ++b) to[b] += w[m] * row[b];
  }
}

SAMCONTACT_MULTIVERSION
void sum_of_rows(const double* from, std::ptrdiff_t pitch, const double* w, int width,
                 double* row) {
  for (int b = 0; b < width; ++b) {
    double sum = 0.0;
    for (int m = 0; m < window_width; ++m) sum += w[m] * from[m * pitch + b];
    row[b] = sum;
  }
}

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
  constexpr int ends = window_width - 1;
  const int origin = place(first_cell);
  double* line = scratch<0>(count / factor_ + 1 + 2 * ends);
  std::fill_n(line, ends, 0.0);
  for (int r = 0; r < std::min(factor_, count); ++r) {
    const int n = (count - r + factor_ - 1) / factor_;
    for (int t = 0; t < n; ++t) line[ends + t] = cells[r + t * factor_];
    std::fill_n(line + ends + n, ends, 0.0);
    add_reversed_windows(line, weights(first_cell + r).data(), n + ends,
                         nodes + place(first_cell + r) - origin);
  }
}

void Nodes::gather(const double* nodes, int first_cell, int count, double* cells) const {
  const int origin = place(first_cell);
  double* line = scratch<0>(count / factor_ + 1);
  for (int r = 0; r < std::min(factor_, count); ++r) {
    const int n = (count - r + factor_ - 1) / factor_;
    std::fill_n(line, n, 0.0);
    add_windows(nodes + place(first_cell + r) - origin, weights(first_cell + r).data(), n, line);
    for (int t = 0; t < n; ++t) cells[r + t * factor_] += line[t];
  }
}

void NodeSpread::spread(const double* cells, int cell_pitch, const Box& box, double* nodes,
                        int pitch) const {
  const int b0 = y_.place(box.j0), width = y_.place(box.j0 + box.ny - 1) + window_width - b0;
  double* row = scratch<1>(width);
  for (int i = 0; i < box.nx; ++i) {
    const double* from = cells + static_cast<std::size_t>(i) * cell_pitch;
    if (std::all_of(from, from + box.ny, [](double v) { return v == 0; })) continue;
    std::fill_n(row, width, 0.0);
    y_.spread(from, box.j0, box.ny, row);
    add_to_rows(row, x_.weights(box.i0 + i).data(), width,
                nodes + static_cast<std::size_t>(x_.place(box.i0 + i)) * pitch + b0, pitch);
  }
}

Box NodeSpread::reached(const Box& box) const {
  const int a0 = x_.place(box.i0), b0 = y_.place(box.j0);
  return {x_.first() + a0, y_.first() + b0, x_.place(box.i0 + box.nx - 1) + window_width - a0,
          y_.place(box.j0 + box.ny - 1) + window_width - b0, 1};
}

void NodeSpread::gather(const double* nodes, const Box& of, const Box& box, double* cells) const {
  const Box part = reached(box);
  double* row = scratch<1>(part.ny);
  for (int i = 0; i < box.nx; ++i) {
    const int a = x_.first() + x_.place(box.i0 + i) - of.i0;
    const double* from = nodes + static_cast<std::ptrdiff_t>(a) * of.ny + part.j0 - of.j0;
    sum_of_rows(from, of.ny, x_.weights(box.i0 + i).data(), part.ny, row);
    y_.gather(row, box.j0, box.ny, cells + static_cast<std::size_t>(i) * box.ny);
  }
}

}  // namespace samcontact::operators
