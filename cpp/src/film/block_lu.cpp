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

BlockLu::Parts BlockLu::parts(std::size_t front) {
  const Front& of = order_.fronts[front];
  const int rest = static_cast<int>(of.boundary.size());
  float* begin = factors_.data() + begins_[front];
  const DenseView own{begin, of.count, of.count, of.count};
  const DenseView below{own.column(of.count), rest, of.count, rest};
  return {own, below, {below.column(of.count), rest, of.count, rest}};
}

void BlockLu::store(const DenseView& dense, const Front& front, const Parts& to) {
  const int n = front.size();
  for (int j = 0; j < front.count; ++j) {
    std::copy_n(dense.column(j), front.count, to.own.column(j));
    std::copy(dense.column(j) + front.count, dense.column(j) + n, to.below.column(j));
  }
  for (int j = front.count; j < n; ++j) {
    const float* column = dense.column(j);
    for (int i = 0; i < front.count; ++i) to.right.column(i)[j - front.count] = column[i];
    stack_.insert(stack_.end(), column + front.count, column + n);
  }
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
  std::size_t needed = 0, largest = 0, stacked = 0, most_stacked = 0;
  for (const Front& front : order_.fronts) {
    begins_.push_back(needed);
    needed += static_cast<std::size_t>(front.count) * (front.count + 2 * front.boundary.size());
    largest = std::max<std::size_t>(largest, front.size());
    for (const int child : front.children) stacked -= square(order_.fronts[child].boundary.size());
    stacked += square(front.boundary.size());
    most_stacked = std::max(most_stacked, stacked);
  }
  factors_.resize(needed);
  front_.resize(square(largest));
  free_.resize(largest);
  stack_.clear();
  stack_.reserve(most_stacked);
  for (std::size_t f = 0; f < order_.fronts.size(); ++f) {
    const Front& front = order_.fronts[f];
    const int n = front.size();
    const DenseView dense{front_.data(), n, n, n};
    std::fill_n(front_.data(), square(n), 0.0F);
    assemble(matrix, front, dense);
    for (std::size_t c = front.children.size(); c-- > 0;) {
      const Front& of = order_.fronts[front.children[c]];
      const std::size_t begin = stack_.size() - square(of.boundary.size());
      extend(of, stack_.data() + begin, dense);
      stack_.resize(begin);
    }
    for (int i = 0; i < front.count; ++i) free_[i] = free[cells_[front.first + i]];
    exchanged_.resize(front.count);
    if (!eliminate(dense, free_.data(), exchanged_)) return false;
    std::copy(exchanged_.begin(), exchanged_.end(), pivots_.begin() + front.first);
    store(dense, front, parts(f));
  }
  return true;
}

void BlockLu::solve(Singles& x) {
  for (std::size_t cell = 0; cell < x.size(); ++cell) values_[order_.places[cell]] = x[cell];
  for (std::size_t f = 0; f < order_.fronts.size(); ++f) {
    const Front& front = order_.fronts[f];
    float* own = values_.data() + front.first;
    for (int i = 0; i < front.count; ++i) std::swap(own[i], own[pivots_[front.first + i]]);
    const Parts factors = parts(f);
    dense_products().substitute_forward(factors.own, own);
    part_.assign(factors.below.rows, 0.0F);
    dense_products().subtract_columns(factors.below, own, part_.data());
    for (std::size_t b = 0; b < front.boundary.size(); ++b) values_[front.boundary[b]] += part_[b];
  }
  for (std::size_t f = order_.fronts.size(); f-- > 0;) {
    const Front& front = order_.fronts[f];
    float* own = values_.data() + front.first;
    const Parts factors = parts(f);
    part_.assign(factors.right.rows, 0.0F);
    for (std::size_t b = 0; b < front.boundary.size(); ++b) part_[b] = values_[front.boundary[b]];
    dense_products().subtract_dots(factors.right, part_.data(), own);
    dense_products().substitute_backward(factors.own, own);
  }
  for (std::size_t cell = 0; cell < x.size(); ++cell) x[cell] = values_[order_.places[cell]];
}

}  // namespace samcontact::film
