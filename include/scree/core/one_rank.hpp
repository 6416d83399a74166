// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

/// Values of particles in the order in which they are stored, see OneRank::order_of().
struct AsStored {
  template <class T>
  std::vector<T> of(std::vector<T> values, std::size_t /*of_each*/ = 1) const {
    return values;
  }
};

}  // namespace detail

/// The agreement of a case with one rank, which has all particles. Models, probes and measures use WholeBody
/// (fields/whole_body.hpp) for sums and largest values over all particles.
struct OneRank {
  /// Whether there are other ranks.
  bool several() const { return false; }
  /// The largest of a number over all ranks.
  double largest(double here) const { return here; }
  /// Whether a condition holds on at least one rank.
  bool on_any(bool here) const { return here; }
  /// Extends the frames of grids (neighbours/grid.hpp) to contain the particles of all ranks.
  template <class Frames>
  void join(Frames&) const {}
  /// The result of survey() over all ranks, and their number of particles. The index of the particle with a largest
  /// value is detail::no_particle except on the rank that owns it.
  template <class Found>
  std::pair<Found, long> joined(Found const& here, long particles) const {
    return {here, particles};
  }
  /// Whether each rank has its own particles only.
  bool scattered() const { return false; }
  /// The values of all ranks, those of rank 0 first.
  template <class T>
  std::vector<T> of_all(std::vector<T> values) const {
    return values;
  }
  /// The sum of a number of particles over all ranks.
  long sum(long here) const { return here; }
  /// Sums of integers over all ranks, element by element.
  std::vector<std::int64_t> sum(std::vector<std::int64_t> here) const { return here; }
  /// Sums of ExactSum over all ranks, element by element, as numbers.
  template <class Exact>
  std::vector<double> sum(std::vector<Exact> const& here) const {
    std::vector<double> values;
    for (Exact const& each : here) values.push_back(each.value());
    return values;
  }
  /// The number of particles of all ranks.
  template <class Body>
  long count(Body const& body) const {
    return body.size();
  }
  /// Brings values of the particles of a body, or of some of them by number, on all ranks into one order:
  /// `order.of(values, of_each)`.
  template <class Body, class... Numbers>
  detail::AsStored order_of(Body const&, Numbers const&...) const {
    return {};
  }
  /// Whether this rank is the one that reports for the case.
  bool reports() const { return true; }
  /// Whether particles that are added to the case are added here; they may move to other ranks.
  bool takes_new() const { return true; }
};
/// The agreement of all cases with one rank.
inline constexpr OneRank one_rank{};

}  // namespace scree
