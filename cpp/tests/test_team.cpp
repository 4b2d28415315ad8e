// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <array>
#include <chrono>

#include "samcontact/base/team.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

using samcontact::TeamSize;
using namespace std::chrono_literals;

TEST_CASE("a team drops threads that wait for a processor") {
  TeamSize team(8);
  const TeamSize::Time now{};
  std::array<TeamSize::Span, 8> waited{};
  team.update(now, 10ms, waited);
  CHECK(team.size() == 8);
  waited[2] = waited[5] = waited[6] = 3ms;
  waited[7] = 1ms;  // a thread without benefit
  team.update(now, 10ms, waited);
  CHECK(team.size() == 5);
  waited.fill(9ms);
  team.update(now, 10ms, waited);
  CHECK(team.size() == 1);
}

TEST_CASE("a team tries more threads after a pause proportional to the cost of the last trial") {
  TeamSize team(8);
  TeamSize::Time now{};
  std::array<TeamSize::Span, 8> waited{};
  waited.fill(40ms);
  team.update(now, 50ms, waited);
  REQUIRE(team.size() == 1);
  team.try_more(now + 999ms);
  CHECK(team.size() == 1);
  now += 1s;
  team.try_more(now);
  CHECK(team.size() == 2);
  waited.fill(0ms);
  for (const int more : {4, 8, 8}) {  // the machine is idle again
    team.update(now += 10ms, 10ms, waited);
    CHECK(team.size() == more);
  }
}

#ifdef _OPENMP
TEST_CASE("a team keeps its size inside a parallel region, also in one of a single thread") {
  const int given = omp_get_max_threads();
  omp_set_num_threads(4);
  {
    const samcontact::Team team;
    int after = 0;
#pragma omp parallel num_threads(1)
    {
      omp_set_num_threads(1);
      samcontact::adjust_team();
      after = omp_get_max_threads();
    }
    CHECK(after == 1);
    samcontact::adjust_team();
    CHECK(omp_get_max_threads() == 4);
  }
  omp_set_num_threads(given);
}
#endif
