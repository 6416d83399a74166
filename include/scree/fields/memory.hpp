// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/available_memory.hpp"
#include "../core/loop.hpp"
#include "../core/span.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

// Untyped memory. Operations on whole arrays need only bytes, so they are compiled only once for all fields.
namespace scree {

namespace detail {

struct alignas(16) Zeros {
  std::uint64_t bits[2];
};
struct FillWithZeros {
  Zeros* to;
  std::size_t count, threads;
  SCREE_FN void operator()(int thread) const {
    for (std::size_t k = std::size_t(thread); k < count; k += threads) to[k] = {};
  }
};

}  // namespace detail

/// Returns the number of bytes that may still be allocated in a memory space, at most the limit of
/// assume_free_memory(). If the system does not report the number, returns that limit, which is infinite by default.
template <class Space>
double free_memory() {
  if constexpr (on_host<Space>) return available_memory();
  [[maybe_unused]] std::size_t free = 0, all = 0;
#if defined(KOKKOS_ENABLE_CUDA)
  if (std::is_same_v<Space, Kokkos::CudaSpace> && cudaMemGetInfo(&free, &all) == cudaSuccess)
    return std::min(double(free), detail::assumed_memory());
#elif defined(KOKKOS_ENABLE_HIP)
  if (std::is_same_v<Space, Kokkos::HIPSpace> && hipMemGetInfo(&free, &all) == hipSuccess)
    return std::min(double(free), detail::assumed_memory());
#endif
  return detail::assumed_memory();
}

/// A block of bytes in a memory space, which copies of the object share. It is not a Kokkos::View, because each View
/// type instantiates a dozen kernels for copies between layouts.
template <class Space>
class Memory {
 public:
  Memory() = default;
  /// Allocates bytes without initialising them; the label is for profilers. Throws std::runtime_error if a device has
  /// too few free bytes.
  Memory(std::string_view label, std::size_t size) : size_(size) {
    constexpr std::size_t much = std::size_t(1) << 26;  // the query itself takes time
    if (!on_host<Space> && size > much && double(size) > free_memory<Space>())
      throw std::runtime_error("scree: '" + std::string(label) + "' needs " + detail::short_text(double(size) * 1e-9) +
                               " GB of the memory of the device, " + detail::short_text(free_memory<Space>() * 1e-9) +
                               " GB are free; fewer particles need less");
    if (size != 0)
      bytes_ = {
          static_cast<std::byte*>(Kokkos::kokkos_malloc<Space>(std::string(label), words() * sizeof(detail::Zeros))),
          [](std::byte* bytes) { Kokkos::kokkos_free<Space>(bytes); }};
  }

  /// Returns the number of bytes.
  std::size_t size() const { return size_; }
  /// Returns the address of the first byte, or nullptr if there are no bytes.
  std::byte* data() const { return bytes_.get(); }

  /// Sets all bytes to zero.
  template <class Execution>
  void fill_with_zeros(Execution const& space) const {
    if (size_ == 0) return;
    if constexpr (on_host<Space>) {
      std::memset(data(), 0, size_);
    } else {
      auto const threads = static_cast<int>(std::min(words(), std::size_t(1) << 30));
      for_each_index(space, "scree::zeros", 0, threads,
                     detail::FillWithZeros{reinterpret_cast<detail::Zeros*>(data()), words(), std::size_t(threads)});
    }
  }

 private:
  std::size_t words() const { return (size_ + sizeof(detail::Zeros) - 1) / sizeof(detail::Zeros); }

  std::shared_ptr<std::byte> bytes_;
  std::size_t size_ = 0;
};

/// Copies bytes from one memory space to another after all earlier kernels of an instance, and waits for the copy.
template <class To, class From, class Execution>
void copy_bytes(Execution const& space, void* to, void const* from, std::size_t bytes) {
  if (bytes == 0) return;
  if constexpr (on_host<To> && on_host<From>) {
    std::memcpy(to, from, bytes);
  } else {
    using Unmanaged = Kokkos::MemoryTraits<Kokkos::Unmanaged>;
    Kokkos::deep_copy(space, Kokkos::View<std::byte*, To, Unmanaged>(static_cast<std::byte*>(to), bytes),
                      Kokkos::View<std::byte const*, From, Unmanaged>(static_cast<std::byte const*>(from), bytes));
    space.fence("scree::copy_bytes");
  }
}

/// A column of values of unknown type, with `of_each` words per value.
struct UntypedColumn {
  using Word = std::uint32_t;
  Word* words = nullptr;
  int of_each = 0;

  /// Sets the value at index `to` to the value at index `from` of another column.
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
/// A function for reduce() that counts the entries of a list that are less than or equal to their predecessors.
struct CountFalls {
  using value_type = int;
  Span<int const> list;
  SCREE_FN void init(int& falls) const { falls = 0; }
  SCREE_FN void join(int& falls, int const& other) const { falls += other; }
  SCREE_FN void operator()(int k, int& falls) const { falls += k > 0 && list(k) <= list(k - 1); }
};
/// A loop body that copies values from the beginning of one column to another, starting there at index `first`.
struct PutAt {
  UntypedColumn from, to;
  int first;
  SCREE_FN void operator()(int k) const { to.copy(from, k, first + k); }
};
struct SetZero {
  UntypedColumn to;
  SCREE_FN void operator()(int k) const {
    for (int w = 0; w < to.of_each; ++w) to.words[std::size_t(k) * std::size_t(to.of_each) + std::size_t(w)] = 0;
  }
};
struct Repeat {
  UntypedColumn value, to;
  SCREE_FN void operator()(int k) const { to.copy(value, 0, k); }
};

}  // namespace detail
}  // namespace scree
