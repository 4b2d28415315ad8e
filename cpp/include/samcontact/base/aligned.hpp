// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors on 64-byte boundaries: the size of a cache line and the alignment of the widest SIMD
// loads.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <new>
#include <vector>

namespace samcontact {

/// Allocates on 64-byte boundaries. Huge pages are requested for large blocks, because transforms
/// stride through them, and with small pages the address cache would miss at every step.
void* allocate_bytes(std::size_t bytes);
void deallocate_bytes(void* p, std::size_t bytes);

/// Returns to the system what is kept of released fields, which it counts as used.
void release_kept_memory();

/// Called before and after a fork: a lock held by another thread would stay locked in the child.
void lock_memory();
void unlock_memory();

template <class T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <class U>
  // NOLINTNEXTLINE(cppcoreguidelines-explicit-constructor): allocators convert into each other.
  AlignedAllocator(const AlignedAllocator<U>&) {}

  T* allocate(std::size_t n) { return static_cast<T*>(allocate_bytes(n * sizeof(T))); }
  void deallocate(T* p, std::size_t n) { deallocate_bytes(p, n * sizeof(T)); }
  template <class U>
  bool operator==(const AlignedAllocator<U>&) const {
    return true;
  }
};

/// A field of doubles; its index order is stated where it is declared.
using Field = std::vector<double, AlignedAllocator<double>>;

/// Whether all values are zero.
inline bool is_zero(const Field& field) {
  return std::all_of(field.begin(), field.end(), [](double v) { return v == 0; });
}

/// Adds a field to another one, which may be shorter.
inline void add(const Field& from, Field& to) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
}
using Complex = std::complex<double>;
using ComplexField = std::vector<Complex, AlignedAllocator<Complex>>;

}  // namespace samcontact
