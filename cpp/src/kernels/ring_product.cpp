// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/kernels/ring_product.hpp"

#include "ring_product_by_eigen.hpp"
#include "samcontact/base/multiversion.hpp"

namespace samcontact::kernels {
namespace {

struct PortableRings {};

}  // namespace

void ring_product(const RingProduct& of, double* result) {
#if SAMCONTACT_HAS_VERSIONS
  if (has_avx()) return ring_product_by_avx(of, result);
#endif
  ring_product_by_eigen<PortableRings>(of, result);
}

}  // namespace samcontact::kernels
