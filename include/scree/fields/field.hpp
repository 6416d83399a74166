// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/axial.hpp"
#include "../core/symmetric3.hpp"

#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

// A field is an empty type with a name, a unit and a value type. It is declared once; storage, access, output, restart
// and error messages follow from the declaration.
namespace scree {

/// A string literal as a template argument. Labels appear only in the base class of a field, so that the symbol of a
/// kernel shows the field's own name.
template <std::size_t N>
struct Label {
  char text[N];
  /// A label with the text of a literal.
  constexpr Label(char const (&literal)[N]) {
    for (std::size_t k = 0; k < N; ++k) text[k] = literal[k];
  }
  constexpr operator std::string_view() const { return {text, N - 1}; }
};

/// The base of all fields, with a name and a unit. A field with its own value type adds the template
/// `value<Dim, Real>`.
template <Label Name, Label Unit>
struct Labelled {
  static constexpr std::string_view name = Name;
  static constexpr std::string_view unit = Unit;
};

/// The base of a field with one number per particle.
template <Label Name, Label Unit>
struct Scalar : Labelled<Name, Unit> {
  template <int Dim, class Real>
  using value = Real;
};
/// The base of a field with one integer per particle.
template <Label Name, Label Unit>
struct Integer : Labelled<Name, Unit> {
  template <int Dim, class Real>
  using value = int;
};
/// The base of a field with a vector of Dim numbers per particle.
template <Label Name, Label Unit>
struct Vector : Labelled<Name, Unit> {
  template <int Dim, class Real>
  using value = Vec<Dim, Real>;
};
/// The base of a field with an antisymmetric tensor per particle, stored as an axial vector; see core/axial.hpp.
template <Label Name, Label Unit>
struct Axial : Labelled<Name, Unit> {
  template <int Dim, class Real>
  using value = Vec<axial_size<Dim>, Real>;
};
/// The base of a field with a matrix of Dim x Dim numbers per particle.
template <Label Name, Label Unit>
struct Tensor : Labelled<Name, Unit> {
  template <int Dim, class Real>
  using value = Mat<Dim, Real>;
};
/// The base of a field with a symmetric 3 x 3 tensor per particle, even in 2D, such as the stress in plane strain; see
/// core/symmetric3.hpp.
template <Label Name, Label Unit>
struct Symmetric3 : Labelled<Name, Unit> {
  template <int Dim, class Real>
  using value = Vec<symmetric3_size<Dim>, Real>;
};
/// The base of a field with a symmetric tensor per particle, stored as the vector of its independent entries; see
/// core/symmetric.hpp.
template <Label Name, Label Unit>
struct Symmetric : Labelled<Name, Unit> {
  template <int Dim, class Real>
  using value = Vec<symmetric_size<Dim>, Real>;
};
/// The base of a field whose value is a symmetric operator on symmetric tensors; see core/symmetric.hpp.
template <Label Name, Label Unit>
struct SymmetricOperator : Labelled<Name, Unit> {
  template <int Dim, class Real>
  using value = Mat<symmetric_size<Dim>, Real>;
};

/// Whether a type is empty and has a name, a unit and value types in two and three dimensions.
template <class F>
concept Field = std::is_empty_v<F> && requires {
  { F::name } -> std::convertible_to<std::string_view>;
  { F::unit } -> std::convertible_to<std::string_view>;
  typename F::template value<2, double>;
  typename F::template value<3, float>;
};

/// A list of fields.
template <Field... Fs>
struct Fields {};

/// The type of the value of field F under the policy P.
template <class P, class F>
using value_t = typename F::template value<P::dim, typename P::real>;

/// The field that holds the value of F at the beginning of the step; integrators store it.
template <Field F>
struct Previous {
  static constexpr std::string_view name = F::name;
  static constexpr std::string_view unit = F::unit;
  template <int Dim, class Real>
  using value = typename F::template value<Dim, Real>;
};

}  // namespace scree
