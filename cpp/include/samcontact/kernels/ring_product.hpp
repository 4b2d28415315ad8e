// SPDX-License-Identifier: GPL-3.0-or-later
// Product of three dense matrices by Eigen, compiled for several instruction sets, one of which is
// chosen at run time.
#pragma once

namespace samcontact::kernels {

/// result [rows x columns] = left [rows x inner] middle [inner x across] right^T [across x
/// columns]; all stored by columns.
struct RingProduct {
  const double* left;
  const double* middle;
  const double* right;
  int rows, inner, across, columns;
};

/// By the widest instructions of this processor.
void ring_product(const RingProduct& of, double* result);
/// For x86 processors with AVX2 and FMA; only if the compiler supports several versions.
void ring_product_by_avx(const RingProduct& of, double* result);

}  // namespace samcontact::kernels
