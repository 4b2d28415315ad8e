// SPDX-License-Identifier: GPL-3.0-or-later
// The product for processors with AVX2 and FMA.
#include "samcontact/kernels/ring_product.hpp"  // IWYU pragma: keep

#include "samcontact/base/eigen_for_avx.hpp"  // IWYU pragma: keep

#if SAMCONTACT_HAS_VERSIONS
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
