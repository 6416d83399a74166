// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/available_memory.hpp"
#include "../core/span.hpp"
#include "memory.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <vector>

// Arrays of values, and their transfer to and from the host.
namespace scree {
namespace detail {

template <class T>
inline constexpr std::size_t word_size = std::min(std::bit_ceil(sizeof(T)), std::size_t(16));

/// A small matrix stored in machine words of up to 16 bytes, with padding in the last word. Threads that read a vector
/// number by number would request the same cache lines several times.
template <class T>
class alignas(word_size<T>) InWords : public T {
  using Number = typename T::Scalar;
  struct alignas(word_size<T>) Numbers {
    Number all[T::SizeAtCompileTime];
  };

 public:
  InWords() = default;
  SCREE_FN InWords(T const& value) { *this = value; }
  SCREE_FN InWords& operator=(T const& value) {
    Numbers numbers{};
    for (int k = 0; k < T::SizeAtCompileTime; ++k) numbers.all[k] = value.data()[k];
    *reinterpret_cast<Numbers*>(this) = numbers;
    return *this;
  }
  SCREE_LOOP_FN T read() const {
    Numbers const numbers = *reinterpret_cast<Numbers const*>(this);
    T value;
    for (int k = 0; k < T::SizeAtCompileTime; ++k) value.data()[k] = numbers.all[k];
    return value;
  }
};

/// Whether a GPU stores values of a type as machine words (InWords). In double precision, padding costs more than it
/// saves.
template <class T>
inline constexpr bool better_in_words = false;
template <class Real, int Rows, int Cols>
inline constexpr bool better_in_words<Eigen::Matrix<Real, Rows, Cols, Eigen::DontAlign>> =
    sizeof(Real) == 4 || sizeof(Real) * Rows* Cols % 16 == 0;

template <class P, class T>
struct Element {
  using type = std::conditional_t<!runs_on_host<P> && better_in_words<T>, InWords<T>, T>;
};
template <class P, class T>
struct Element<P, T const> {
  using type = typename Element<P, T>::type const;
};

/// An array of elements in the memory of an execution space, with the instance on which loops over the elements run.
/// Copies share the memory.
template <class T, class Space>
class ArrayIn {
 public:
  using Bytes = Memory<typename Space::memory_space>;

  ArrayIn() = default;
  /// Allocates elements and sets them to zero; the label is for profilers.
  ArrayIn(Space const& space, std::string_view label, std::size_t size)
      : ArrayIn(space, Bytes(label, std::size_t(checked_count(size)) * sizeof(T)), static_cast<int>(size)) {
    fill_with_zeros();
  }
  /// Makes an array of the first `size` elements in a memory block.
  ArrayIn(Space const& space, Bytes const& memory, int size)
      : ArrayIn(space, memory, Span<T>(reinterpret_cast<T*>(memory.data()), size)) {}

  /// Makes a read-only view of a writable array.
  template <class U>
  requires std::is_same_v<U const, T> ArrayIn(ArrayIn<U, Space> const& other)
      : ArrayIn(other.space(), other.memory(), other.span()) {}

  /// Returns the instance on which loops over the elements run.
  Space const& space() const { return space_; }
  int size() const { return span_.size(); }
  T* data() const { return span_.data(); }
  Bytes const& memory() const { return memory_; }
  Span<T> const& span() const { return span_; }
  operator Span<T>() const { return span_; }
  operator Span<T const>() const requires(!std::is_const_v<T>) { return span_; }
  /// Returns the elements [first, last) as an array that shares the memory.
  ArrayIn part(int first, int last) const { return {space_, memory_, Span<T>(data() + first, last - first)}; }
  /// Sets all elements to zero.
  void fill_with_zeros() const { memory_.fill_with_zeros(space_); }

 private:
  ArrayIn(Space const& space, Bytes const& memory, Span<T> const& span) : space_(space), memory_(memory), span_(span) {}

  Space space_;
  Bytes memory_;
  Span<T> span_;
};

}  // namespace detail

/// An array in the memory space of a policy. Copies of the array share its elements.
template <class P, class T>
using Array = detail::ArrayIn<typename detail::Element<P, T>::type, typename P::space>;
/// The span of an Array for kernels.
template <class P, class T>
using ArraySpan = Span<typename detail::Element<P, T>::type>;

/// Returns the value of an element of an array.
template <class T>
SCREE_LOOP_FN T const& value_of(T const& element) {
  return element;
}
template <class T>
SCREE_LOOP_FN T value_of(detail::InWords<T> const& element) {
  return element.read();
}

/// Returns a copy of an array on the host.
template <class T, class Space>
auto values_of(detail::ArrayIn<T, Space> const& array) {
  using Element = std::remove_const_t<T>;
  using Value = std::remove_cvref_t<decltype(value_of(std::declval<T const&>()))>;
  std::vector<Element> elements(static_cast<std::size_t>(array.size()));
  copy_bytes<Kokkos::HostSpace, typename Space::memory_space>(array.space(), elements.data(), array.data(),
                                                              elements.size() * sizeof(T));
  if constexpr (std::is_same_v<Element, Value>)
    return elements;
  else
    return std::vector<Value>(elements.begin(), elements.end());
}
/// Copies values from the host into an array of the same size.
template <class T, class Space, class Value>
void copy_into(detail::ArrayIn<T, Space> const& array, std::vector<Value> const& values) {
  auto const copy = [&](auto const& elements) {
    copy_bytes<typename Space::memory_space, Kokkos::HostSpace>(array.space(), array.data(), elements.data(),
                                                                elements.size() * sizeof(T));
  };
  if constexpr (std::is_same_v<T, Value>)
    copy(values);
  else
    copy(std::vector<T>(values.begin(), values.end()));
}
/// Copies an array to the beginning of another array that is at least as large. Throws std::invalid_argument if the
/// arrays belong to different instances.
template <class T, class U, class Space>
void copy_array(detail::ArrayIn<T, Space> const& to, detail::ArrayIn<U, Space> const& from) {
  static_assert(std::is_same_v<T const, U const>);
  if (from.size() == 0) return;
  check_same_instance(to.space(), from.space());
  using Memory = typename Space::memory_space;
  copy_bytes<Memory, Memory>(to.space(), to.data(), from.data(), static_cast<std::size_t>(from.size()) * sizeof(T));
}
/// Replaces an array by a larger one with the same values at its beginning and zeros after them.
template <class T, class Space>
void enlarge(Space const& space, detail::ArrayIn<T, Space>& array, std::string_view label, int size) {
  detail::ArrayIn<T, Space> const larger(space, label, static_cast<std::size_t>(size));
  copy_array(larger, array);
  array = larger;
}
/// Reallocates an array if it has fewer than `size` elements; its contents are then lost.
template <class T, class Space>
void reserve(Space const& space, detail::ArrayIn<T, Space>& array, std::string_view label, std::size_t size) {
  if (static_cast<std::size_t>(array.size()) >= size) return;
  array = {};  // frees the old memory before the new is allocated
  int const count = checked_count(size);
  array = {space, typename detail::ArrayIn<T, Space>::Bytes(label, size * sizeof(T)), count};
}
/// Returns an array with the given values, in the memory of `space`.
template <class P, class T>
Array<P, T> array_of(typename P::space const& space, std::vector<T> const& values) {
  Array<P, T> const array(space, "scree::values", values.size());
  copy_into(array, values);
  return array;
}
/// Returns an array with the given values, in the memory of the default instance of the execution space.
template <class P, class T>
Array<P, T> array_of(std::vector<T> const& values) {
  return array_of<P>(typename P::space(), values);
}

}  // namespace scree
