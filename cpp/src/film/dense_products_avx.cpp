// SPDX-License-Identifier: GPL-3.0-or-later
// The products for processors with AVX2 and FMA.
#include "samcontact/film/dense_products.hpp"  // IWYU pragma: keep

#include "samcontact/base/eigen_for_avx.hpp"  // IWYU pragma: keep

#if SAMCONTACT_HAS_VERSIONS
#include "dense_products_by_eigen.hpp"

namespace samcontact::film {
namespace {

struct Avx {};

}  // namespace

const DenseProducts& dense_products_by_avx() { return ByEigen<Avx>::products; }

}  // namespace samcontact::film
#endif
