// SPDX-License-Identifier: GPL-3.0-or-later
// Zones, and the plastic history in tiles.
#include <doctest/doctest.h>

#include "samcontact/simulation/strain/plastic_state.hpp"

using namespace samcontact;
using namespace samcontact::simulation;
using fft::Symmetry;
using operators::Tensor;

namespace {

/// Values that identify component and cell, of a deviator with one backstress.
PlasticFields numbered(const Zones& zones) {
  PlasticFields fields{zones, {}, {}, {}};
  double next = 1.0;
  for (auto [field, parts] :
       {std::pair{&fields.strain, 5}, {&fields.equivalent, 1}, {&fields.backstress, 5}}) {
    for (std::size_t n = 0; n < parts * zones.cells(); ++n) field->push_back(next++);
  }
  return fields;
}

/// 100 spots, far apart: 2 % of the surface.
Zones spots() {
  std::vector<Box> boxes;
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 4; ++b) boxes.push_back({1030 + 300 * a, 1024 + 300 * b, 29, 29, 4});
  }
  return Zones(boxes);
}

}  // namespace

TEST_CASE("cells of zones are numbered box by box") {
  const Zones zones({{-3, 2, 2, 3, 2}, {40, 2, 1, 1, 1}, {-1, 2, 30, 1, 4}});
  CHECK(zones.cells() == 12 + 1 + 120);
  CHECK(zones.around() == Box{-3, 2, 44, 3, 4});
  for (std::size_t n = 0; n < zones.cells(); ++n) {
    CHECK(zones.number(zones.cell(n)) == static_cast<std::ptrdiff_t>(n));
  }
  CHECK(zones.cell(12) == Cell{40, 2, 0});
  for (const Cell& outside : {Cell{-4, 2, 0}, {-1, 3, 0}, {-3, 2, 2}, {40, 2, 1}, {100, 100, 0}}) {
    CHECK(zones.number(outside) == -1);
  }
  CHECK(are_disjoint(zones.boxes()));
  CHECK_FALSE(are_disjoint({{0, 0, 20, 20, 1}, {19, 19, 3, 3, 5}}));
  const Zones both = covering(zones, Zones({{0, 0, 20, 20, 1}}), {-2, 0, 30, 100, 3});
  CHECK(are_disjoint(both.boxes()));
  for (const Cell& inside : {Cell{-2, 4, 1}, {27, 2, 2}, {19, 19, 0}})
    CHECK(both.number(inside) >= 0);
  CHECK(both.around() == Box{-2, 0, 30, 20, 3});
}

TEST_CASE("a history over several zones equals that over one") {
  const Box box{5, -20, 40, 30, 6};
  const PlasticFields whole = numbered(Zones({box}));
  const PlasticState once(nullptr, Symmetry::none, Tensor::deviator, whole, {}, {{3, 2}});
  // The same strain in pieces, one after the other.
  const Zones left({{5, -20, 13, 30, 6}}), right({{18, -20, 27, 11, 6}, {18, -9, 27, 19, 6}});
  const PlasticState half(nullptr, Symmetry::none, Tensor::deviator, once.fields(left), {},
                          {{3, 2}});
  CHECK(half.equivalent(right) == Field(right.cells(), 0.0));
  CHECK_FALSE(half.reaches_beyond(left));
  CHECK(once.reaches_beyond(left));
  const PlasticState twice(&half, Symmetry::none, Tensor::deviator, once.fields(right));
  CHECK(twice == once);
  CHECK(twice.box() == box);
  CHECK(twice.tiles().max_equivalent() == whole.equivalent.back());
  // The zones of the history contain all of it, and reproduce it.
  const Zones own = once.zones();
  CHECK(own.cells() == box.volume_size());
  CHECK(PlasticState(nullptr, Symmetry::none, Tensor::deviator, once.fields(own), {}, {{7, -20}}) ==
        once);
  // A moved history keeps its tiles.
  const auto moved = once.moved(5, -3);
  const Box there{10, -23, 40, 30, 6};
  CHECK(moved->fields(Zones({there})).backstress == whole.backstress);
  CHECK(moved->zones().count() == own.count());
  CHECK_FALSE(*moved == once);
  CHECK(*moved->moved(-5, 3) == once);
}

