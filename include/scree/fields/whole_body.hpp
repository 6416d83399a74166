// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/whole_case.hpp"
#include "particles.hpp"

#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace scree {

/// A body of the whole case at a given time, returned by Solver::whole(). A WholeBody gives access to the particles on
/// this rank, and to counts, maxima, sums and lists over all particles of the body. If the case is divided among
/// several ranks, the member functions, except here() and time(), and functions that take a WholeBody are collective:
/// all ranks must call them together, and get the same results. The object refers to the particles, which must outlive
/// it.
template <class Body, class Case = WholeCase>
requires std::is_class_v<Case>  // a number is a time, not a case
class WholeBody {
 public:
  using particles = Body;
  using policy = typename Body::policy;

  /// Makes a body whose particles are all on this rank, at a time (s).
  explicit WholeBody(Body const& body, double time = 0) : WholeBody(body, whole_case_here, time) {}
  /// Makes a body of a case at a time (s).
  WholeBody(Body const& body, Case const& whole, double time = 0) : body_(body), case_(whole), time_(time) {}

  /// Returns the particles on this rank.
  Body const& here() const { return body_; }
  /// Whether this rank has all particles of the case.
  bool all_here() const { return case_.all_here(); }
  /// Returns the time, s.
  double time() const { return time_; }
  /// Returns the number of all particles of the body.
  long size() const { return case_.count(body_); }
  /// Returns the maximum of a number over all particles, from its maximum over the particles on this rank.
  double largest(double of_those_here) const { return case_.largest(of_those_here); }
  /// Returns the sum of a number over all particles, from its sum over the particles on this rank.
  long sum(long of_those_here) const { return case_.sum(of_those_here); }
  /// Returns element-wise sums over all particles, from the sums over the particles on this rank. The sums are integers
  /// (std::int64_t), or ExactSum objects, which are converted to doubles.
  template <class T>
  auto sum(std::vector<T> of_those_here) const {
    return case_.sum(std::move(of_those_here));
  }
  /// Returns the list of the entries for all particles, in no particular order, from the list for the particles on this
  /// rank.
  template <class T>
  std::vector<T> all_of(std::vector<T> of_those_here) const {
    return case_.of_all(std::move(of_those_here));
  }
  /// Returns the result of survey() for all particles, and their number, from the result for the particles on this
  /// rank.
  template <class Found>
  std::pair<Found, long> joined(Found const& of_those_here) const {
    return case_.joined(of_those_here, body_.size());
  }
  /// Returns the order in which lists contain all particles, or the particles with given numbers. order().of(values)
  /// takes the values of the particles on this rank, in host memory, and returns the values of all particles.
  template <class... Numbers>
  auto order(Numbers const&... which) const {
    return case_.order_of(body_, which...);
  }
  /// Returns the values of a field of all particles, in host memory; for several fields, returns a tuple. The order of
  /// the particles is the same for each field.
  template <Field... Fs>
  auto values(Fs... fields) const {
    auto const in_order = order();
    if constexpr (sizeof...(Fs) == 1)
      return in_order.of(body_.to_host(fields...));
    else
      return std::tuple(in_order.of(body_.to_host(fields))...);
  }
  /// Returns this body without the types of its fields. Functions in the library scree::compiled take this type.
  WholeBody<AnyParticles<policy>, Case> untyped() const { return {body_, case_, time_}; }

 private:
  Body const& body_;
  Case const& case_;
  double time_;
};

}  // namespace scree
