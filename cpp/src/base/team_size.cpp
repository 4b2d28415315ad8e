// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/team.hpp"

#include <algorithm>

namespace samcontact {
namespace {

using std::chrono::milliseconds;

/// A thread that waited for more than this fraction of an interval has no processor of its own.
constexpr double late_fraction = 0.2;
/// Trials take at most the fraction 1 / trial_divisor of the time, which is the loss on a busy
/// machine.
constexpr int trial_divisor = 20;
constexpr milliseconds shortest_pause{200}, longest_pause{5000};

}  // namespace

void TeamSize::update(Time now, Span length, std::span<const Span> waited) {
  const auto late = static_cast<int>(std::ranges::count_if(waited, [&](Span span) {
    return static_cast<double>(span.count()) > late_fraction * static_cast<double>(length.count());
  }));
  if (late == 0) return try_more(now);
  size_ = std::max(1, size_ - late);
  next_try_ = now + std::clamp<Span>(trial_divisor * length, shortest_pause, longest_pause);
}

void TeamSize::try_more(Time now) {
  if (size_ < max_size_ && now >= next_try_) size_ = std::min(max_size_, 2 * size_);
}

}  // namespace samcontact
