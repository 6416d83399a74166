// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "types.hpp"

#include <type_traits>

namespace scree {

/// A view of contiguous values in memory, passed to kernels by value. It owns nothing; the caller that launches the
/// kernel keeps the memory alive. An index out of bounds aborts the program if Kokkos checks bounds.
template <class T>
class Span {
 public:
  Span() = default;
  /// Refers to `size` elements from `first` on.
  SCREE_FN Span(T* first, int size) : first_(first), size_(size) {}
  /// Converts a span of writable elements to a read-only span.
  template <class U>
  requires std::is_same_v<U const, T> SCREE_FN Span(Span<U> const& other) : Span(other.data(), other.size()) {}

  /// Returns the number of elements.
  SCREE_FN int size() const { return size_; }
  /// Returns the address of the first element.
  SCREE_FN T* data() const { return first_; }
  SCREE_LOOP_FN T& operator()(int i) const {
#ifdef KOKKOS_ENABLE_DEBUG_BOUNDS_CHECK
    if (i < 0 || i >= size_) Kokkos::abort("scree: an index is outside of its array");
#endif
    return first_[i];
  }

 private:
  T* first_ = nullptr;
  int size_ = 0;
};

}  // namespace scree
