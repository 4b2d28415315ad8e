// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/memory.hpp"

#include <atomic>

namespace samcontact {
namespace {

// Set by the host, once.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<MemoryCheck> installed_memory_check{nullptr};

}  // namespace

void set_memory_check(MemoryCheck check) { installed_memory_check.store(check); }

void require_memory(double bytes, const std::string& what) {
  const MemoryCheck check = installed_memory_check.load(std::memory_order_relaxed);
  if (check != nullptr) check(bytes, what);
}

}  // namespace samcontact
