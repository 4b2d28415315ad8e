// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/base/aligned.hpp"

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

}  // namespace

void* allocate_bytes(std::size_t bytes) {
  void* p = ::operator new(bytes, alignment_of(bytes));
#ifdef __linux__
  // Advice only: without huge pages all works as before.
  if (bytes >= worth_huge_pages) madvise(p, bytes, MADV_HUGEPAGE);
#endif
  return p;
}

void deallocate_bytes(void* p, std::size_t bytes) { ::operator delete(p, alignment_of(bytes)); }

}  // namespace samcontact
