// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/aligned.hpp"

#include <map>
#include <mutex>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace samcontact {
namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;
constexpr std::size_t worth_huge_pages = 2 * huge_page;

std::align_val_t alignment_of(std::size_t bytes) {
  return std::align_val_t{bytes >= worth_huge_pages ? huge_page : 64};
}

void* fresh(std::size_t bytes) {
  void* p = ::operator new(bytes, alignment_of(bytes));
#ifdef __linux__
  // Advice only: without huge pages all works as before.
  if (bytes >= worth_huge_pages) madvise(p, bytes, MADV_HUGEPAGE);
#endif
  return p;
}

/// Freed blocks for the next field of that size. A solve makes the same few fields as the one
/// before; the system would clear every page of them anew, a tenth of the time of a solve.
class FreedBlocks {
 public:
  /// Smaller ones cost little, and larger ones are worth more than the time.
  static bool suits(std::size_t bytes) { return bytes >= smallest && bytes <= most / 4; }

  void* take(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    const auto found = blocks_.find(bytes);
    if (found == blocks_.end()) return nullptr;
    void* p = found->second;
    blocks_.erase(found);
    kept_ -= bytes;
    return p;
  }

  void keep(void* p, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    if (kept_ + bytes > most) release();  // of sizes that may not come again
    blocks_.emplace(bytes, p);
    kept_ += bytes;
  }

  void clear() {
    const std::lock_guard lock(mutex_);
    release();
  }

 private:
  static constexpr std::size_t smallest = std::size_t{1} << 16, most = std::size_t{1} << 25;

  void release() {
    for (const auto& [bytes, p] : blocks_) ::operator delete(p, alignment_of(bytes));
    blocks_.clear();
    kept_ = 0;
  }

  std::mutex mutex_;
  std::multimap<std::size_t, void*> blocks_;
  std::size_t kept_ = 0;
};

/// Never destroyed: fields may outlive every static object.
FreedBlocks& freed_blocks() {
  static auto* const blocks = new FreedBlocks;  // NOLINT(cppcoreguidelines-owning-memory)
  return *blocks;
}

}  // namespace

void* allocate_bytes(std::size_t bytes) {
  if (FreedBlocks::suits(bytes)) {
    if (void* p = freed_blocks().take(bytes)) return p;
  }
  try {
    return fresh(bytes);
  } catch (const std::bad_alloc&) {
    freed_blocks().clear();  // blocks of other sizes may be all that is missing
    return fresh(bytes);
  }
}

void deallocate_bytes(void* p, std::size_t bytes) {
#if !defined(__SANITIZE_ADDRESS__)  // which would not see the use of a freed field
  if (FreedBlocks::suits(bytes)) {
    freed_blocks().keep(p, bytes);
    return;
  }
#endif
  ::operator delete(p, alignment_of(bytes));
}

}  // namespace samcontact
