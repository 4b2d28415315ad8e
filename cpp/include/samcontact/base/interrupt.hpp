// SPDX-License-Identifier: GPL-3.0-or-later
// Lets a host (an interpreter, a GUI) stop long work: the core calls back between iterations.
#pragma once

namespace samcontact {

/// A function that throws when the work should stop. Called from the thread that runs the solve.
using InterruptCheck = void (*)();

/// Installs the check; nullptr removes it.
void set_interrupt_check(InterruptCheck check);

/// Calls the installed check, at most about 20 times a second. Adjusts the team of threads.
void check_interrupt();

/// While it lives, this thread does not look: in a parallel loop, which must not throw.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
};

}  // namespace samcontact
