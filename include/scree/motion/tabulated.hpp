// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree {

/// The interpolation between two points of a table.
///   monotone   a monotone piecewise cubic: smooth, with zero velocity at both ends and where the direction changes
///   linear     straight lines: the velocity jumps at each point of the table, and the acceleration is zero
enum class TableInterpolation { monotone, linear };

/// A translation of all points by a displacement that is interpolated in a table. Before the first time in the table,
/// the displacement is the first one in the table; after the last time, it is the last one. Each coordinate stays
/// between its values at the two adjacent points of the table, so a wall with equal displacements at both points is at
/// rest between them. The interpolation is the monotone piecewise cubic of Fritsch & Carlson (1980, SIAM J. Numer.
/// Anal. 17, 238-246) with the slopes of Fritsch & Butland (1984, SIAM J. Sci. Stat. Comput. 5, 300-304). The velocity
/// is continuous; the acceleration jumps at the points of the table. With `TableInterpolation::linear`, walls start,
/// turn and stop abruptly, within one time step. The table is stored in the object itself, so it needs no device
/// memory. read_tabulated() (`setup/read_tabulated.hpp`) reads a table from a file.
template <int Dim, int Capacity = 32>
class Tabulated {
 public:
  static constexpr int dim = Dim;
  using vector = Vec<Dim, double>;
  /// Largest time step as a fraction of the shortest interval of the table, -.
  double interval_per_step = 0.1;

  /// Makes a motion at rest.
  Tabulated() = default;
  /// Takes displacements (m) at increasing times (s). Throws std::invalid_argument unless there are 2 to `Capacity`
  /// increasing times with a displacement for each, and all numbers are finite.
  Tabulated(std::vector<double> const& times, std::vector<vector> const& displacements,
            TableInterpolation interpolation = TableInterpolation::monotone)
      : knots_(static_cast<int>(times.size())), is_linear_(interpolation == TableInterpolation::linear) {
    if (times.size() < 2 || times.size() > Capacity || times.size() != displacements.size())
      throw std::invalid_argument("scree: a table of a motion needs 2 to " + std::to_string(Capacity) +
                                  " times and a displacement for each");
    for (int k = 0; k < knots_; ++k) {
      time_[k] = times[std::size_t(k)];
      place_[k] = displacements[std::size_t(k)];
      if (k > 0 && !(time_[k] > time_[k - 1]))
        throw std::invalid_argument("scree: the times of the table of a motion must increase");
      if (!std::isfinite(time_[k]) || !place_[k].allFinite())
        throw std::invalid_argument(detail::formatted(
            "scree: row %d of the table of a motion, counted from 0, has a number that is not finite", k));
    }
    find_slopes();
  }

  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_setting(interval_per_step > 0, "interval_per_step (-) of Tabulated", interval_per_step, "above 0");
  }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    return x + (at(to).place - at(from).place).template cast<typename X::Scalar>();
  }
  template <class X>
  SCREE_FN X velocity(X const&, double time) const {
    return at(time).velocity.template cast<typename X::Scalar>();
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double time) const {
    return at(time).acceleration.template cast<typename X::Scalar>();
  }
  double time_step() const {
    double shortest = Kokkos::Experimental::infinity_v<double>;
    for (int k = 1; k < knots_; ++k) shortest = Kokkos::min(shortest, time_[k] - time_[k - 1]);
    return interval_per_step * shortest;
  }

 private:
  struct State {
    vector place, velocity, acceleration;
  };

  SCREE_FN State at(double time) const {
    if (knots_ == 0) return {vector::Zero(), vector::Zero(), vector::Zero()};
    if (!(time > time_[0])) return {place_[0], vector::Zero(), vector::Zero()};
    if (!(time < time_[knots_ - 1])) return {place_[knots_ - 1], vector::Zero(), vector::Zero()};
    int k = 0;
    while (time > time_[k + 1]) ++k;
    // The Hermite cubic over the interval, with s from 0 to 1.
    double const length = time_[k + 1] - time_[k], s = (time - time_[k]) / length;
    vector const step = place_[k + 1] - place_[k];
    if (is_linear_) return {place_[k] + s * step, step / length, vector::Zero()};
    vector const a = slope_[k] * length - step, b = step - slope_[k + 1] * length;
    State state;
    state.place = place_[k] + s * step + s * (1 - s) * ((1 - s) * a + s * b);
    state.velocity = (step + (1 - 2 * s) * ((1 - s) * a + s * b) + s * (1 - s) * (b - a)) / length;
    state.acceleration = (-2 * ((1 - s) * a + s * b) + 2 * (1 - 2 * s) * (b - a)) / sq(length);
    return state;
  }

  // The slope is zero at both ends and at points where the direction changes. At all other points it is the weighted
  // harmonic mean of the slopes on the two sides, which is at most three times the smaller slope.
  void find_slopes() {
    for (int k = 0; k < knots_; ++k) slope_[k] = vector::Zero();
    int const last = std::min(knots_, Capacity) - 1;  // knots_ - 1; the bound is for GCC, which warns without it
    for (int k = 1; k < last; ++k) {
      double const before = time_[k] - time_[k - 1], after = time_[k + 1] - time_[k], both = 3 * (before + after);
      for (int axis = 0; axis < Dim; ++axis) {
        double const one = (place_[k][axis] - place_[k - 1][axis]) / before;
        double const other = (place_[k + 1][axis] - place_[k][axis]) / after;
        if (one * other > 0) slope_[k][axis] = both / ((2 * after + before) / one + (2 * before + after) / other);
      }
    }
  }

  int knots_ = 0;
  bool is_linear_ = false;
  double time_[Capacity] = {};
  vector place_[Capacity], slope_[Capacity];
};

}  // namespace scree
