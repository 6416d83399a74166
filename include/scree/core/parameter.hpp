// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <limits>
#include <stdexcept>

namespace Eigen {
template <class, int, int, int, int, int>
class Matrix;  // declared here, because a program with case files does not otherwise need its header
}

// A model declares each of its parameters once:
//
//     struct Elastic {
//       double young = 0, poisson = 0;
//       static constexpr auto parameters() {
//         return std::array{parameter("young", &Elastic::young, "Pa", "Young's modulus", allowed::above(0)),
//                           parameter("poisson", &Elastic::poisson, "1", "Poisson's ratio", allowed::between(-1,
//                           0.5))};
//       }
//       void check() const { check_parameters(*this); }
//     };
//
// The check of the model (setting.hpp) and the options of a program that names the model (app/schema.hpp) follow from
// this list.
namespace scree {

// If the compiler does not support consteval, mistakes are found at run time instead of compile time.
#ifdef __cpp_consteval
#define SCREE_CONSTEVAL consteval
#else
#define SCREE_CONSTEVAL constexpr
#endif

/// The range of numbers from `from` to `to`. An end that is open is not part of the range.
struct ParameterRange {
  double from = -std::numeric_limits<double>::infinity();  ///< the smallest value
  double to = std::numeric_limits<double>::infinity();     ///< the largest value
  bool open = false;                                       ///< whether `from` itself is excluded
  bool open_end = false;                                   ///< whether `to` itself is excluded, also if infinite
  char const* words = nullptr;  ///< for messages, if the range also depends on other parameters: "mu_s or more"

  /// Whether x is in the range; false if x is NaN.
  constexpr bool has(double x) const { return (open ? x > from : x >= from) && (open_end ? x < to : x <= to); }
  /// Whether all finite numbers of `other` are in this range.
  constexpr bool includes(ParameterRange const& other) const {
    bool const has_start = from > -std::numeric_limits<double>::infinity();
    bool const below = other.from < from || (other.from == from && has_start && open && !other.open);
    bool const has_end = to < std::numeric_limits<double>::infinity();
    bool const beyond = other.to > to || (other.to == to && has_end && open_end && !other.open_end);
    return !below && !beyond;
  }
};

/// Functions that return ranges of parameters. Only ranges from functions named *_or_infinite include infinity.
namespace allowed {
/// Infinity, as the end of an unbounded range.
inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// Returns the range of all finite numbers.
constexpr ParameterRange finite() { return {-infinity, infinity, true, true}; }
/// Returns the range of finite numbers above `from`.
constexpr ParameterRange above(double from) { return {from, infinity, true, true}; }
/// Returns the range of numbers above `from` and at most `to`.
constexpr ParameterRange above(double from, double to) { return {from, to, true, false}; }
/// Returns the range of finite numbers above `from`. In messages, `words` replace "above `from`" if the lower end also
/// depends on other parameters, which the model checks itself.
constexpr ParameterRange above(double from, char const* words) { return {from, infinity, true, true, words}; }
/// Returns the range of numbers above `from`, including infinity.
constexpr ParameterRange above_or_infinite(double from) { return {from, infinity, true, false}; }
/// Returns the range of finite numbers of at least `from`. In messages, `words` replace "`from` or more" if the lower
/// end also depends on other parameters.
constexpr ParameterRange at_least(double from, char const* words = nullptr) {
  return {from, infinity, false, true, words};
}
/// Returns the range of numbers of at least `from`, including infinity.
constexpr ParameterRange at_least_or_infinite(double from) { return {from, infinity, false, false}; }
/// Returns the range of numbers from `from` to `to`, both included.
constexpr ParameterRange from_to(double from, double to) { return {from, to, false, false}; }
/// Returns the range of numbers between `from` and `to`, both excluded.
constexpr ParameterRange between(double from, double to) { return {from, to, true, true}; }
}  // namespace allowed

namespace detail {
// Not constexpr, so that a call in a constant expression is an error that shows this name.
[[noreturn]] inline void a_case_may_narrow_the_range_of_a_parameter_but_not_widen_it() {
  throw std::logic_error("scree: a case may narrow the range of a parameter but not widen it");
}
}  // namespace detail

/// The name, unit, meaning and range of a parameter.
struct ParameterAbout {
  char const* name;
  char const* unit;     ///< SI; "1" if none
  char const* meaning;  ///< one line
  ParameterRange range;

