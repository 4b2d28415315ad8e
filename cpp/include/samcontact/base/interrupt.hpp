// SPDX-License-Identifier: GPL-3.0-or-later
// Interruption of long work by a host (an interpreter, a GUI): the core calls a check of the host
// between iterations.
#pragma once

namespace samcontact {

/// Function that throws if the work should stop. Called from the thread that runs the solve.
using InterruptCheck = void (*)();

/// Installs the check; nullptr removes it.
void set_interrupt_check(InterruptCheck check);

/// Calls the installed check, at most about 20 times per second. Adjusts the number of threads.
void check_interrupt();

/// Suspends the check on this thread, for parallel loops, which must not throw.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
};

}  // namespace samcontact
