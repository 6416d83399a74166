// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

/// The order in which values of particles are stored; see OneRank::order_of().
struct AsStored {
  template <class T>
  std::vector<T> of(std::vector<T> values, std::size_t /*of_each*/ = 1) const {
    return values;
  }
};

}  // namespace detail

/// The collective operations of a case with a single rank, which has all particles. Models, probes and measures use
/// WholeBody (fields/whole_body.hpp) for sums and maxima over all particles.
struct OneRank {
  /// Whether the case has several ranks.
  bool several() const { return false; }
  /// Returns the maximum of a number over all ranks.
  double largest(double here) const { return here; }
  /// Whether a condition holds on at least one rank.
  bool on_any(bool here) const { return here; }
  /// Extends the frames of grids (neighbours/grid.hpp) to contain the particles on all ranks.
  template <class Frames>
  void join(Frames&) const {}
  /// Returns the result of survey() over all ranks, and the number of particles on all ranks. The index of the particle
  /// with a largest value is detail::no_particle on every rank except the one that owns the particle.
  template <class Found>
  std::pair<Found, long> joined(Found const& here, long particles) const {
    return {here, particles};
  }
  /// Whether each rank has only its own particles.
  bool scattered() const { return false; }
  /// Returns the values from all ranks, starting with those from rank 0.
  template <class T>
  std::vector<T> of_all(std::vector<T> values) const {
    return values;
  }
  /// Returns the sum of a number of particles over all ranks.
  long sum(long here) const { return here; }
  /// Returns element-wise sums of integers over all ranks.
  std::vector<std::int64_t> sum(std::vector<std::int64_t> here) const { return here; }
  /// Returns element-wise sums of ExactSum objects over all ranks, converted to doubles.
  template <class Exact>
  std::vector<double> sum(std::vector<Exact> const& here) const {
    std::vector<double> values;
    for (Exact const& each : here) values.push_back(each.value());
    return values;
  }
  /// Returns the number of particles of a body on all ranks.
  template <class Body>
  long count(Body const& body) const {
    return body.size();
  }
  /// Returns an order for the values of all particles of a body, or of the particles with given numbers. Its function
  /// `of(values, of_each)` brings the values on all ranks into this order.
  template <class Body, class... Numbers>
  detail::AsStored order_of(Body const&, Numbers const&...) const {
    return {};
  }
  /// Whether this rank reports for the case.
  bool reports() const { return true; }
  /// Whether this rank takes particles that are added to the case; the particles may move to other ranks later.
  bool takes_new() const { return true; }
};
/// The collective operations shared by all cases with a single rank.
inline constexpr OneRank one_rank{};

}  // namespace scree
