// SPDX-License-Identifier: GPL-3.0-or-later
// The products for processors with AVX2. Eigen has another name in this file, so that the linker
// does not choose its functions for processors without AVX2.
#include "samcontact/base/multiversion.hpp"

#ifdef SAMCONTACT_HAS_VERSIONS
#pragma GCC target("arch=x86-64-v3")
#define Eigen EigenForAvx
#include "dense_products_by_eigen.hpp"

namespace samcontact::film {

extern const DenseProducts products_by_avx;
const DenseProducts products_by_avx = by_eigen;

}  // namespace samcontact::film
#endif
