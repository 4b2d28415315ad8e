// SPDX-License-Identifier: GPL-3.0-or-later
// Memory check by a host before a large allocation.
#pragma once

#include <string>

namespace samcontact {

/// Function that throws if there is not enough memory. Called from the thread that runs the solve.
using MemoryCheck = void (*)(double bytes, const std::string& what);

/// Installs the check; nullptr removes it.
void set_memory_check(MemoryCheck check);

/// Calls the installed check; `what` names the use of the memory.
void require_memory(double bytes, const std::string& what);

}  // namespace samcontact