  /// Returns this parameter with a narrower range, from `from` to `to`. A call with a wider range does not compile.
  SCREE_CONSTEVAL ParameterAbout within(double from, double to) const { return within({from, to}); }
  SCREE_CONSTEVAL ParameterAbout within(ParameterRange narrower) const {
    if (!range.includes(narrower) || narrower.from > narrower.to)
      detail::a_case_may_narrow_the_range_of_a_parameter_but_not_widen_it();
    return {name, unit, meaning, narrower};
  }
};

namespace detail {
/// The type Vec<Dim, double>.
template <int Dim>
using VectorParameter = Eigen::Matrix<double, Dim, 1, 2, Dim, 1>;
template <class Model, class T>
using Member = T Model::*;  // without this alias, nvcc adds parentheses about which g++ warns
}  // namespace detail

/// A parameter of a model, with a pointer to its member: `number` or `count` or, for a vector of two or three
/// components, `in_plane` or `in_space`. The range of a vector applies to each of its components.
template <class Model>
struct Parameter : ParameterAbout {
  detail::Member<Model, double> number = nullptr;
  detail::Member<Model, int> count = nullptr;
  detail::Member<Model, detail::VectorParameter<2>> in_plane = nullptr;
  detail::Member<Model, detail::VectorParameter<3>> in_space = nullptr;

  /// Returns the number of components of the parameter: 1 for a number, 2 or 3 for a vector.
  constexpr int components() const { return in_space != nullptr ? 3 : in_plane != nullptr ? 2 : 1; }
  /// Returns the value of a parameter that is a number.
  // Not inline, because g++ 12 would warn about a null pointer to a member.
  [[gnu::noinline]] constexpr double of(Model const& model) const {
    return number ? model.*number : double(model.*count);
  }
  /// Returns a component of a vector, or the value of a number.
  double of(Model const& model, int component) const {
    if (in_plane != nullptr) return (model.*in_plane)[component];
    return in_space != nullptr ? (model.*in_space)[component] : of(model);
  }
};

/// Returns a parameter for the list `parameters()` of the class that has the member.
template <class Model>
constexpr Parameter<Model> parameter(char const* name, double Model::*member, char const* unit, char const* meaning,
                                     ParameterRange const& range) {
  return {{name, unit, meaning, range}, member, nullptr};
}
template <class Model>
constexpr Parameter<Model> parameter(char const* name, int Model::*member, char const* unit, char const* meaning,
                                     ParameterRange const& range) {
  return {{name, unit, meaning, range}, nullptr, member};
}
template <class Model>
constexpr Parameter<Model> parameter(char const* name, detail::VectorParameter<2> Model::*member, char const* unit,
                                     char const* meaning, ParameterRange const& range) {
  return {{name, unit, meaning, range}, nullptr, nullptr, member};
}
template <class Model>
constexpr Parameter<Model> parameter(char const* name, detail::VectorParameter<3> Model::*member, char const* unit,
                                     char const* meaning, ParameterRange const& range) {
  return {{name, unit, meaning, range}, nullptr, nullptr, nullptr, member};
}

namespace detail {
template <class T>
concept HasParameters = requires {
  T::parameters().size();
};

/// Whether a parameter of the model is a vector. If no parameter is a vector, the header of vectors need not be
/// included.
template <class Model>
constexpr bool has_vectors() {
  for (auto const& each : Model::parameters())
    if (each.components() > 1) return true;
  return false;
}

template <class Model>
constexpr ParameterAbout const* find_parameter(auto const& list, double Model::*member) {
  for (auto const& each : list)
    if (each.number == member) return &each;
  return nullptr;
}
template <class Model>
constexpr ParameterAbout const* find_parameter(auto const& list, int Model::*member) {
  for (auto const& each : list)
    if (each.count == member) return &each;
  return nullptr;
}
template <class Model, int Dim>
constexpr ParameterAbout const* find_parameter(auto const& list, VectorParameter<Dim> Model::*member) {
  for (auto const& each : list) {
    if constexpr (Dim == 2)
      if (each.in_plane == member) return &each;
    if constexpr (Dim == 3)
      if (each.in_space == member) return &each;
  }
  return nullptr;
}
template <class T, class Model>
Model model_of(T Model::*);

template <auto Member>
constexpr ParameterAbout described() {
  using Model = decltype(model_of(Member));
  static_assert(HasParameters<Model>,
                "the class of this member declares no parameters: it needs static constexpr auto parameters(), which "
                "returns a std::array of parameter(name, member, unit, meaning, range)");
  constexpr auto list = Model::parameters();
  constexpr bool is_listed = find_parameter(list, Member) != nullptr;
  static_assert(is_listed, "this member is not in the parameters() of its class");
  if constexpr (is_listed)
    return *find_parameter(list, Member);
  else
    return {};
}
}  // namespace detail

/// The declaration of a parameter, found by its member, as in parameter_of<&MuOfI<>::mu_s>.
template <auto Member>
inline constexpr ParameterAbout parameter_of = detail::described<Member>();

#undef SCREE_CONSTEVAL

}  // namespace scree
