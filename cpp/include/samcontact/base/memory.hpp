// SPDX-License-Identifier: GPL-3.0-or-later
// Lets a host tell whether there is enough memory before much of it is taken.
#pragma once

#include <string>

namespace samcontact {

/// A function that throws when there is not. Called from the thread that runs the solve.
using MemoryCheck = void (*)(double bytes, const std::string& what);

/// Installs the check; nullptr removes it.
void set_memory_check(MemoryCheck check);

/// Calls the installed check; `what` needs the memory.
void require_memory(double bytes, const std::string& what);

}  // namespace samcontact
