// SPDX-License-Identifier: GPL-3.0-or-later
// The number of threads of parallel loops on a machine that has other work to do. A loop ends with
// its last thread: one that waits for a processor holds up all others for milliseconds.
#pragma once

#include <chrono>
#include <span>

namespace samcontact {

/// While it lives, the parallel loops of this thread have no more threads than find a processor of
/// their own: at most as many as OpenMP was asked for, which has its number back afterwards. Digits
/// do not depend on it. OMP_DYNAMIC=false keeps the number, and so does a system that does not tell
/// how long threads waited.
class Team {
 public:
  Team();
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
};

/// Adjusts the number of threads, at most every ten milliseconds. To be called between loops.
void adjust_team();

/// After a fork, in the child: OpenMP's threads are gone, and it would wait for them for ever. From
/// now on loops of this thread have one thread.
void lose_team();

/// How many threads to have next, by how long each of the present ones waited for a processor.
class TeamSize {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Span = std::chrono::nanoseconds;

  explicit TeamSize(int most = 1) : most_(most), size_(most) {}
  int most() const { return most_; }
  int size() const { return size_; }

  /// waited: of each thread in a window of some length that ends now. Those that waited for a large
  /// part of it are too many. More are tried after a pause, long enough for tries to take little of
  /// the time.
  void judge(Time now, Span length, std::span<const Span> waited);
  /// Of a single thread, which has no window.
  void try_more(Time now);

 private:
  int most_, size_;
  Time next_try_;
};

}  // namespace samcontact
