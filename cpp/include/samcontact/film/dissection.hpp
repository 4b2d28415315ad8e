// SPDX-License-Identifier: GPL-3.0-or-later
// Order in which the cells of a grid are eliminated, by nested dissection: strips divide the grid,
// and are eliminated after the two halves (George, SIAM J. Numer. Anal. 10, 1973).
#pragma once

#include <vector>

#include "samcontact/film/star.hpp"

namespace samcontact::film {

/// Cells that are eliminated together.
struct Front {
  int first, count;           // places in the order
  std::vector<int> boundary;  // later places that they are coupled with, ascending
  std::vector<int> children;  // fronts before it, whose boundaries it contains
  int size() const { return count + static_cast<int>(boundary.size()); }
};

struct Dissection {
  std::vector<int> places;    // of the cells in the order
  std::vector<Front> fronts;  // in the order
};

/// reach: largest distance along x and along y of cells that are coupled [cells].
Dissection dissect(const Lattice& lattice, int reach);

}  // namespace samcontact::film
