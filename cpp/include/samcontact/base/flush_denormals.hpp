// SPDX-License-Identifier: GPL-3.0-or-later
// Flushing of denormal numbers (below 1e-308) to zero on this thread: arithmetic with denormal
// numbers is a hundred times slower, and a decaying recursion produces many of them.
#pragma once

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace samcontact {

class FlushDenormals {
 public:
#ifdef __SSE2__
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
  ~FlushDenormals() { _mm_setcsr(before_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned before_;
#endif
};

}  // namespace samcontact
