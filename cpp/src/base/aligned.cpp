// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/aligned.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace samcontact {
namespace {

constexpr std::size_t line = 64, small_page = 4096;
constexpr std::size_t huge_page = std::size_t{1} << 21;
constexpr std::size_t worth_huge_pages = 2 * huge_page;

std::align_val_t alignment_of(std::size_t bytes) {
  return std::align_val_t{bytes >= worth_huge_pages ? huge_page : line};
}

void* from_system(std::size_t bytes) {
  void* p = ::operator new(bytes, alignment_of(bytes));
#ifdef __linux__
  // A hint only: everything works without huge pages.
  if (bytes >= worth_huge_pages) madvise(p, bytes, MADV_HUGEPAGE);
#endif
  return p;
}

/// The system clears a page on its first write: for large blocks all threads share this work.
/// Dynamic schedule: on a virtual machine some pages cost a hundred times as much as others.
void touch(char* p, std::size_t bytes) {
  if (bytes < worth_huge_pages) return;
#pragma omp parallel for schedule(dynamic, huge_page / small_page)
  for (std::size_t at = 0; at < bytes; at += small_page) p[at] = 0;
}

void to_system(void* p, std::size_t bytes) { ::operator delete(p, alignment_of(bytes)); }

/// Keeps released fields that are too large for a region, for further fields of nearly the same
/// size: increments and iterations allocate fields of the same sizes again and again, and the
/// system would clear all their pages. Together with the fields in use they never take more memory
/// than the fields in use have taken before, and at most a quarter of that in use at the time.
class Spare {
 public:
  Spare() { kept_.reserve(max_kept); }  // a release must not ask for memory

  static bool suits(std::size_t bytes) { return bytes > smallest; }

  /// A kept field, or null after there is room for a new one.
  void* take(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Block& block) {
      return block.bytes >= bytes && block.bytes - bytes <= bytes / 8;
    });
    if (found == kept_.end()) {
      reduce_to(std::max(most_used_, used_ + bytes) - used_ - bytes);
      return nullptr;
    }
    void* const p = found->p;
    sum_ -= found->bytes;
    kept_.erase(found);
    used_ += bytes;
    return p;
  }
  /// Counts a new field.
  void add(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    used_ += bytes;
    most_used_ = std::max(most_used_, used_);
  }
  void give_back(void* p, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    used_ -= bytes;
    const std::size_t limit = std::max(always_kept, used_ / 4);
    const bool fits = bytes <= limit;
    reduce_to(fits ? limit - bytes : limit);
    if (!fits || kept_.size() == max_kept) return to_system(p, bytes);
    kept_.push_back({p, bytes});
    sum_ += bytes;
  }
  void release(std::size_t bytes = std::numeric_limits<std::size_t>::max()) {
    const std::lock_guard lock(mutex_);
    reduce_to(sum_ - std::min(bytes, sum_));
  }

  void lock() { mutex_.lock(); }
  void unlock() { mutex_.unlock(); }

 private:
  struct Block {
    void* p;
    std::size_t bytes;
  };
  static constexpr std::size_t smallest = std::size_t{1} << 24, always_kept = std::size_t{1} << 27;
  static constexpr std::size_t max_kept = 256;

  /// Releases the fields that have been kept longest.
  void reduce_to(std::size_t limit) {
    auto end = kept_.begin();
    for (; sum_ > limit; ++end) {
      to_system(end->p, end->bytes);
      sum_ -= end->bytes;
    }
    kept_.erase(kept_.begin(), end);
  }

  std::mutex mutex_;
  std::vector<Block> kept_;  // the last one released at the end
  std::size_t sum_ = 0;      // bytes of the fields kept
  std::size_t used_ = 0, most_used_ = 0;
};

/// Never destroyed: fields may outlive every static object.
Spare& spare() {
  static auto* const one = new Spare;  // NOLINT(cppcoreguidelines-owning-memory)
  return *one;
}

/// Fields placed side by side in regions on huge pages. A solve allocates dozens of fields; the
/// system would hand out and clear every small page of each, up to a third of the time of a first
/// solve. Regions without fields are kept for the next solve, and all but one of them are released
/// before the system is asked for a large field, which adds nothing to the maximum memory.
class Regions {
 public:
  /// Smaller fields cost little, and larger ones deserve huge pages of their own: few of them would
  /// fit into a region, and would leave much of it empty.
  static bool suits(std::size_t bytes) { return bytes >= smallest && bytes <= largest; }

