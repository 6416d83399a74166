// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/finite.hpp"
#include "../core/loop.hpp"
#include "../core/tuple.hpp"
#include "../fields/particles.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>

// Largest values and non-finite values over all particles, from one sweep and, on a GPU, with one synchronization.
namespace scree {

/// The magnitude |F| of a field, for survey().
template <Field F>
struct Magnitude {
  using reads = Fields<F>;
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(i[F{}])>>)
      return Kokkos::abs(i[F{}]);
    else
      return norm(i[F{}]);
  }
};

/// The result of a survey for one function.
struct Largest {
  double value = 0;
  int particle = 0;   ///< the particle with the largest value; of several, the first
  double beyond = 0;  ///< number of particles above `most`; 0 if the function has none; exact to 16 million in float
};

namespace detail {

inline constexpr int no_particle = std::numeric_limits<int>::max();

template <class Real>
struct LargestSoFar {
  Real value = 0, beyond = 0;
  int particle = no_particle;
  SCREE_FN void join(LargestSoFar const& other) {
    if (other.value > value || (other.value == value && other.particle < particle))
      value = other.value, particle = other.particle;
    beyond += other.beyond;
  }
};

template <class Function, class P>
concept ReturnsNumber = requires(Function const& f, Record<P, reads_of<Function>> const& read) {
  { f(read) } -> std::convertible_to<typename P::real>;
};
template <class P, class Functions>
inline constexpr bool return_numbers = false;
template <class P, class... Functions>
inline constexpr bool return_numbers<P, Tuple<Functions...>> = (ReturnsNumber<Functions, P> && ...);

/// A function of one particle with the columns that it reads.
template <class P, class Function>
struct Measure : Function {
  using real = typename P::real;
  Columns<P, reads_of<Function>> reads;

  template <class Body>
  Measure(Function const& f, Body const& body) : Function(f), reads(body.select(reads_of<Function>{})) {}
  SCREE_FN void add(int i, LargestSoFar<real>& found) const {
    LargestSoFar<real> here;
    here.value = or_infinity(static_cast<real>(static_cast<Function const&>(*this)(reads.load(i))));
    here.particle = i;
    if constexpr (requires(Function const& f) { f.most; }) here.beyond = double(here.value) > this->most ? 1 : 0;
    found.join(here);
  }
};

template <class P, class... Functions>
struct Measures {
  template <class Body>
  explicit Measures(Body const&) {}
  SCREE_FN void add(int, LargestSoFar<typename P::real>*) const {}
};
template <class P, class First, class... Others>
struct Measures<P, First, Others...> {
  Measure<P, First> first;
  Measures<P, Others...> others;

  template <class Body>
  explicit Measures(Body const& body, First const& f, Others const&... g) : first(f, body), others(body, g...) {}
  SCREE_FN void add(int i, LargestSoFar<typename P::real>* found) const {
    first.add(i, *found);
    others.add(i, found + 1);
  }
};

/// The values that a survey finds. The type depends only on the precision and the number of functions, so surveys share
/// the code that handles it.
template <class Real, int Count>
struct Surveyed {
  LargestSoFar<Real> largest[Count + 1];  // one more than needed, because an array must not be empty
  int first_not_finite;
};
template <class P, class Checked, class... Functions>
struct SurveyLoop;
template <class P, class... Fs, class... Functions>
struct SurveyLoop<P, Fields<Fs...>, Functions...> {
  static constexpr int count = sizeof...(Functions);
  using value_type = Surveyed<typename P::real, count>;
  Columns<P, Fields<Fs...>> checked;
  Measures<P, Functions...> measures;

  SCREE_FN void init(value_type& found) const {
    for (auto& largest : found.largest) largest = {};
    found.first_not_finite = no_particle;
  }
  SCREE_FN void join(value_type& found, value_type const& other) const {
    for (int k = 0; k < count; ++k) found.largest[k].join(other.largest[k]);
    found.first_not_finite = Kokkos::min(found.first_not_finite, other.first_not_finite);
  }
  SCREE_FN void operator()(int i, value_type& found) const {
    bool const finite = (is_finite(checked.load(Fs{}, i)) && ...);
    if (!finite) found.first_not_finite = Kokkos::min(found.first_not_finite, i);
    measures.add(i, found.largest);
  }
};

}  // namespace detail

/// The results of survey(): the largest value of each function, and the first particle with a non-finite value.
template <int Count>
struct Survey {
  std::array<Largest, Count> largest = {};     ///< the largest value of each function
  int first_not_finite = detail::no_particle;  ///< first particle with a non-finite value, or no_particle
};

/// Returns the largest value over all owned particles of each non-negative function of one particle (`reads`,
/// operator()(i)), and the first particle with a non-finite value in the listed fields. The largest value is zero
/// without particles, and infinity if a value of the function is negative or NaN.
template <class Body, class List, class... Functions>
Survey<sizeof...(Functions)> survey(Body const& body, List checked, Functions const&... functions) {
  using P = typename Body::policy;
  ProfilingRegion const region("scree::survey");
  Survey<sizeof...(Functions)> result;
  constexpr bool are_numbers = detail::return_numbers<P, detail::Tuple<Functions...>>;
  static_assert(are_numbers, "the function of a bound needs operator()(i) const, which returns a number");
  if constexpr (are_numbers) {
    using Loop = detail::SurveyLoop<P, List, Functions...>;
    if (body.size() == 0 || (Loop::count == 0 && std::is_same_v<List, Fields<>>)) return result;
    auto const found = reduce(body.space(), "scree::survey", body.size(),
                              Loop{body.select(checked), detail::Measures<P, Functions...>(body, functions...)});
    for (int k = 0; k < Loop::count; ++k) {
      auto const& [value, beyond, particle] = found.largest[k];
      result.largest[std::size_t(k)] = {double(value), particle, double(beyond)};
    }
    result.first_not_finite = found.first_not_finite;
  }
  return result;
}

}  // namespace scree
