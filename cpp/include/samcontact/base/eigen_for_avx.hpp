// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles the rest of a source for processors with AVX2 and FMA. Eigen has another name there, so
// that the linker does not choose its functions for other processors. Headers with functions of
// our own must be included before this one, for the same reason.
#pragma once

#include "samcontact/base/multiversion.hpp"

#if SAMCONTACT_HAS_VERSIONS
#pragma GCC target("avx2,fma")
// Up to version 12, GCC expands macros before it reads the line above: Eigen would use half of each
// register.
#ifndef __AVX2__
#define __AVX__ 1
#define __AVX2__ 1
#define __FMA__ 1
#endif
#define Eigen EigenForAvx
#endif
