// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors on 64-byte boundaries: one cache line, and what the widest SIMD loads want.
#pragma once

#include <complex>
#include <cstddef>
#include <new>
#include <vector>

namespace samcontact {

template <class T>
struct AlignedAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}

  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }
  template <class U>
  bool operator==(const AlignedAllocator<U>&) const {
    return true;
  }
};

/// A field of doubles; its index order is stated where it is declared.
using Field = std::vector<double, AlignedAllocator<double>>;
using Complex = std::complex<double>;
using ComplexField = std::vector<Complex, AlignedAllocator<Complex>>;

}  // namespace samcontact