TEST_CASE("a periodic history returns to its cells after a period") {
  const int period = 40;
  const Box box{0, -3, period, 20, 4};
  const PlasticFields whole = numbered(Zones({box}));
  const PlasticState at(nullptr, Symmetry::none, Tensor::deviator, whole, {}, {{37, 5}, period});
  CHECK(at.fields(Zones({box})).backstress == whole.backstress);
  CHECK(at.zones().cells() == box.volume_size());
  CHECK(are_disjoint(at.zones().boxes()));
  const auto moved = at.moved(-7, 0);
  CHECK(moved->box() == box);
  const Box first{7, -3, period - 7, 20, 4}, last{0, -3, 7, 20, 4};
  CHECK(moved->strain(last.moved(period - 7, 0)) == at.strain(last));
  CHECK(moved->strain(first.moved(-7, 0)) == at.strain(first));
  CHECK(moved->strain(box.moved(-7, 0)) == whole.strain);
  CHECK_FALSE(*moved == at);
  CHECK(*moved->moved(7 + 3 * period, 0) == at);
  // Strain across the ends of the period.
  const Box part{10, 0, 12, 3, 2};
  const auto across = PlasticState(nullptr, Symmetry::none, Tensor::deviator,
                                   numbered(Zones({part})), {}, {{}, period})
                          .moved(23, 0);
  CHECK(across->box() == Box{0, 0, period, 3, 2});
  CHECK_FALSE(across->reaches_beyond(Zones({{33, 0, 7, 3, 2}, {0, 0, 5, 3, 2}})));
  CHECK(across->boxes_beyond(Zones({{33, 0, 7, 3, 2}})) == std::vector{Box{0, 0, 5, 3, 2}});
}

TEST_CASE("cells without history need no memory") {
  const Zones zones({{0, 0, 40, 40, 5}});
  const PlasticState some(nullptr, Symmetry::none, Tensor::deviator, numbered(zones));
  PlasticFields less = some.fields(zones);
  for (Field* field : {&less.strain, &less.equivalent, &less.backstress}) {
    for (std::size_t n = 0; n < field->size(); ++n) {
      if (zones.cell(n % zones.cells()).k > 1) (*field)[n] = 0;
    }
  }
  const PlasticState shallow(&some, Symmetry::none, Tensor::deviator, less);
  CHECK(shallow.tiles().bytes() == some.tiles().bytes() / 5 * 2);
  CHECK(shallow.box() == some.box());
  CHECK(shallow.strain(zones) == less.strain);
}

TEST_CASE("spots of a rough surface need memory for their own cells only, mirrored too") {
  const Grid grid(2048, 2048, 1.0, 1.0, 40, 1.0);
  const Zones zones = spots();
  const std::size_t bytes = 11 * sizeof(double) * zones.cells();
  const PlasticState quarter(nullptr, Symmetry::xy, Tensor::deviator, numbered(zones),
                             {1024, 1024, 1, 1, 1});
  CHECK(quarter.tiles().bytes() == bytes);
  const PlasticState half = quarter.unfolded(grid, Symmetry::y);
  const PlasticState all = half.unfolded(grid, Symmetry::none);
  CHECK(half.tiles().bytes() == 2 * bytes);
  CHECK(all.tiles().bytes() == 4 * bytes);
  CHECK(all == quarter.unfolded(grid, Symmetry::none));
  CHECK(all.box() == Box{89, 95, 1870, 1858, 4});
}

TEST_CASE("a mirror plane changes the sign of odd components, and copies its own cells once") {
  for (const int n : {8, 9}) {
    const Grid grid(n, n, 1.0, 1.0, 1, 1.0);
    const Box box{n / 2, n / 2, 3, 4, 1};
    const PlasticState quarter(nullptr, Symmetry::xy, Tensor::deviator, numbered(Zones({box})));
    const PlasticState all = quarter.unfolded(grid, Symmetry::none);
    const auto value = [&](int part, int i, int j) {
      const Box cell{i, j, 1, 1, 1};
      return part < 5 ? all.strain(cell)[part] : all.backstress(cell)[part - 5];
    };
    CHECK(all.tiles().max_strain() == quarter.tiles().max_strain());
    for (int p = 0; p < 10; ++p) {
      // xx, yy, yz, xz, xy
      const double x = p % 5 < 3 ? 1 : -1, y = p % 5 == 2 || p % 5 == 4 ? -1 : 1;
      for (int i = n / 2 + 1; i < n / 2 + 3; ++i) {
        for (int j = n / 2 + 1; j < n / 2 + 4; ++j) {
          const double v = value(p, i, j);
          CHECK(v > 0);
          CHECK(value(p, n - 1 - i, j) == x * v);
          CHECK(value(p, i, n - 1 - j) == y * v);
          CHECK(value(p, n - 1 - i, n - 1 - j) == x * y * v);
        }
      }
      CHECK(value(p, n / 2, n / 2) > 0);
    }
  }
}
