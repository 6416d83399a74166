// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <limits>
#include <stdexcept>

namespace Eigen {
template <class, int, int, int, int, int>
class Matrix;  // without its header, which a program with case files does not need otherwise
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
// The check of the model (setting.hpp) and the options of a program that names it (app/schema.hpp) follow from this.
namespace scree {

// With a compiler without consteval, mistakes are found at run time instead of compile time.
#ifdef __cpp_consteval
#define SCREE_CONSTEVAL consteval
#else
#define SCREE_CONSTEVAL constexpr
#endif

/// Numbers from `from` to `to`; without the end itself where it is open.
struct ParameterRange {
  double from = -std::numeric_limits<double>::infinity();  ///< the least value
  double to = std::numeric_limits<double>::infinity();     ///< the largest value
  bool open = false;                                       ///< whether `from` itself is excluded
  bool open_end = false;                                   ///< whether `to` is excluded; if infinite, x is finite
  char const* words = nullptr;  ///< for messages, where the range also depends on other parameters: "mu_s or more"

  /// False for a NaN.
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

/// The ranges of parameters. Only finite numbers, except in *_or_infinite.
namespace allowed {
/// The end of a range without end.
inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// All finite numbers.
constexpr ParameterRange finite() { return {-infinity, infinity, true, true}; }
/// Above `from`.
constexpr ParameterRange above(double from) { return {from, infinity, true, true}; }
/// Above `from` and at most `to`.
constexpr ParameterRange above(double from, double to) { return {from, to, true, false}; }
/// `words` replace "above `from`" where the lower end also depends on other parameters, which the model checks itself.
constexpr ParameterRange above(double from, char const* words) { return {from, infinity, true, true, words}; }
/// Above `from`, infinity included.
constexpr ParameterRange above_or_infinite(double from) { return {from, infinity, true, false}; }
/// `from` or more. `words` replace "at least `from`" where the lower end also depends on other parameters.
constexpr ParameterRange at_least(double from, char const* words = nullptr) {
  return {from, infinity, false, true, words};
}
/// `from` or more, infinity included.
constexpr ParameterRange at_least_or_infinite(double from) { return {from, infinity, false, false}; }
/// From `from` to `to`, both included.
constexpr ParameterRange from_to(double from, double to) { return {from, to, false, false}; }
/// Between `from` and `to`, both excluded.
constexpr ParameterRange between(double from, double to) { return {from, to, true, true}; }
}  // namespace allowed

namespace detail {
// Not constexpr: a call in a constant expression is an error that shows this name.
[[noreturn]] inline void a_case_may_narrow_the_range_of_a_parameter_but_not_widen_it() {
  throw std::logic_error("scree: a case may narrow the range of a parameter but not widen it");
}
}  // namespace detail

/// The name of a parameter, its unit, meaning and range.
struct ParameterAbout {
  char const* name;
  char const* unit;     ///< SI; "1": none
  char const* meaning;  ///< one line
  ParameterRange range;

  /// This parameter with a narrower range, from `from` to `to`. Does not compile for a wider range.
  SCREE_CONSTEVAL ParameterAbout within(double from, double to) const { return within({from, to}); }
  SCREE_CONSTEVAL ParameterAbout within(ParameterRange narrower) const {
    if (!range.includes(narrower) || narrower.from > narrower.to)
      detail::a_case_may_narrow_the_range_of_a_parameter_but_not_widen_it();
    return {name, unit, meaning, narrower};
  }
};

namespace detail {
/// Vec<Dim, double>.
template <int Dim>
using VectorParameter = Eigen::Matrix<double, Dim, 1, 2, Dim, 1>;
template <class Model, class T>
using Member = T Model::*;  // with this name nvcc adds no parentheses, of which g++ would warn
}  // namespace detail

/// A parameter of a model and its place there: one of `number`, `count` and, for a vector of two or three components,
/// `in_plane` or `in_space`. The range of a vector applies to each of its components.
template <class Model>
struct Parameter : ParameterAbout {
  detail::Member<Model, double> number = nullptr;
  detail::Member<Model, int> count = nullptr;
  detail::Member<Model, detail::VectorParameter<2>> in_plane = nullptr;
  detail::Member<Model, detail::VectorParameter<3>> in_space = nullptr;

  /// The number of components of the value: 1 for a number, 2 or 3 for a vector.
  constexpr int components() const { return in_space != nullptr ? 3 : in_plane != nullptr ? 2 : 1; }
  /// The value of a number.
  // Not inline: g++ 12 would warn of the member that is not there.
  [[gnu::noinline]] constexpr double of(Model const& model) const {
    return number ? model.*number : double(model.*count);
  }
  /// A component of a vector, or the number.
  double of(Model const& model, int component) const {
    if (in_plane != nullptr) return (model.*in_plane)[component];
    return in_space != nullptr ? (model.*in_space)[component] : of(model);
  }
};

/// A parameter of the class that has the member, for its list `parameters()`.
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

/// Whether a parameter of the model is a vector. Otherwise the header of vectors need not be there.
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

/// The declaration of a parameter by its member: parameter_of<&MuOfI<>::mu_s>.
template <auto Member>
inline constexpr ParameterAbout parameter_of = detail::described<Member>();

#undef SCREE_CONSTEVAL

}  // namespace scree
