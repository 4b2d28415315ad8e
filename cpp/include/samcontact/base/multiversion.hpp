// SPDX-License-Identifier: GPL-3.0-or-later
// Marker of hot functions that are compiled for several instruction sets, one of which is chosen at
// load time.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__gnu_linux__)
#define SAMCONTACT_HAS_VERSIONS 1
#define SAMCONTACT_MULTIVERSION \
  __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define SAMCONTACT_HAS_VERSIONS 0
#define SAMCONTACT_MULTIVERSION
#endif
