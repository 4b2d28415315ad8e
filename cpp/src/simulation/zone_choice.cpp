// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/simulation/zone_choice.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "samcontact/fft/plan.hpp"
#include "samcontact/operators/kernel_bands.hpp"
#include "samcontact/operators/node_spread.hpp"

namespace samcontact::simulation {
namespace {

using operators::Band;
using operators::spacing;

/// Cells around what must be in a zone, and below it.
constexpr int margin = 1;

double padded(int cells) { return fft::good_even_size(cells + 2 * operators::near_range); }

double cost(const Box& zone) { return padded(zone.nx) * padded(zone.ny) * zone.nz; }

bool meet(const Box& a, const Box& b) { return !a.intersected(b).empty(); }

/// The box of both, where that is better than the two.
std::optional<Box> better_as_one(const Box& a, const Box& b) {
  const Box both = a.united(b);
  if (!meet(a, b) && cost(both) > cost(a) + cost(b)) return std::nullopt;
  return both;
}

/// The box around all columns that hang together with one, which are crossed out.
Box taken_out(Columns& columns, int i, int j) {
  const Box& window = columns.window;
  Box box;
  std::vector<std::array<int, 2>> border{{i, j}};
  const auto take = [&](int a, int b) {
    int& depth = columns.depth[static_cast<std::size_t>(a) * window.ny + b];
    if (depth == 0) return false;
    box = box.united({window.i0 + a, window.j0 + b, 1, 1, depth});
    depth = 0;
    return true;
  };
  take(i, j);
  while (!border.empty()) {
    const auto [a, b] = border.back();
    border.pop_back();
    for (int x = std::max(0, a - 1); x <= std::min(window.nx - 1, a + 1); ++x) {
      for (int y = std::max(0, b - 1); y <= std::min(window.ny - 1, b + 1); ++y) {
        if (take(x, y)) border.push_back({x, y});
      }
    }
  }
  return box;
}

}  // namespace

std::vector<Box> boxes_around(const Columns& columns) {
  Columns left = columns;
  std::vector<Box> boxes;
  const Box& window = columns.window;
  for (int i = 0; i < window.nx; ++i) {
    for (int j = 0; j < window.ny; ++j) {
      if (left.depth[static_cast<std::size_t>(i) * window.ny + j] == 0) continue;
      const Box box = taken_out(left, i, j);
      boxes.push_back({box.i0 - margin, box.j0 - margin, box.nx + 2 * margin, box.ny + 2 * margin,
                       box.nz + margin});
    }
  }
  return boxes;
}

std::vector<Box> merged(std::vector<Box> boxes) {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      std::size_t kept = k + 1;
      for (std::size_t l = k + 1; l < boxes.size(); ++l) {
        if (const auto one = better_as_one(boxes[k], boxes[l])) {
          boxes[k] = *one;
          again = true;
        } else {
          boxes[kept++] = boxes[l];
        }
      }
      boxes.resize(kept);
    }
  }
  return boxes;
}

double cost_of_zones(const std::vector<Box>& zones, const Box& surface) {
  Box all = surface;
  double sum = 0.0;
  for (const Box& zone : zones) {
    all = all.united(zone);
    sum += cost(zone);
  }
  const auto nodes = [](int cells, Band band) {
    return static_cast<double>(cells) / spacing(band) + 2 * operators::window_width;
  };
  const double middle = nodes(all.nx, Band::middle) * nodes(all.ny, Band::middle);
  const double far = (nodes(all.nx, Band::far) + operators::fading_nodes) *
                     (nodes(all.ny, Band::far) + operators::fading_nodes);
  return sum + (middle + 4 * far) * all.nz;
}

double cost_of_box(const Box& box) { return 4.0 * box.nx * box.ny * box.nz; }

}  // namespace samcontact::simulation
