// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of fields.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <random>
#include <vector>

#include "samcontact/base/aligned.hpp"

#ifdef __linux__
#include <unistd.h>
#endif

using namespace samcontact;

TEST_CASE("short-lived fields reuse memory, and never share it") {
  std::mt19937 random(1);  // NOLINT(bugprone-random-generator-seed): the same in every run
  // From less than the memory kept between solves to more than one region in all.
  std::uniform_int_distribution<std::size_t> sizes(1000, 1500000);
  std::uniform_int_distribution<int> coin(0, 2);
  std::vector<Field> fields;
  for (int step = 0; step < 160; ++step) {
    if (fields.size() > 24 || (coin(random) == 0 && !fields.empty())) {
      const auto which = fields.begin() + static_cast<std::ptrdiff_t>(random() % fields.size());
      const double mark = which->front();
      REQUIRE(which->back() == mark);
      REQUIRE(which->at(which->size() / 2) == mark);
      fields.erase(which);
    } else {
      Field field(sizes(random));
      REQUIRE(reinterpret_cast<std::uintptr_t>(field.data()) % 64 == 0);
      REQUIRE(std::all_of(field.begin(), field.end(), [](double v) { return v == 0.0; }));
      field.front() = field.back() = field[field.size() / 2] = step + 1.0;
      fields.push_back(std::move(field));
    }
  }
}

#ifdef __linux__
namespace {

/// Memory of this process [MB].
double resident() {
  std::ifstream file("/proc/self/statm");
  double all = 0, own = 0;
  file >> all >> own;
  return own * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace

TEST_CASE("large fields reuse released ones, which add little to the memory in use") {
  constexpr std::size_t bytes = 40'000'000;
  const double before = resident();
  std::vector<void*> fields;
  const auto take = [&](int count) {
    for (int n = 0; n < count; ++n) fields.push_back(allocate_bytes(bytes));
  };
  const auto release = [&](int count) {
    for (int n = 0; n < count; ++n) {
      deallocate_bytes(fields.back(), bytes);
      fields.pop_back();
    }
  };
  take(20);
  const double full = resident();
  CHECK(full - before > 600);  // some may have been kept before
  release(4);                  // a quarter of the memory in use
  CHECK(full - resident() < 10);
  take(4);
  CHECK(resident() - full < 10);
  release(8);
  CHECK(full - resident() > 150);
  const double partly = resident();
  release_kept_memory();
  CHECK(partly - resident() > 75);
  release(12);
  CHECK(resident() - before < 150);
}
#endif
