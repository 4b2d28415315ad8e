// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/team.hpp"

#ifdef _OPENMP

#include <omp.h>

#ifdef __linux__
#include <fcntl.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace samcontact {
namespace {

using Clock = std::chrono::steady_clock;
using Span = TeamSize::Span;

constexpr std::chrono::milliseconds window{10};

bool keeps_number() {
  static const bool keeps = [] {
    const char* given = std::getenv("OMP_DYNAMIC");  // NOLINT(concurrency-mt-unsafe)
    const std::string_view text = given == nullptr ? "" : given;
    return text == "false" || text == "FALSE";
  }();
  return keeps;
}

/// More threads, as by a typing error in OMP_NUM_THREADS, would only wait for each other.
int max_threads() { return std::min(8 * omp_get_num_procs(), omp_get_thread_limit()); }

#ifdef __linux__

int own_id() { return gettid(); }

/// Total time for which a thread of this process was ready to run while others used the processors;
/// none if the system does not report it.
std::optional<Span> waited(int thread) {
  const std::string path = "/proc/self/task/" + std::to_string(thread) + "/schedstat";
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): a call of the system
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return std::nullopt;
  char text[96];  // nanoseconds of running, nanoseconds of waiting, time slices
  const ssize_t length = read(file, text, sizeof text);
  close(file);
  const char* const end = text + std::max<ssize_t>(length, 0);
  std::int64_t ran = 0, delay = 0;
  const auto first = std::from_chars(text, end, ran);
  if (first.ec != std::errc{} || first.ptr == end) return std::nullopt;
  if (std::from_chars(first.ptr + 1, end, delay).ec != std::errc{}) return std::nullopt;
  return Span(delay);
}

#else

int own_id() { return 0; }
std::optional<Span> waited(int) { return std::nullopt; }

#endif

/// Number of threads in the teams of one thread, adjusted to their waiting times.
class TeamControl {
 public:
  void enter() {
    if (depth_++ > 0) return;
    given_ = omp_get_max_threads();
    const int max_size = lost_ ? 1 : std::clamp(given_, 1, max_threads());
    if (max_size != size_.max_size()) size_ = TeamSize(max_size);
    omp_set_num_threads(size_.size());
    began_ += Clock::now() - left_;  // an interval counts the time inside teams only
  }

  void leave() {
    if (depth_ == 1) {
      adjust();
      omp_set_num_threads(lost_ ? 1 : given_);
      left_ = Clock::now();
    }
    --depth_;
  }

  void adjust() {
    if (depth_ == 0 || size_.max_size() == 1 || keeps_number()) return;
    // A region of one thread counts too: loops inside it share the work space of that thread.
    if (omp_get_level() > 0) return;
    const auto now = Clock::now();
    if (size_.size() == 1) {
      members_.clear();
      size_.try_more(now);
    } else if (std::ssize(members_) != size_.size()) {
      start_interval();
    } else if (now - began_ >= window) {
      end_interval(now);
    }
    omp_set_num_threads(size_.size());
  }

  void lose() {
    lost_ = true;
    size_ = TeamSize(1);
    omp_set_num_threads(1);
  }

 private:
  struct Member {
    int id;
    Span waited;
  };

  /// Ends an interval and adjusts the number of threads.
  void end_interval(Clock::time_point now) {
    std::vector<Span> spans;
    for (Member& member : members_) {
      const Span since = waited(member.id).value_or(member.waited);
      spans.push_back(since - member.waited);
      member.waited = since;
    }
    size_.update(now, now - began_, spans);
    began_ = now;
  }

  /// Starts the first interval of a team of another size, which may have other threads.
  void start_interval() {
    members_.assign(size_.size(), {});
#pragma omp parallel
    members_[omp_get_thread_num()].id = own_id();
    for (Member& member : members_) member.waited = waited(member.id).value_or(Span{});
    began_ = Clock::now();
  }

  int depth_ = 0;  // of nested teams: a law in Python may start its own
  int given_ = 1;
  TeamSize size_;
  bool lost_ = false;
  Clock::time_point began_, left_ = Clock::now();
  std::vector<Member> members_;
};

TeamControl& team_control() {
  static thread_local TeamControl one;
  return one;
}

}  // namespace

Team::Team() { team_control().enter(); }
Team::~Team() { team_control().leave(); }
SingleThread::SingleThread() : given_(omp_get_max_threads()) { omp_set_num_threads(1); }
SingleThread::~SingleThread() { omp_set_num_threads(given_); }
void adjust_team() { team_control().adjust(); }
void reset_team() { team_control().lose(); }

}  // namespace samcontact

#else

namespace samcontact {

Team::Team() = default;
Team::~Team() = default;
SingleThread::SingleThread() : given_(1) {}
SingleThread::~SingleThread() = default;
void adjust_team() {}
void reset_team() {}

}  // namespace samcontact

#endif
