// SPDX-License-Identifier: GPL-3.0-or-later
// The products for processors with AVX2 and FMA. Eigen has another name in this file, so that the
// linker does not choose its functions for other processors.
#include "samcontact/film/dense_products.hpp"  // IWYU pragma: keep

#include "samcontact/base/multiversion.hpp"

#if SAMCONTACT_HAS_VERSIONS
#pragma GCC target("avx2,fma")
#define Eigen EigenForAvx
#include "dense_products_by_eigen.hpp"

namespace samcontact::film {
namespace {

struct Avx {};

}  // namespace

const DenseProducts& dense_products_by_avx() { return ByEigen<Avx>::products; }

}  // namespace samcontact::film
#endif
