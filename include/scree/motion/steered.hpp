// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace scree {

/// A translation with a velocity that a run can change between steps:
///
///     solver.set_motion(solver.settings().motion.turned_to(velocity, solver.time()));
///
/// The velocity is constant after the last change. Before the last change, the motion is uniform from the position at
/// time zero to the position at the change. A component of a run can save the motion with numbers() and restore it with
/// from_numbers().
template <int Dim>
struct Steered {
  static constexpr int dim = Dim;
  using vector = Vec<Dim, double>;
  vector velocity_now = vector::Zero();  ///< velocity from `since` on, m/s
  vector way = vector::Zero();           ///< displacement from time zero to `since`, m
  double since = 0;                      ///< s

  static constexpr auto parameters() {
    return std::array{
        parameter("velocity_now", &Steered::velocity_now, "m/s", "velocity from `since` on", allowed::finite()),
        parameter("way", &Steered::way, "m", "displacement from time zero to `since`", allowed::finite()),
        parameter("since", &Steered::since, "s", "time of the last change", allowed::at_least(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_parameters(*this, "Steered");
    check_setting(since > 0 || way.norm() == 0, "way (m) of Steered at time zero", way.norm(), "0");
  }
  /// Returns the motion that continues with another velocity (m/s) from a time (s). Throws std::invalid_argument if the
  /// time is before `since`.
  Steered turned_to(vector const& velocity, double time) const {
    check_setting(time >= since, "the time (s) at which Steered turns", time, "that of the last change or later");
    return {velocity, way_at(time), time};
  }
  /// The number of values in numbers().
  static constexpr std::size_t number_count = 1 + 2 * Dim;
  /// Returns `since`, `way` and `velocity_now` (s, m, m/s), for a snapshot.
  std::vector<double> numbers() const {
    std::vector<double> all = {since};
    all.insert(all.end(), way.begin(), way.end());
    all.insert(all.end(), velocity_now.begin(), velocity_now.end());
    return all;
  }
  /// Returns the motion whose numbers() are the first of the given numbers; further numbers are ignored. Throws
  /// std::invalid_argument if there are too few numbers, or if a parameter is out of range.
  static Steered from_numbers(std::span<double const> numbers) {
    check_setting(numbers.size() >= number_count, "numbers of Steered", double(numbers.size()),
                  detail::formatted("%zu or more", number_count).c_str());
    Steered motion{.since = numbers[0]};
    for (std::size_t axis = 0; axis < Dim; ++axis)
      motion.way[int(axis)] = numbers[1 + axis], motion.velocity_now[int(axis)] = numbers[1 + Dim + axis];
    motion.check();
    return motion;
  }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    vector const by = way_at(to) - way_at(from);
    return x + by.template cast<typename X::Scalar>();
  }
  template <class X>
  SCREE_FN X velocity(X const&, double time) const {
    vector const u = is_before(time) ? vector(way / since) : velocity_now;
    return u.template cast<typename X::Scalar>();
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return zero<X>();
  }
  /// Returns infinity: the motion is exact at any time step, and the limits of the physics model cover the response of
  /// the material.
  double time_step() const { return Kokkos::Experimental::infinity_v<double>; }

 private:
  SCREE_FN bool is_before(double time) const { return time < since && since > 0; }
  SCREE_FN vector way_at(double time) const {
    if (is_before(time)) return way * (time / since);
    return way + velocity_now * (time - since);
  }
};

}  // namespace scree