  /// Null if the system has no memory for a region.
  void* take(std::size_t bytes) {
    const std::size_t length = rounded(bytes);
    const std::lock_guard lock(mutex_);
    for (auto& [start, holes] : regions_) {
      if (char* p = from_holes(start, holes, length)) return p;
    }
    try {
      spare().release(region);
      char* start = static_cast<char*>(from_system(region));
      return from_holes(start, regions_[start] = {{0, region}}, length);
    } catch (const std::bad_alloc&) {
      return nullptr;
    }
  }

  /// False if the block is in no region.
  bool give_back(void* p, std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    auto at = regions_.upper_bound(static_cast<char*>(p));
    if (at == regions_.begin()) return false;
    --at;
    const std::size_t offset = static_cast<char*>(p) - at->first;
    if (offset >= region) return false;
    Holes& holes = at->second;
    auto hole = holes.emplace(offset, rounded(bytes)).first;
    const auto next = std::next(hole);
    if (next != holes.end() && hole->first + hole->second == next->first) {
      hole->second += next->second;
      holes.erase(next);
    }
    if (hole != holes.begin()) {
      const auto before = std::prev(hole);
      if (before->first + before->second == hole->first) {
        before->second += hole->second;
        holes.erase(hole);
        hole = before;
      }
    }
    if (hole->second == region) release_empty(max_empty);
    return true;
  }
  void release_all_but_one() {
    const std::lock_guard lock(mutex_);
    release_empty(1);
  }

  void lock() { mutex_.lock(); }
  void unlock() { mutex_.unlock(); }

 private:
  using Holes = std::map<std::size_t, std::size_t>;  // offset and length, ascending, none touching

  static constexpr std::size_t smallest = std::size_t{1} << 16, largest = std::size_t{1} << 24;
  static constexpr std::size_t region = std::size_t{1} << 27;
  /// A solve with inclusions far from the contact fills two regions.
  static constexpr int max_empty = 2;

  /// Leaves one cache line between fields, so that equal indices do not compete for one cache set.
  static std::size_t rounded(std::size_t bytes) { return (bytes + 2 * line - 1) / line * line; }

  static char* from_holes(char* start, Holes& holes, std::size_t length) {
    for (auto hole = holes.begin(); hole != holes.end(); ++hole) {
      const auto [offset, room] = *hole;
      if (room < length) continue;
      holes.erase(hole);
      if (room > length) holes.emplace(offset + length, room - length);
      return start + offset;
    }
    return nullptr;
  }

  /// Releases empty regions except the first ones.
  void release_empty(int kept) {
    for (auto at = regions_.begin(); at != regions_.end();) {
      const bool empty = !at->second.empty() && at->second.begin()->second == region;
      if (!empty || kept-- > 0) {
        ++at;
        continue;
      }
      to_system(at->first, region);
      at = regions_.erase(at);
    }
  }

  std::mutex mutex_;
  std::map<char*, Holes> regions_;  // by start address
};

/// Never destroyed: fields may outlive every static object.
Regions& regions() {
  static auto* const one = new Regions;  // NOLINT(cppcoreguidelines-owning-memory)
  return *one;
}

#if defined(SAMCONTACT_SANITIZE)  // which would not detect the use of a freed field
constexpr bool with_regions = false;
#else
constexpr bool with_regions = true;
#endif

}  // namespace

void lock_memory() {
  regions().lock();
  spare().lock();
}
void unlock_memory() {
  spare().unlock();
  regions().unlock();
}

void release_kept_memory() { spare().release(); }

void* allocate_bytes(std::size_t bytes) {
  void* p = with_regions && Regions::suits(bytes) ? regions().take(bytes) : nullptr;
  const bool kept_later = with_regions && Spare::suits(bytes);
  if (kept_later) {
    // The pages of a kept field have been cleared before.
    if (void* kept = spare().take(bytes)) return kept;
  }
  if (p == nullptr) {
    if (bytes >= worth_huge_pages) regions().release_all_but_one();
    try {
      p = from_system(bytes);
    } catch (const std::bad_alloc&) {  // memory may be limited
      spare().release();
      p = from_system(bytes);
    }
    if (kept_later) spare().add(bytes);
  }
  touch(static_cast<char*>(p), bytes);
  return p;
}

void deallocate_bytes(void* p, std::size_t bytes) {
  if (with_regions && Regions::suits(bytes) && regions().give_back(p, bytes)) return;
  if (with_regions && Spare::suits(bytes)) return spare().give_back(p, bytes);
  to_system(p, bytes);
}

}  // namespace samcontact
