// SPDX-License-Identifier: GPL-3.0-or-later
// Corner sums of a rectangle at many offsets, each corner evaluated once.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "samcontact/operators/periodic_sums.hpp"

namespace samcontact::operators {

/// The edges of cells at offsets, in half cells from the centre of the source, each once.
inline std::vector<int> edges_of(const std::vector<int>& offsets) {
  std::vector<int> edges;
  for (const int n : offsets) edges.insert(edges.end(), {2 * n - 1, 2 * n + 1});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Corner sums of a cell of 1 by `aspect`, each corner evaluated once however many cells share it:
/// [component][j][i] of the first `count` components.
template <std::size_t N, class Corner>
Field corner_sums(const CellOffsets& offsets, double aspect, int count, const Corner& corner) {
  const std::vector<int> at_x = edges_of(offsets.x), at_y = edges_of(offsets.y);
  const std::size_t corners_size = at_x.size() * at_y.size();
  Field corners(N * corners_size);
  std::size_t at = 0;
  for (const int y : at_y) {
    for (const int x : at_x) {
      const std::array<double, N> f = corner(0.5 * x, 0.5 * y * aspect);
      for (std::size_t c = 0; c < N; ++c) corners[c * corners_size + at] = f[c];
      ++at;
    }
  }
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
  Field sums;
  sums.reserve(count * from_x.size() * from_y.size());
  for (int c = 0; c < count; ++c) {
    for (const std::size_t j : from_y) {
      const double* lower = corners.data() + c * corners_size + j * at_x.size();
      const double* upper = lower + at_x.size();
      for (const std::size_t i : from_x) {
        sums.push_back((upper[i + 1] - upper[i]) - (lower[i + 1] - lower[i]));
      }
    }
  }
  return sums;
}

/// Of one component.
template <class Corner>
Field corner_sums(const CellOffsets& offsets, double aspect, const Corner& corner) {
  return corner_sums<1>(offsets, aspect, 1,
                        [&](double x, double y) { return std::array{corner(x, y)}; });
}

}  // namespace samcontact::operators
