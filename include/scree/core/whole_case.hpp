// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

/// The order in which values of particles are stored; see WholeCase::order_of().
struct AsStored {
  template <class T>
  std::vector<T> of(std::vector<T> values, std::size_t /*of_each*/ = 1) const {
    return values;
  }
};

}  // namespace detail

/// The collective operations of a case whose particles are all on one rank. Agreement (distributed/agreement.hpp) has
/// the same functions for a case that is divided among ranks. Models, probes and measures use WholeBody
/// (fields/whole_body.hpp) for sums and maxima over all particles.
struct WholeCase {
  /// Whether this rank has all particles of the case.
  bool all_here() const { return true; }
  /// Throws std::logic_error unless this rank has all particles, for callers that find a result once from all of them.
  void require_all_here() const {}
  /// Whether other ranks compute a part of the case, or will do so later.
  bool is_shared() const { return false; }
  /// Whether a condition holds on at least one rank.
  bool anywhere(bool here) const { return here; }
  /// Returns the maximum of a number over all ranks.
  double largest(double here) const { return here; }
  /// Extends the frames of grids (neighbours/grid.hpp) to contain all particles.
  template <class Frames>
  void join(Frames&) const {}
  /// Returns the result of survey() for all particles, and their number. The index of the particle with a largest value
  /// is detail::no_particle unless this rank owns the particle.
  template <class Found>
  std::pair<Found, long> joined(Found const& here, long particles) const {
    return {here, particles};
  }
  /// Returns a list of the entries from all ranks.
  template <class T>
  std::vector<T> of_all(std::vector<T> values) const {
    return values;
  }
  /// Returns the sum of a number of particles over the whole case.
  long sum(long here) const { return here; }
  /// Returns element-wise sums of integers over the whole case.
  std::vector<std::int64_t> sum(std::vector<std::int64_t> here) const { return here; }
  /// Returns element-wise sums of ExactSum objects over the whole case, converted to doubles.
  template <class Exact>
  std::vector<double> sum(std::vector<Exact> const& here) const {
    std::vector<double> values;
    for (Exact const& each : here) values.push_back(each.value());
    return values;
  }
  /// Returns the number of all particles of a body.
  template <class Body>
  long count(Body const& body) const {
    return body.size();
  }
  /// Returns an order for the values of all particles of a body, or of the particles with given numbers. Its function
  /// `of(values, of_each)` brings values into this order.
  template <class Body, class... Numbers>
  detail::AsStored order_of(Body const&, Numbers const&...) const {
    return {};
  }
  /// Replaces the values of this rank's particles in a snapshot of a system by the values of all particles.
  template <class Snapshot, class Sys>
  void collect(Snapshot&, Sys const&) const {}
  /// Whether this rank gives the warnings of the case.
  bool reports() const { return true; }
  /// Whether this rank takes particles that are added to the case.
  bool takes_new() const { return true; }
};
/// The collective operations of every case whose particles are all on one rank.
inline constexpr WholeCase whole_case_here{};

}  // namespace scree
