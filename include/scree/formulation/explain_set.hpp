// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../motion/prescribe.hpp"
#include "formulation.hpp"

#include <type_traits>

// Compile-time messages for values that do not fit the particles.
namespace scree::detail {

/// Whether a type is an Eigen vector or matrix, which Eigen would convert to any other size.
template <class T>
concept IsMatrix = std::is_base_of_v<Eigen::EigenBase<T>, T>;
template <class A, class B>
inline constexpr bool is_alike = std::is_same_v<typename A::Scalar, typename B::Scalar> &&
                                 (int(A::SizeAtCompileTime) == Eigen::Dynamic ||
                                  (int(A::SizeAtCompileTime) == int(B::SizeAtCompileTime) &&
                                   bool(A::IsVectorAtCompileTime) == bool(B::IsVectorAtCompileTime)));
/// Whether a value can be stored as a value of a field.
template <class Value, class Stored>
constexpr bool can_be_stored() {
  if constexpr (IsMatrix<Value> && IsMatrix<Stored>)
    return is_alike<Value, Stored>;
  else
    return std::is_convertible_v<Value, Stored>;
}

/// Whether set() can set a field of a body to the results of a function of points; `List` contains the fields of the
/// body. If not, the compiler prints the reason.
template <class P, class Body, class F, class List, class X, class Function>
constexpr bool explain_set() {
  static_assert(OneOf<F, List>,
                "these particles do not carry this field: a field is carried if a pass reads or writes it, or if "
                "`carries` of the formulation lists it");
  constexpr bool is_function = !IsMatrix<Function> && !std::is_arithmetic_v<Function>;
  static_assert(is_function,
                "set() takes a function of the position, also for one value: [&](auto const&) { return u; }");
  if constexpr (is_function) {
    constexpr bool takes_points = std::is_invocable_v<Function const&, X const&>;
    static_assert(takes_points, "the function given to set() must take a position: [](auto const& x) { return ...; }");
    if constexpr (takes_points) {
      using Value = std::remove_cvref_t<std::invoke_result_t<Function const&, X const&>>;
      constexpr bool fits_field = can_be_stored<Value, value_t<P, F>>();
      static_assert(!is_expression<Value>,
                    "the function given to set() must return a value, not an expression of Eigen: add .eval() to it");
      static_assert(is_expression<Value> || fits_field,
                    "the function given to set() returns another kind of value than the field has: a number for a "
                    "scalar, a vector for a vector, six or four numbers (packed()) for a tensor, in the dimension and "
                    "precision of the formulation");
      static_assert(!OneOf<F, fields_to_move<P, Body>>,
                    "the motion of this body is by group, so its groups are fixed: make the solver from `Groups`");
      static_assert(EvolvingBody<Body> || !OneOf<F, GivenByMotion>,
                    "the motion gives this field of a wall, so that a value would be overwritten: change the motion, "
                    "or set `rest_position`");
      static_assert(!RigidTag<Body> || (!is_checked_on_wall<F> && !std::is_same_v<F, RestPosition>),
                    "a rigid body turns, so its particles can neither slip along a direction fixed in space nor get "
                    "other rest positions");
      return OneOf<F, List> && fits_field && !is_expression<Value>;
    }
  }
  return false;
}

/// Whether the value given for a field of added particles is a value of this field, or a function of the point (m) that
/// returns one.
template <class P, class F, class X, class Value>
constexpr bool explain_given() {
  constexpr bool is_value = can_be_stored<Value, value_t<P, F>>();
  if constexpr (!is_value && !IsMatrix<Value> && std::is_invocable_v<Value const&, X const&>) {
    using Result = std::remove_cvref_t<std::invoke_result_t<Value const&, X const&>>;
    constexpr bool gives_value = is_expression<Result> || can_be_stored<Result, value_t<P, F>>();
    static_assert(gives_value,
                  "the function given to add() returns another kind of value than the field has, or one in another "
                  "dimension or precision than the formulation");
    return gives_value;
  } else {
    static_assert(is_value,
                  "the value given to add() is of another kind than the field, or in another dimension or precision "
                  "than the formulation: given(field, value) takes a value of the field, or a function of the point "
                  "that returns it");
    return is_value;
  }
}

}  // namespace scree::detail
