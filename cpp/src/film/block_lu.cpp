// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/block_lu.hpp"

#include <algorithm>
#include <utility>

namespace samcontact::film {
namespace {

std::size_t square(std::size_t n) { return n * n; }

}  // namespace

BlockLu::BlockLu(const Lattice& lattice, int reach)
    : order_(dissect(lattice, reach)),
      cells_(lattice.size()),
      pivots_(lattice.size()),
      local_(lattice.size()),
      values_(lattice.size()) {
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    cells_[order_.places[cell]] = static_cast<int>(cell);
  }
}

DenseView BlockLu::lower(std::size_t front) const {
  const Front& of = order_.fronts[front];
  return {const_cast<float*>(factors_.data()) + begins_[front], of.size(), of.count, of.size()};
}

DenseView BlockLu::right(std::size_t front) const {
  const Front& of = order_.fronts[front];
  const DenseView below = lower(front);
  return {below.column(of.count), of.count, of.size() - of.count, of.count};
}

void BlockLu::assemble(const NearMatrix& matrix, const Front& front, const DenseView& dense) {
  const Lattice& lattice = matrix.lattice();
  const int end = front.first + front.count, last = matrix.width() - 1;
  for (int place = front.first; place < end; ++place) local_[place] = place - front.first;
  for (std::size_t b = 0; b < front.boundary.size(); ++b) {
    local_[front.boundary[b]] = front.count + static_cast<int>(b);
  }
  for (int place = front.first; place < end; ++place) {
    const int cell = cells_[place], own = place - front.first;
    const int i = cell / lattice.ny(), j = cell % lattice.ny();
    const float* row = matrix.row(cell);
    int slot = 0;
    for (int a = -matrix.reach(); a <= matrix.reach(); ++a) {
      for (int b = -matrix.reach_y(); b <= matrix.reach_y(); ++b, ++slot) {
        const std::ptrdiff_t at = lattice.at(i + a, j + b);
        if (at < 0) continue;
        const int other = order_.places[at];
        if (other < front.first) continue;
        dense.column(local_[other])[own] += row[slot];
        if (other >= end) dense.column(own)[local_[other]] += matrix.row(at)[last - slot];
      }
    }
  }
}

void BlockLu::extend(const Front& child, const float* complement, const DenseView& dense) {
  const std::size_t n = child.boundary.size();
  for (std::size_t b = 0; b < n; ++b, complement += n) {
    float* column = dense.column(local_[child.boundary[b]]);
    for (std::size_t a = 0; a < n; ++a) column[local_[child.boundary[a]]] += complement[a];
  }
}

bool BlockLu::decompose(const NearMatrix& matrix, const std::vector<char>& free) {
  begins_.clear();
  std::size_t needed = 0, largest = 0;
  for (const Front& front : order_.fronts) {
    begins_.push_back(needed);
    needed += static_cast<std::size_t>(front.count) * (2 * front.size() - front.count);
    largest = std::max<std::size_t>(largest, front.size());
  }
  factors_.resize(needed);
  front_.resize(square(largest));
  free_.resize(largest);
  stack_.clear();
  for (std::size_t f = 0; f < order_.fronts.size(); ++f) {
    const Front& front = order_.fronts[f];
    const int n = front.size(), rest = n - front.count;
    const DenseView dense{front_.data(), n, n, n};
    std::fill_n(front_.data(), square(n), 0.0F);
    assemble(matrix, front, dense);
    for (auto child = front.children.rbegin(); child != front.children.rend(); ++child) {
      const Front& of = order_.fronts[*child];
      const std::size_t begin = stack_.size() - square(of.boundary.size());
      extend(of, stack_.data() + begin, dense);
      stack_.resize(begin);
    }
    for (int i = 0; i < front.count; ++i) free_[i] = free[cells_[front.first + i]];
    exchanged_.resize(front.count);
    if (!eliminate(dense, free_.data(), exchanged_, blocks_)) return false;
    std::copy(exchanged_.begin(), exchanged_.end(), pivots_.begin() + front.first);
    std::copy_n(front_.data(), static_cast<std::size_t>(n) * front.count, lower(f).values);
    const DenseView across = right(f);
    for (int j = 0; j < rest; ++j) {
      const float* column = dense.column(front.count + j);
      std::copy_n(column, front.count, across.column(j));
      stack_.insert(stack_.end(), column + front.count, column + n);
    }
  }
  return true;
}

void BlockLu::solve(std::vector<float>& x) {
  for (std::size_t cell = 0; cell < x.size(); ++cell) values_[order_.places[cell]] = x[cell];
  for (std::size_t f = 0; f < order_.fronts.size(); ++f) {
    const Front& front = order_.fronts[f];
    float* own = values_.data() + front.first;
    for (int i = 0; i < front.count; ++i) std::swap(own[i], own[pivots_[front.first + i]]);
    part_.assign(front.size(), 0.0F);
    std::copy_n(own, front.count, part_.data());
    substitute_forward(lower(f), part_.data());
    std::copy_n(part_.data(), front.count, own);
    const float* change = part_.data() + front.count;
    for (std::size_t b = 0; b < front.boundary.size(); ++b) values_[front.boundary[b]] += change[b];
  }
  for (std::size_t f = order_.fronts.size(); f-- > 0;) {
    const Front& front = order_.fronts[f];
    float* own = values_.data() + front.first;
    part_.resize(front.boundary.size());
    for (std::size_t b = 0; b < part_.size(); ++b) part_[b] = values_[front.boundary[b]];
    subtract_product(right(f), part_.data(), own);
    substitute_backward(lower(f).part(0, front.count, 0, front.count), own);
  }
  for (std::size_t cell = 0; cell < x.size(); ++cell) x[cell] = values_[order_.places[cell]];
}

}  // namespace samcontact::film
