// SPDX-License-Identifier: GPL-3.0-or-later
// Corner sums of a rectangle at many offsets, each corner evaluated once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "samcontact/base/aligned.hpp"
#include "samcontact/base/threads.hpp"
#include "samcontact/operators/influence/offsets.hpp"

namespace samcontact::operators {

/// Edges of cells at offsets, in half cells from the centre of the source, without repetition.
inline std::vector<int> edges_of(const std::vector<int>& offsets) {
  std::vector<int> edges;
  for (const int n : offsets) edges.insert(edges.end(), {2 * n - 1, 2 * n + 1});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Function of x and y at edges, [component][y][x]. exchanged: index of each component after x and
/// y are exchanged; half of the values of square cells then follow from the others.
template <std::size_t N, class Function>
Field values_at(const std::vector<int>& at_x, const std::vector<int>& at_y, double aspect,
                const std::array<std::size_t, N>* exchanged, const Function& function) {
  const std::size_t size = at_x.size() * at_y.size();
  const auto place_in = [](const std::vector<int>& edges, int edge) {
    const auto found = std::lower_bound(edges.begin(), edges.end(), edge);
    return found != edges.end() && *found == edge ? found - edges.begin() : std::ptrdiff_t{-1};
  };
  const bool symmetric = exchanged != nullptr && aspect == 1;
  Field values(N * size);
  // action(place, x, y, place of the equal value with x and y exchanged, or -1)
  const auto for_rows = [&](const auto& action) {
#pragma omp parallel for schedule(dynamic) if (100.0 * size > min_parallel_operations)
    for (std::ptrdiff_t row = 0; row < std::ssize(at_y); ++row) {
      const std::ptrdiff_t i = symmetric ? place_in(at_x, at_y[row]) : -1;
      for (std::size_t n = 0; n < at_x.size(); ++n) {
        const std::ptrdiff_t j = i >= 0 && at_x[n] < at_y[row] ? place_in(at_y, at_x[n]) : -1;
        action(row * at_x.size() + n, at_x[n], at_y[row], j < 0 ? j : j * std::ssize(at_x) + i);
      }
    }
  };
  for_rows([&](std::size_t at, int x, int y, std::ptrdiff_t known) {
    if (known >= 0) return;
    const std::array<double, N> f = function(0.5 * x, 0.5 * y * aspect);
    for (std::size_t c = 0; c < N; ++c) values[c * size + at] = f[c];
  });
  if (!symmetric) return values;
  for_rows([&](std::size_t at, int, int, std::ptrdiff_t known) {
    if (known < 0) return;
    for (std::size_t c = 0; c < N; ++c) {
      values[c * size + at] = values[(*exchanged)[c] * size + known];
    }
  });
  return values;
}

/// Corner sums of a cell of 1 by `aspect`, with each corner evaluated once however many cells share
/// it: [component][j][i] of the first `count` components. exchanged: see values_at.
template <std::size_t N, class Corner>
Field corner_sums(const CellOffsets& offsets, double aspect, int count, const Corner& corner,
                  const std::array<std::size_t, N>* exchanged = nullptr) {
  const std::vector<int> at_x = edges_of(offsets.x), at_y = edges_of(offsets.y);
  const std::size_t corners_size = at_x.size() * at_y.size();
  const Field corners = values_at<N>(at_x, at_y, aspect, exchanged, corner);
  // The upper edge follows the lower one.
  const auto lower_edges = [](const std::vector<int>& cells, const std::vector<int>& edges) {
    std::vector<std::size_t> places;
    places.reserve(cells.size());
    for (const int n : cells) {
      places.push_back(std::lower_bound(edges.begin(), edges.end(), 2 * n - 1) - edges.begin());
    }
    return places;
  };
  const auto from_x = lower_edges(offsets.x, at_x), from_y = lower_edges(offsets.y, at_y);
  Field sums(count * from_x.size() * from_y.size());
  const std::ptrdiff_t rows = count * std::ssize(from_y);
#pragma omp parallel for schedule(static) if (10.0 * sums.size() > min_parallel_operations)
  for (std::ptrdiff_t row = 0; row < rows; ++row) {
    const std::size_t c = row / from_y.size(), j = from_y[row % from_y.size()];
    const double* lower = corners.data() + c * corners_size + j * at_x.size();
    const double* upper = lower + at_x.size();
    double* sum = sums.data() + row * from_x.size();
    for (std::size_t n = 0; n < from_x.size(); ++n) {
      const std::size_t i = from_x[n];
      sum[n] = (upper[i + 1] - upper[i]) - (lower[i + 1] - lower[i]);
    }
  }
  return sums;
}

/// Corner sums of one component.
template <class Corner>
Field corner_sums(const CellOffsets& offsets, double aspect, const Corner& corner) {
  return corner_sums<1>(offsets, aspect, 1,
                        [&](double x, double y) { return std::array{corner(x, y)}; });
}

}  // namespace samcontact::operators
