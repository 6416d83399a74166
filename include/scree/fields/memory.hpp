// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/loop.hpp"
#include "../core/span.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

// Memory without a type: what is done with whole arrays needs bytes only, and is compiled once for all fields.
namespace scree {

/// Bytes in a memory space; copies share them.
template <class Space>
using Memory = Kokkos::View<std::byte*, Space>;

/// Sets all bytes to zero.
template <class Space>
void zero_bytes(Memory<Space> const& memory) {
  if (memory.size() == 0) return;
  if constexpr (on_host<Space>)
    std::memset(memory.data(), 0, memory.size());
  else
    Kokkos::deep_copy(typename Space::execution_space(), memory, std::byte{});
}
/// New memory, with anything in it; the label is for profilers.
template <class Space>
Memory<Space> new_memory(std::string const& label, std::size_t bytes) {
  return Memory<Space>(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), bytes);
}

/// Copies bytes from one space to another, after all kernels before and before all behind.
template <class To, class From>
void copy_bytes(void* to, void const* from, std::size_t bytes) {
  if (bytes == 0) return;
  if constexpr (on_host<To> && on_host<From>) {
    std::memcpy(to, from, bytes);
  } else {
    using Unmanaged = Kokkos::MemoryTraits<Kokkos::Unmanaged>;
    Kokkos::deep_copy(Kokkos::View<std::byte*, To, Unmanaged>(static_cast<std::byte*>(to), bytes),
                      Kokkos::View<std::byte const*, From, Unmanaged>(static_cast<std::byte const*>(from), bytes));
  }
}

/// A column of values of unknown type, with `of_each` words for each value.
struct UntypedColumn {
  using Word = std::uint32_t;
  Word* words = nullptr;
  int of_each = 0;

  /// Value `to` becomes value `from` of another column.
  SCREE_FN void copy(UntypedColumn const& source, int from, int to) const {
    Word const* const given = source.words + std::size_t(from) * std::size_t(of_each);
    Word* const taken = words + std::size_t(to) * std::size_t(of_each);
    for (int k = 0; k < of_each; ++k) taken[k] = given[k];
  }
};

namespace detail {

struct Gather {
  UntypedColumn from, to;
  Span<int const> order;
  SCREE_FN void operator()(int k) const { to.copy(from, order(k), k); }
};
struct Repeat {
  UntypedColumn value, to;
  SCREE_FN void operator()(int k) const { to.copy(value, 0, k); }
};

}  // namespace detail
}  // namespace scree
