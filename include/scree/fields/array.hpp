// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/space.hpp"
#include "../core/types.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <type_traits>
#include <vector>

// How values lie in arrays, and their way to the host and back.
namespace scree {
namespace detail {

template <class T>
inline constexpr std::size_t word_size = std::min(std::bit_ceil(sizeof(T)), std::size_t(16));

/// A small matrix in words of up to 16 bytes, the last one padded: threads that read a vector number by number ask the
/// cache for the same lines again and again.
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

/// In double precision padding costs more than it saves.
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

}  // namespace detail

/// Values in the memory of a policy.
template <class P, class T>
using Array = Kokkos::View<typename detail::Element<P, T>::type*, memory_of<P>>;

/// The value of an element of an array.
template <class T>
SCREE_LOOP_FN T const& value_of(T const& element) {
  return element;
}
template <class T>
SCREE_LOOP_FN T value_of(detail::InWords<T> const& element) {
  return element.read();
}

/// A copy of an array on the host.
template <class View>
auto values_of(View const& array) {
  auto const elements = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), array);
  std::vector<std::remove_cvref_t<decltype(value_of(elements(0)))>> values(array.extent(0));
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = elements(k);
  return values;
}
/// Fills an array of as many elements.
template <class View, class T>
void copy_into(View const& array, std::vector<T> const& values) {
  auto const elements =
      Kokkos::create_mirror_view(Kokkos::view_alloc(Kokkos::HostSpace(), Kokkos::WithoutInitializing), array);
  for (std::size_t k = 0; k < values.size(); ++k) elements(k) = values[k];
  Kokkos::deep_copy(array, elements);
}
/// An array with the given values.
template <class P, class T>
Array<P, T> array_of(std::vector<T> const& values) {
  Array<P, T> const array(Kokkos::view_alloc("scree::values", Kokkos::WithoutInitializing), values.size());
  copy_into(array, values);
  return array;
}

}  // namespace scree
