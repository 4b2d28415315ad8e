// SPDX-License-Identifier: GPL-3.0-or-later
#include "samcontact/film/dense_products.hpp"

#include "dense_products_by_eigen.hpp"
#include "samcontact/base/multiversion.hpp"

namespace samcontact::film {
namespace {

struct Portable {};

}  // namespace

const DenseProducts& dense_products() {
#if SAMCONTACT_HAS_VERSIONS
  if (has_avx()) return dense_products_by_avx();
#endif
  return ByEigen<Portable>::products;
}

}  // namespace samcontact::film
