// SPDX-License-Identifier: GPL-3.0-or-later
// The product for processors with AVX2 and FMA. Eigen has another name in this file, so that the
// linker does not choose its functions for other processors.
#include "samcontact/kernels/ring_product.hpp"  // IWYU pragma: keep

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
#include "ring_product_by_eigen.hpp"

namespace samcontact::kernels {
namespace {

struct AvxRings {};

}  // namespace

void ring_product_by_avx(const RingProduct& of, double* result) {
  ring_product_by_eigen<AvxRings>(of, result);
}

}  // namespace samcontact::kernels
#endif
