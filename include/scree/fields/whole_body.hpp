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

/// A body of the whole case at a given time: the particles that are here, and counts, maxima, sums and lists over all
/// of its particles. Solver::whole() returns it. If the case is divided among several ranks, all of them must call the
/// member functions of this class, and functions that take such a body, together, and get the same results; only here()
/// and time() are local. It refers to the particles, which must outlive it.
template <class Body, class Case = WholeCase>
requires std::is_class_v<Case>  // not the number of a time
class WholeBody {
 public:
  using particles = Body;
  using policy = typename Body::policy;

  /// A body whose particles are all here, at a time (s).
  explicit WholeBody(Body const& body, double time = 0) : WholeBody(body, whole_case_here, time) {}
  /// A body of a case at a time (s).
  WholeBody(Body const& body, Case const& whole, double time = 0) : body_(body), case_(whole), time_(time) {}

  /// The particles that are here.
  Body const& here() const { return body_; }
  /// Whether all particles of the case are here.
  bool all_here() const { return case_.all_here(); }
  /// The time, s.
  double time() const { return time_; }
  /// The number of all particles.
  long size() const { return case_.count(body_); }
  /// The largest of a number that is found from the particles here.
  double largest(double of_those_here) const { return case_.largest(of_those_here); }
  /// The sum of a number that is found from the particles here.
  long sum(long of_those_here) const { return case_.sum(of_those_here); }
  /// Sums of integers (std::int64_t), or numbers from sums of ExactSum, that are found from the particles here, element
  /// by element.
  template <class T>
  auto sum(std::vector<T> of_those_here) const {
    return case_.sum(std::move(of_those_here));
  }
  /// A list of all entries that are found from the particles here, in any order.
  template <class T>
  std::vector<T> all_of(std::vector<T> of_those_here) const {
    return case_.of_all(std::move(of_those_here));
  }
  /// The result of a survey() of the particles here, of all particles, and their number.
  template <class Found>
  std::pair<Found, long> joined(Found const& of_those_here) const {
    return case_.joined(of_those_here, body_.size());
  }
  /// The order in which lists contain all particles, or some of them by number: order().of(values) takes values of the
  /// particles here (host) and returns those of all.
  template <class... Numbers>
  auto order(Numbers const&... which) const {
    return case_.order_of(body_, which...);
  }
  /// The values of a field of all particles (host); of several fields a tuple. The order is the same for each field.
  template <Field... Fs>
  auto values(Fs... fields) const {
    auto const in_order = order();
    if constexpr (sizeof...(Fs) == 1)
      return in_order.of(body_.to_host(fields...));
    else
      return std::tuple(in_order.of(body_.to_host(fields))...);
  }
  /// Returns this body without the types of its fields; scree::compiled contains functions that take it.
  WholeBody<AnyParticles<policy>, Case> untyped() const { return {body_, case_, time_}; }

 private:
  Body const& body_;
  Case const& case_;
  double time_;
};

}  // namespace scree
