// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/interrupt.hpp"

#include <atomic>
#include <chrono>

#include "samcontact/base/team.hpp"

namespace samcontact {
namespace {

// Set by the host, once.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<InterruptCheck> installed_interrupt_check{nullptr};

// Separate for each thread.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
thread_local int uninterrupted = 0;

}  // namespace

Uninterrupted::Uninterrupted() { ++uninterrupted; }
Uninterrupted::~Uninterrupted() { --uninterrupted; }

void set_interrupt_check(InterruptCheck check) { installed_interrupt_check.store(check); }

void check_interrupt() {
  adjust_team();
  using Clock = std::chrono::steady_clock;
  // The check of the host takes its global lock: a call in every iteration of a small problem would
  // cost more than the iteration.
  static thread_local Clock::time_point last{};
  const InterruptCheck check = installed_interrupt_check.load(std::memory_order_relaxed);
  if (check == nullptr || uninterrupted > 0) return;
  const auto now = Clock::now();
  if (now - last < std::chrono::milliseconds(50)) return;
  last = now;
  check();
}

}  // namespace samcontact
