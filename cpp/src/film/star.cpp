// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/star.hpp"

#include <algorithm>
#include <utility>

namespace samcontact::film {
namespace {

/// Width of a strip that divides the grid, and the largest block that is not divided [cells].
constexpr int strip = 2, small_block = 16;

struct Block {
  int first_x, end_x, first_y, end_y;
  int along_x() const { return end_x - first_x; }
  int along_y() const { return end_y - first_y; }
};

/// Numbers the cells of blocks in the order in which they are eliminated.
class Dissection {
 public:
  explicit Dissection(const Lattice& lattice) : lattice_(lattice), places_(lattice.size()) {}

  void divide(const Block& block) {
    const auto [x0, x1, y0, y1] = block;
    const int longer = std::max(block.along_x(), block.along_y());
    if (block.along_x() * block.along_y() <= small_block || longer <= 2 * strip) {
      number(block);
    } else if (block.along_x() == longer) {
      const int middle = (x0 + x1 - strip) / 2;
      divide({x0, middle, y0, y1});
      divide({middle + strip, x1, y0, y1});
      number({middle, middle + strip, y0, y1});
    } else {
      const int middle = (y0 + y1 - strip) / 2;
      divide({x0, x1, y0, middle});
      divide({x0, x1, middle + strip, y1});
      number({x0, x1, middle, middle + strip});
    }
  }
  void number(const Block& block) {
    const bool rows_first = block.along_x() <= block.along_y();
    const int outer = rows_first ? block.along_y() : block.along_x();
    const int inner = rows_first ? block.along_x() : block.along_y();
    for (int a = 0; a < outer; ++a) {
      for (int b = 0; b < inner; ++b) {
        const int i = block.first_x + (rows_first ? b : a);
        const int j = block.first_y + (rows_first ? a : b);
        places_[lattice_.at(i, j)] = next_++;
      }
    }
  }
  std::vector<int> places() && { return std::move(places_); }

 private:
  const Lattice& lattice_;
  std::vector<int> places_;
  int next_ = 0;
};

}  // namespace

std::vector<int> elimination_places(const Lattice& lattice) {
  Dissection dissection(lattice);
  const int nx = lattice.nx(), ny = lattice.ny();
  const int first = lattice.wraps() && ny > 2 * strip ? strip : 0;
  dissection.divide({0, nx, first, ny});
  if (first > 0) dissection.number({0, nx, 0, first});
  return std::move(dissection).places();
}

Star::Star(const Lattice& lattice) : lattice_(lattice) {
  for (Field& values : values_) values.assign(lattice.size(), 0.0);
}

void Star::clear() {
  for (Field& values : values_) std::fill(values.begin(), values.end(), 0.0);
}

std::array<int, 2> Star::offset(int slot) {
  if (slot == 0) return {0, 0};
  const int along = (slot - 1) % 4, step = along < reach ? along - reach : along - reach + 1;
  return (slot - 1) / 4 == 0 ? std::array{step, 0} : std::array{0, step};
}

void Star::add_product(const Field& field, Field& sum) const {
#pragma omp parallel for schedule(static) if (lattice_.size() > 20'000)
  for (int i = 0; i < lattice_.nx(); ++i) {
    for (int slot = 0; slot < entries; ++slot) {
      const auto [di, dj] = offset(slot);
      if (i + di < 0 || i + di >= lattice_.nx()) continue;
      for (int j = 0; j < lattice_.ny(); ++j) {
        const std::ptrdiff_t from = lattice_.at(i + di, j + dj);
        if (from < 0) continue;
        const std::ptrdiff_t row = lattice_.at(i, j);
        sum[row] += values_[slot][row] * field[from];
      }
    }
  }
}

}  // namespace samcontact::film
