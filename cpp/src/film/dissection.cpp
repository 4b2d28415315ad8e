// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/dissection.hpp"

#include <algorithm>
#include <utility>

namespace samcontact::film {
namespace {

/// Largest block that is not divided [cells].
constexpr int small_block = 36;

struct Block {
  int first_x, end_x, first_y, end_y;
  int along_x() const { return end_x - first_x; }
  int along_y() const { return end_y - first_y; }
};

/// Numbers the cells of blocks in the order in which they are eliminated.
class Divider {
 public:
  Divider(const Lattice& lattice, int reach) : lattice_(lattice), reach_(reach) {
    found_.places.resize(lattice.size());
  }

  /// Returns the front that is eliminated last.
  int divide(const Block& block) {
    const auto [x0, x1, y0, y1] = block;
    const int longer = std::max(block.along_x(), block.along_y());
    if (block.along_x() * block.along_y() <= small_block || longer <= 2 * reach_) {
      return number(block, {});
    }
    if (block.along_x() == longer) {
      const int middle = (x0 + x1 - reach_) / 2;
      const int left = divide({x0, middle, y0, y1});
      const int right = divide({middle + reach_, x1, y0, y1});
      return number({middle, middle + reach_, y0, y1}, {left, right});
    }
    const int middle = (y0 + y1 - reach_) / 2;
    const int left = divide({x0, x1, y0, middle});
    const int right = divide({x0, x1, middle + reach_, y1});
    return number({x0, x1, middle, middle + reach_}, {left, right});
  }
  int number(const Block& block, std::vector<int> children) {
    const int first = next_;
    const bool rows_first = block.along_x() <= block.along_y();
    const int outer = rows_first ? block.along_y() : block.along_x();
    const int inner = rows_first ? block.along_x() : block.along_y();
    for (int a = 0; a < outer; ++a) {
      for (int b = 0; b < inner; ++b) {
        const int i = block.first_x + (rows_first ? b : a);
        const int j = block.first_y + (rows_first ? a : b);
        found_.places[lattice_.at(i, j)] = next_++;
      }
    }
    found_.fronts.push_back({first, next_ - first, {}, std::move(children)});
    return static_cast<int>(found_.fronts.size()) - 1;
  }
  Dissection found() && { return std::move(found_); }

 private:
  const Lattice& lattice_;
  int reach_;
  Dissection found_;
  int next_ = 0;
};

void find_boundaries(const Lattice& lattice, int reach, Dissection& order) {
  std::vector<int> cells(lattice.size()), seen_by(lattice.size(), -1);
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    cells[order.places[cell]] = static_cast<int>(cell);
  }
  for (std::size_t f = 0; f < order.fronts.size(); ++f) {
    Front& front = order.fronts[f];
    const auto meet = [&](int place) {
      if (place < front.first + front.count || seen_by[place] == static_cast<int>(f)) return;
      seen_by[place] = static_cast<int>(f);
      front.boundary.push_back(place);
    };
    for (const int child : front.children) {
      for (const int place : order.fronts[child].boundary) meet(place);
    }
    for (int place = front.first; place < front.first + front.count; ++place) {
      const int i = cells[place] / lattice.ny(), j = cells[place] % lattice.ny();
      for (int a = -reach; a <= reach; ++a) {
        for (int b = -reach; b <= reach; ++b) {
          const std::ptrdiff_t at = lattice.at(i + a, j + b);
          if (at >= 0) meet(order.places[at]);
        }
      }
    }
    std::sort(front.boundary.begin(), front.boundary.end());
  }
}

}  // namespace

Dissection dissect(const Lattice& lattice, int reach) {
  Divider divider(lattice, reach);
  const int nx = lattice.nx(), ny = lattice.ny();
  const int first = lattice.wraps() && ny > 2 * reach ? reach : 0;
  const int last = divider.divide({0, nx, first, ny});
  if (first > 0) divider.number({0, nx, 0, first}, {last});
  Dissection order = std::move(divider).found();
  find_boundaries(lattice, reach, order);
  return order;
}

}  // namespace samcontact::film
