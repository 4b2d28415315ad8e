// SPDX-License-Identifier: GPL-3.0-or-later
// Number of threads of parallel loops on a machine with other work to do. A loop ends with its last
// thread: a single thread that waits for a processor delays all others by milliseconds.
#pragma once

#include <chrono>
#include <span>

namespace samcontact {

/// Limits the parallel loops of this thread, while it exists, to the number of threads that find a
/// free processor: at most the number that OpenMP was set to, which is restored afterwards. Digits
/// do not depend on it. The number is fixed if OMP_DYNAMIC=false, or if the system does not report
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

/// Restricts loops inside an iteration of a parallel loop, while it exists, to the thread of this
/// iteration, because they share its work space. By default OpenMP does so, but a user may allow
/// nested threads (OMP_MAX_ACTIVE_LEVELS, OMP_NUM_THREADS=4,2), and a team of one thread does not
/// count as a level.
class SingleThread {
 public:
  SingleThread();
  ~SingleThread();
  SingleThread(const SingleThread&) = delete;
  SingleThread& operator=(const SingleThread&) = delete;

 private:
  int given_;
};

/// Called in the child after a fork: the threads of OpenMP do not exist there, and OpenMP would
/// wait for them forever. From then on loops of this thread have one thread.
void reset_team();

/// Next number of threads, chosen from the time that each present thread waited for a processor.
class TeamSize {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Span = std::chrono::nanoseconds;

  explicit TeamSize(int max_size = 1) : max_size_(max_size), size_(max_size) {}
  int max_size() const { return max_size_; }
  int size() const { return size_; }

  /// waited: waiting time of each thread in an interval of the given length that ends now. Threads
  /// that waited for a large part of it are too many. A larger number is tried after a pause that
  /// is long enough for such trials to take little time.
  void update(Time now, Span length, std::span<const Span> waited);
  /// Counterpart for a single thread, for which no interval is measured.
  void try_more(Time now);

 private:
  int max_size_, size_;
  Time next_try_;
};

}  // namespace samcontact
