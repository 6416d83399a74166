// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/finite.hpp"
#include "../core/fixed_point.hpp"
#include "../core/loop.hpp"
#include "../fields/columns.hpp"
#include "../fields/particles.hpp"
#include "../fields/standard.hpp"
#include "../fields/whole_body.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

// Sums over all particles of a body, computed on the device and bitwise independent of the order of the particles and
// of their distribution over ranks.
namespace scree {
namespace detail {

/// The largest magnitude among the terms of a function; infinity if a term is NaN.
template <class P, class Function>
struct LargestTerm {
  struct value_type {
    double largest;
  };
  Function function;
  Columns<P, reads_of<Function>> reads;

  SCREE_FN void init(value_type& found) const { found.largest = 0; }
  SCREE_FN void join(value_type& found, value_type const& other) const {
    found.largest = Kokkos::max(found.largest, other.largest);
  }
  SCREE_FN void operator()(int i, value_type& found) const {
    Vec<Function::count, double> const terms = function(reads.load(i));
    for (int k = 0; k < Function::count; ++k)
      found.largest = Kokkos::max(found.largest, or_infinity(Kokkos::abs(terms[k])));
  }
};

template <class P, class Function>
struct SumOfTerms {
  struct value_type {
    std::int64_t sums[Function::count];
  };
  Function function;
  Columns<P, reads_of<Function>> reads;
  FixedPoint unit;

  SCREE_FN void init(value_type& found) const {
    for (auto& sum : found.sums) sum = 0;
  }
  SCREE_FN void join(value_type& found, value_type const& other) const {
    for (int k = 0; k < Function::count; ++k) found.sums[k] += other.sums[k];
  }
  SCREE_FN void operator()(int i, value_type& found) const {
    Vec<Function::count, double> const terms = function(reads.load(i));
    for (int k = 0; k < Function::count; ++k) found.sums[k] += unit.whole(terms[k]);
  }
};

/// Throws std::runtime_error if the largest magnitude is not finite, which means that a term is infinite or NaN.
[[gnu::cold]] inline void check_terms(double largest, char const* what) {
  if (!std::isfinite(largest))
    throw std::runtime_error("scree: " + std::string(what) +
                             " cannot be computed: a value that it reads is not finite");
}

/// Returns the fixed-point unit for sums of `function(i)`, a Vec<count, double> of the fields in its `reads`, over the
/// particles of a body. `what` is the name of the sums in messages. Throws std::runtime_error if a term is not finite.
template <class... Of, class Function>
FixedPoint unit_of_terms(WholeBody<Of...> const& body, Function const& function, char const* what) {
  using P = typename WholeBody<Of...>::policy;
  auto const& here = body.here();
  auto const found = reduce(here.space(), "scree::largest_term", here.size(),
                            LargestTerm<P, Function>{function, here.select(reads_of<Function>{})});
  double const largest = body.largest(found.largest);
  check_terms(largest, what);
  return {largest, double(body.size())};
}
}  // namespace detail

/// Returns the sums of `function(i)`, a Vec<count, double> of the fields in its `reads`, over the particles of a body:
///
///     struct Momentum {
///       static constexpr int count = 2;
///       using reads = Fields<Mass, Velocity>;
///       template <class I>
///       SCREE_FN Vec<2, double> operator()(I const& i) const { ... }
///     };
///     auto const momentum = sums_over(solver.whole(), Momentum{}, "the momentum");
///
/// The function runs on the device. `what` is the name of the sums in messages. Throws std::runtime_error if a term is
/// not finite.
template <class... Of, class Function>
Vec<Function::count, double> sums_over(WholeBody<Of...> const& body, Function const& function, char const* what) {
  using P = typename WholeBody<Of...>::policy;
  auto const& here = body.here();
  auto const unit = detail::unit_of_terms(body, function, what);
  auto const found = reduce(here.space(), "scree::sum_of_terms", here.size(),
                            detail::SumOfTerms<P, Function>{function, here.select(reads_of<Function>{}), unit});
  auto const sums = body.sum(std::vector<std::int64_t>(found.sums, found.sums + Function::count));
  Vec<Function::count, double> values;
  for (int k = 0; k < Function::count; ++k) values[k] = unit.value(sums[std::size_t(k)]);
  return values;
}

}  // namespace scree
