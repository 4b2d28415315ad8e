// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/operators/zones/node_spread.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "samcontact/base/multiversion.hpp"
#include "samcontact/kernels/gauss.hpp"

namespace samcontact::operators {
namespace {

double window(int width, double nodes) {
  const double u = nodes / (0.5 * width), steepness = 2.3 * width;
  return std::fabs(u) < 1 ? std::exp(steepness * (std::sqrt(1 - u * u) - 1)) : 0.0;
}

int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// Work space of one thread and one use, kept between calls.
template <int user>
double* scratch(std::size_t count) {
  static thread_local Field buffer;
  if (buffer.size() < count) buffer.resize(count);
  return buffer.data();
}

/// Calls work(integral constant) with the width of a window.
template <typename Work>
inline __attribute__((always_inline)) void with_width(int width, const Work& work) {
  switch (width) {
    case 4:
      return work(std::integral_constant<int, 4>());
    case 6:
      return work(std::integral_constant<int, 6>());
    case 8:
      return work(std::integral_constant<int, 8>());
    default:
      return work(std::integral_constant<int, 10>());
  }
}

/// Adds weighted sums of consecutive numbers.
SAMCONTACT_MULTIVERSION
void add_windows(const double* from, const double* w, int width, int count, double* to) {
  with_width(width, [=](auto n) __attribute__((always_inline)) {
    for (int t = 0; t < count; ++t) {
      double sum = w[0] * from[t];
      for (int m = 1; m < n; ++m) sum += w[m] * from[t + m];
      to[t] += sum;
    }
  });
}

SAMCONTACT_MULTIVERSION
void add_reversed_windows(const double* from, const double* w, int width, int count, double* to) {
  with_width(width, [=](auto n) __attribute__((always_inline)) {
    for (int t = 0; t < count; ++t) {
      double sum = w[n - 1] * from[t];
      for (int m = 1; m < n; ++m) sum += w[n - 1 - m] * from[t + m];
      to[t] += sum;
    }
  });
}

SAMCONTACT_MULTIVERSION
void add_to_rows(const double* row, const double* w, int width, int count, double* to,
                 std::ptrdiff_t pitch) {
  for (int m = 0; m < width; ++m, to += pitch) {
    for (int b = 0; b < count; ++b) to[b] += w[m] * row[b];
  }
}

SAMCONTACT_MULTIVERSION
void sum_of_rows(const double* from, std::ptrdiff_t pitch, const double* w, int width, int count,
                 double* row) {
  with_width(width, [=](auto n) __attribute__((always_inline)) {
    for (int b = 0; b < count; ++b) {
      double sum = 0.0;
      for (int m = 0; m < n; ++m) sum += w[m] * from[m * pitch + b];
      row[b] = sum;
    }
  });
}

}  // namespace

WindowTransform::WindowTransform(int width) {
  const auto points = kernels::gauss_legendre(60);
  // The window is even: half of the points suffice.
  for (std::size_t n = points.size() / 2; n < points.size(); ++n) {
    const double at = width * (points[n].at - 0.5);
    points_.emplace_back(at, points[n].weight * (width * window(width, at)));
  }
}

double WindowTransform::operator()(double k) const {
  double sum = 0.0;
  for (const auto& [at, weight] : points_) sum += 2 * weight * std::cos(k * at);
  return sum;
}

Nodes::Nodes(int factor, int width, int first_cell, int cells) : factor_(factor), width_(width) {
  for (int r = 0; r < factor; ++r) {
    const double u = (r - 0.5 * (factor - 1)) / factor;
    Phase phase{1 - width / 2 - (u < 0 ? 1 : 0), Field(width)};
    for (int m = 0; m < width; ++m) phase.weights[m] = window(width, u - (phase.shift + m));
    phases_.push_back(std::move(phase));
  }
  first_ = 0;
  const int begin = place(first_cell), end = place(first_cell + cells - 1) + width;
  first_ = begin;
  count_ = end - begin;
}

int Nodes::place(int cell) const {
  const int a = floor_div(cell, factor_);
  return a + phases_[cell - a * factor_].shift - first_;
}

const double* Nodes::weights(int cell) const {
  return phases_[cell - floor_div(cell, factor_) * factor_].weights.data();
}

NodeSpread::NodeSpread(int factor, int width, const Box& cells)
    : x_(factor, width, cells.i0, cells.nx), y_(factor, width, cells.j0, cells.ny) {}

// Cells of one phase are `factor` apart and contribute to consecutive nodes.

void Nodes::spread(const double* cells, int first_cell, int count, double* nodes) const {
  const int ends = width_ - 1;
  const int origin = place(first_cell);
  double* line = scratch<0>(count / factor_ + 1 + 2 * ends);
  std::fill_n(line, ends, 0.0);
  for (int r = 0; r < std::min(factor_, count); ++r) {
    const int n = (count - r + factor_ - 1) / factor_;
    for (int t = 0; t < n; ++t) line[ends + t] = cells[r + t * factor_];
    std::fill_n(line + ends + n, ends, 0.0);
    add_reversed_windows(line, weights(first_cell + r), width_, n + ends,
                         nodes + place(first_cell + r) - origin);
  }
}

void Nodes::gather(const double* nodes, int first_cell, int count, double* cells) const {
  const int origin = place(first_cell);
  double* line = scratch<0>(count / factor_ + 1);
  for (int r = 0; r < std::min(factor_, count); ++r) {
    const int n = (count - r + factor_ - 1) / factor_;
    std::fill_n(line, n, 0.0);
    add_windows(nodes + place(first_cell + r) - origin, weights(first_cell + r), width_, n, line);
    for (int t = 0; t < n; ++t) cells[r + t * factor_] += line[t];
  }
}

void NodeSpread::spread(const double* cells, int cell_pitch, const Box& box, double* nodes,
                        int pitch) const {
  const int b0 = y_.place(box.j0), width = y_.place(box.j0 + box.ny - 1) + y_.width() - b0;
  double* row = scratch<1>(width);
  for (int i = 0; i < box.nx; ++i) {
    const double* from = cells + static_cast<std::size_t>(i) * cell_pitch;
    if (std::all_of(from, from + box.ny, [](double v) { return v == 0; })) continue;
    std::fill_n(row, width, 0.0);
    y_.spread(from, box.j0, box.ny, row);
    add_to_rows(row, x_.weights(box.i0 + i), x_.width(), width,
                nodes + static_cast<std::size_t>(x_.place(box.i0 + i)) * pitch + b0, pitch);
  }
}

Box NodeSpread::reached(const Box& box) const {
  const int a0 = x_.place(box.i0), b0 = y_.place(box.j0);
  return {x_.first() + a0, y_.first() + b0, x_.place(box.i0 + box.nx - 1) + x_.width() - a0,
          y_.place(box.j0 + box.ny - 1) + y_.width() - b0, 1};
}

void NodeSpread::gather(const double* nodes, const Box& of, const Box& box, double* cells) const {
  const Box part = reached(box);
  double* row = scratch<1>(part.ny);
  for (int i = 0; i < box.nx; ++i) {
    const int a = x_.first() + x_.place(box.i0 + i) - of.i0;
    const double* from = nodes + static_cast<std::ptrdiff_t>(a) * of.ny + part.j0 - of.j0;
    sum_of_rows(from, of.ny, x_.weights(box.i0 + i), x_.width(), part.ny, row);
    y_.gather(row, box.j0, box.ny, cells + static_cast<std::size_t>(i) * box.ny);
  }
}

void NodeSpread::gather_first(const double* nodes, int nx, int ny, double* cells) const {
  double* row = scratch<1>(y_.count());
  for (int i = 0; i < nx; ++i) {
    const double* from = nodes + static_cast<std::ptrdiff_t>(x_.place(0) + i) * y_.count();
    sum_of_rows(from, y_.count(), x_.weights(0), x_.width(), y_.count(), row);
    add_windows(row + y_.place(0), y_.weights(0), y_.width(), ny, cells);
    cells += ny;
  }
}

}  // namespace samcontact::operators
