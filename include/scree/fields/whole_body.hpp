// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/one_rank.hpp"
#include "particles.hpp"

#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {

/// A body of the whole case at a given time, returned by Solver::whole(). A WholeBody gives access to the particles on
/// this rank, and to counts, maxima, sums and lists over the particles on all ranks. If the case is divided among
/// several ranks, the member functions, except here() and time(), and functions that take a WholeBody are collective:
/// all ranks must call them together, and get the same results. The object refers to the particles, which must outlive
/// it.
template <class Body, class Ranks = OneRank>
requires std::is_class_v<Ranks>  // a number is a time, not the ranks
class WholeBody {
 public:
  using particles = Body;
  using policy = typename Body::policy;

  /// Makes a body whose particles are all on this rank, at a time (s).
  explicit WholeBody(Body const& body, double time = 0) : WholeBody(body, one_rank, time) {}
  /// Makes a body with the collective operations of the ranks of its case, at a time (s).
  WholeBody(Body const& body, Ranks const& ranks, double time = 0) : body_(body), ranks_(ranks), time_(time) {}

  /// Returns the particles on this rank.
  Body const& here() const { return body_; }
  /// Returns the time, s.
  double time() const { return time_; }
  /// Returns the number of particles on all ranks.
  long size() const { return ranks_.count(body_); }
  /// Returns the maximum over all ranks of a number that each rank computes from its own particles.
  double largest(double of_those_here) const { return ranks_.largest(of_those_here); }
  /// Returns the sum over all ranks of a number that each rank computes from its own particles.
  long sum(long of_those_here) const { return ranks_.sum(of_those_here); }
  /// Returns the element-wise sums over all ranks of integers (std::int64_t) or ExactSum objects that each rank
  /// computes from its own particles. Sums of ExactSum objects are converted to doubles.
  template <class T>
  auto sum(std::vector<T> of_those_here) const {
    return ranks_.sum(std::move(of_those_here));
  }
  /// Returns a list, in no particular order, of the entries that all ranks compute from their own particles.
  template <class T>
  std::vector<T> all_of(std::vector<T> of_those_here) const {
    return ranks_.of_all(std::move(of_those_here));
  }
  /// Returns the result of survey() for the particles on all ranks, and their number, from the result for the particles
  /// on this rank.
  template <class Found>
  std::pair<Found, long> joined(Found const& of_those_here) const {
    return ranks_.joined(of_those_here, body_.size());
  }
  /// Returns the order in which lists contain all particles, or the particles with given numbers. order().of(values)
  /// takes the values of the particles on this rank, in host memory, and returns the values of the particles on all
  /// ranks.
  template <class... Numbers>
  auto order(Numbers const&... which) const {
    return ranks_.order_of(body_, which...);
  }
  /// Returns the values of a field of the particles on all ranks, in host memory; for several fields, returns a tuple.
  /// The order of the particles is the same for each field.
  template <Field... Fs>
  auto values(Fs... fields) const {
    auto const in_order = order();
    if constexpr (sizeof...(Fs) == 1)
      return in_order.of(body_.to_host(fields...));
    else
      return std::tuple(in_order.of(body_.to_host(fields))...);
  }
  /// Returns this body without the types of its fields. Functions in the library scree::compiled take this type.
  WholeBody<AnyParticles<policy>, Ranks> untyped() const { return {body_, ranks_, time_}; }

 private:
  Body const& body_;
  Ranks const& ranks_;
  double time_;
};

}  // namespace scree
