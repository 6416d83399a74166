// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"

#include <functional>
#include <string>

// Whether the functions of a prescribed motion agree with each other. It works on the host, for any motion.
namespace scree::detail {

/// The path of a point under a motion, as functions of time (s).
struct PathOfPoint {
  using vector = Vec<3, double>;
  std::function<vector(double)> place;         ///< m
  std::function<vector(double)> velocity;      ///< m/s
  std::function<vector(double)> acceleration;  ///< m/s^2; none: not checked
  /// The position at the second time of a point given at the first, m; empty: not checked.
  std::function<vector(vector const&, double, double)> moved = {};
};

/// A description of how the functions of a path contradict each other between two times (s), which are checked in a
/// number of pieces; "" if they agree.
std::string fault_of_path(PathOfPoint const& path, double from, double to, int pieces);

/// Throws std::invalid_argument if displacement, velocity and acceleration of a path contradict each other between two
/// times (s): if the way that follows from the velocity, or the displacement that starts at the first of these times
/// instead of at zero, differs from the displacement by more than 1 % of the largest speed times the time, or the
/// change of the velocity from that by the acceleration by more than 1 % in more than a quarter of the time. Velocities
/// may jump, positions may not. Intervals that the sums do not resolve are checked again, in up to 4096 pieces. Values
/// that are not finite are the business of other checks.
void check_path(PathOfPoint const& path, double from, double to);

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "consistent.ipp"
#endif
