// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace scree {
namespace detail {

/// Values of particles in the order in which they are stored, see WholeCase::order_of().
struct AsStored {
  template <class T>
  std::vector<T> of(std::vector<T> values, std::size_t /*of_each*/ = 1) const {
    return values;
  }
};

}  // namespace detail

/// What is true of a whole case, from what is found here, where all its particles are. Agreement
/// (distributed/agreement.hpp) has the same functions for a case that is divided. Models, probes and measures use
/// WholeBody (fields/whole_body.hpp) for sums and largest values over all particles.
struct WholeCase {
  /// Whether all particles of the case are here.
  bool all_here() const { return true; }
  /// Throws std::logic_error unless all particles are here, for what is found once from all of them.
  void require_all_here() const {}
  /// Whether others compute a part of the case, or will.
  bool is_shared() const { return false; }
  /// Whether a condition holds anywhere.
  bool anywhere(bool here) const { return here; }
  /// The largest of a number.
  double largest(double here) const { return here; }
  /// Extends the frames of grids (neighbours/grid.hpp) to contain all particles.
  template <class Frames>
  void join(Frames&) const {}
  /// The result of survey() of all particles, and their number. The index of the particle with a largest value is
  /// detail::no_particle unless it is here.
  template <class Found>
  std::pair<Found, long> joined(Found const& here, long particles) const {
    return {here, particles};
  }
  /// A list of all entries.
  template <class T>
  std::vector<T> of_all(std::vector<T> values) const {
    return values;
  }
  /// The sum of a number of particles.
  long sum(long here) const { return here; }
  /// Sums of integers, element by element.
  std::vector<std::int64_t> sum(std::vector<std::int64_t> here) const { return here; }
  /// Sums of ExactSum, element by element, as numbers.
  template <class Exact>
  std::vector<double> sum(std::vector<Exact> const& here) const {
    std::vector<double> values;
    for (Exact const& each : here) values.push_back(each.value());
    return values;
  }
  /// The number of all particles of a body.
  template <class Body>
  long count(Body const& body) const {
    return body.size();
  }
  /// Brings values of the particles of a body, or of some of them by number, into one order: `order.of(values,
  /// of_each)`.
  template <class Body, class... Numbers>
  detail::AsStored order_of(Body const&, Numbers const&...) const {
    return {};
  }
  /// Replaces the values of the particles here in a snapshot of a system by those of all particles.
  template <class Snapshot, class Sys>
  void collect(Snapshot&, Sys const&) const {}
  /// Whether warnings of the case are given here.
  bool reports() const { return true; }
  /// Whether particles that are added to the case are added here.
  bool takes_new() const { return true; }
};
/// A case whose particles are all here.
inline constexpr WholeCase whole_case_here{};

}  // namespace scree
