// SPDX-License-Identifier: GPL-3.0-or-later
// Marker of hot functions that are compiled for several instruction sets, one of which is chosen at
// load time, and test of the processor.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__gnu_linux__)
#define SAMCONTACT_HAS_VERSIONS 1
#define SAMCONTACT_MULTIVERSION \
  __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))

namespace samcontact {

/// Whether this processor has AVX2 and FMA, for sources that include eigen_for_avx.hpp.
inline bool has_avx() {
  static const bool found =
      __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  return found;
}

}  // namespace samcontact

#else
#define SAMCONTACT_HAS_VERSIONS 0
#define SAMCONTACT_MULTIVERSION
#endif
