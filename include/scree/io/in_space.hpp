// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/field.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>

// Values of fields as VTK stores them, always in three dimensions. A two-dimensional simulation lies in the plane
// y = 0; its coordinates are x and z, because the last coordinate of the library points upwards.
namespace scree {
namespace detail {

template <class F, class In2D, class In3D>
inline constexpr bool holds_values = std::is_same_v<typename F::template value<2, double>, In2D>&&
    std::is_same_v<typename F::template value<3, double>, In3D>;
template <class F>
inline constexpr bool holds_reals = holds_values<F, double, double>;
template <class F>
inline constexpr bool holds_integers = holds_values<F, int, int>;
template <class F>
inline constexpr bool holds_vectors = holds_values<F, Vec<2, double>, Vec<3, double>>;
template <class F>
inline constexpr bool holds_tensors = holds_values<F, Mat<2, double>, Mat<3, double>>;
template <class F>
inline constexpr bool holds_symmetric3 = holds_values<F, Vec<4, double>, Vec<6, double>>;
template <class F>
inline constexpr bool holds_symmetric = holds_values<F, Vec<3, double>, Vec<6, double>>;

/// Returns the axis in space for an axis of the simulation. In two dimensions, axis 2 is the direction out of the
/// plane.
template <int Dim>
constexpr std::size_t axis_in_space(int axis) {
  if (Dim == 3 || axis == 0) return static_cast<std::size_t>(axis);
  return axis == 1 ? 2 : 1;
}
/// Returns VTK's index of the entry (a, b) of a symmetric tensor, whose entries are in the order xx, yy, zz, xy, yz,
/// xz.
constexpr std::size_t place_in_symmetric(std::size_t a, std::size_t b) {
  if (a == b) return a;
  return a + b == 1 ? 3 : a + b == 3 ? 4 : 5;
}

}  // namespace detail

/// The number of components of a field's value in space; 0 if VTK has no arrays for such values.
template <Field F>
inline constexpr int components_in_space = detail::holds_reals<F> || detail::holds_integers<F> ? 1
                                           : detail::holds_vectors<F>                          ? 3
                                           : detail::holds_tensors<F>                          ? 9
                                           : detail::holds_symmetric3<F>                       ? 6
                                           : detail::holds_symmetric<F>                        ? 6
                                                                                               : 0;

namespace detail {

/// The kinds of value that a field can have.
enum class Form { number, vector, tensor, symmetric3, symmetric };
template <Field F>
inline constexpr Form form_of = holds_reals<F> || holds_integers<F> ? Form::number
                                : holds_vectors<F>                  ? Form::vector
                                : holds_tensors<F>                  ? Form::tensor
                                : holds_symmetric3<F>               ? Form::symmetric3
                                                                    : Form::symmetric;

template <int Dim, Form form, class Value>
auto placed_in_space(Value const& value) {
  constexpr auto axis = axis_in_space<Dim>;
  if constexpr (form == Form::number) {
    return std::array<Value, 1>{value};
  } else {
    using number = typename Value::Scalar;
    std::array<number, form == Form::vector ? 3 : form == Form::tensor ? 9 : 6> all = {};
    if constexpr (form == Form::vector) {
      for (int a = 0; a < Dim; ++a) all[axis(a)] = value[a];
    } else if constexpr (form == Form::tensor) {
      for (int a = 0; a < Dim; ++a)
        for (int b = 0; b < Dim; ++b) all[3 * axis(a) + axis(b)] = value(a, b);
    } else if constexpr (form == Form::symmetric3) {
      auto const full = unpacked(value);
      for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b) all[place_in_symmetric(axis(a), axis(b))] = full(a, b);
    } else {
      int k = Dim;
      for (int a = 0; a < Dim; ++a) {
        all[axis(a)] = value[a];
        for (int b = a + 1; b < Dim; ++b)
          all[place_in_symmetric(axis(a), axis(b))] = value[k++] / std::numbers::sqrt2_v<number>;
      }
    }
    return all;
  }
}

}  // namespace detail

/// Returns the components in space of a value of field F in a Dim-dimensional simulation: a number; the components x,
/// y, z of a vector; the entries xx, yy, zz, xy, yz, xz of a symmetric tensor; the rows of any other tensor.
/// Out-of-plane components that the field does not have are 0.
template <int Dim, Field F, class Value>
auto in_space(Value const& value) {
  static_assert(components_in_space<F> > 0, "VTK has no arrays for values like those of this field");
  if constexpr (detail::holds_integers<F>)
    return std::array<std::int32_t, 1>{value};
  else
    return detail::placed_in_space<Dim, detail::form_of<F>>(value);
}

}  // namespace scree
