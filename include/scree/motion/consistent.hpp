// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"

#include <functional>
#include <string>

// Checks that the functions of a prescribed motion agree with each other. The checks run on the host, for any motion.
namespace scree::detail {

/// The path of a point under a motion, as functions of time (s).
struct PathOfPoint {
  using vector = Vec<3, double>;
  std::function<vector(double)> place;         ///< m
  std::function<vector(double)> velocity;      ///< m/s
  std::function<vector(double)> acceleration;  ///< m/s^2; not checked if empty
  /// The position (m) at the second time (s) of a point given at the first time (s); not checked if empty.
  std::function<vector(vector const&, double, double)> moved = {};
};

/// Returns a description of how the functions of a path contradict each other between two times (s), or "" if they
/// agree. The check divides the interval into `pieces`.
std::string fault_of_path(PathOfPoint const& path, double from, double to, int pieces);

/// Throws std::invalid_argument if displacement, velocity and acceleration of a path contradict each other between two
/// times (s). The integral of the velocity, and the displacement that starts at the first time instead of at zero, must
/// agree with the displacement to 1 % of the largest speed times the duration. The change of the velocity must agree
/// with the integral of the acceleration to 1 % of the largest change by acceleration, except in at most a quarter of
/// the pieces of the interval. Velocities may jump, but positions must not. Intervals that the sums do not resolve are
/// checked again, in up to 4096 pieces. Values that are not finite are left to other checks.
void check_path(PathOfPoint const& path, double from, double to);

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "consistent.ipp"
#endif
