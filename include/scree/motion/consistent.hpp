// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../core/types.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

// Whether the functions of a prescribed motion agree with each other. It works on the host, for any motion.
namespace scree::detail {

/// The way of a point of a motion, as functions of time (s).
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
[[gnu::cold]] inline std::string fault_of_path(PathOfPoint const& path, double from, double to, int pieces) {
  using vector = PathOfPoint::vector;
  double const length = to - from, piece = length / pieces;
  vector const start = path.place(from), end = path.place(to), before = path.velocity(from);
  vector way = vector::Zero(), last = before, gained = vector::Zero();
  double fastest = std::max(before.norm(), path.velocity(to).norm()), largest = 0;
  std::vector<double> jumps;
  for (int k = 0; k < pieces; ++k) {
    double const middle = from + (k + 0.5) * piece;
    vector const u = path.velocity(middle);
    way += piece * u, fastest = std::max(fastest, u.norm());
    if (!path.acceleration) continue;
    vector const a = path.acceleration(middle), next = path.velocity(k + 1 == pieces ? to : from + (k + 1) * piece);
    jumps.push_back((next - last - piece * a).norm());
    gained += piece * a, largest = std::max(largest, a.norm()), last = next;
  }
  auto const text = [](vector const& v) { return formatted("(%.4g, %.4g, %.4g)", v[0], v[1], v[2]); };
  double const rounding = 1e-12 * (start.norm() + end.norm());
  double const speed = std::max(fastest, (end - start).norm() / length);
  if ((end - start - way).norm() > 0.01 * speed * length + rounding)
    return formatted("`displaced` carries the point at %s m by %s m, and `velocity` by %s m", text(start).c_str(),
                     text(end - start).c_str(), text(way).c_str());
  if (path.moved) {
    vector const there = path.moved(start, from, to);
    if ((there - end).norm() > 0.01 * speed * length + rounding)
      return formatted(
          "`displaced(x, from, to)` carries the point at x = %s m by %s m between these times, but from where it is at "
          "time zero to the same times by %s m",
          text(start).c_str(), text(there - start).c_str(), text(end - start).c_str());
  }
  // The velocity itself may jump, in a few pieces.
  double const rounded = 4e-15 * (start.norm() + end.norm()) / length;  // m/s, of velocities that depend on the place
  double const most = 0.01 * largest * piece + 1e-11 * (fastest + speed) + rounded;
  long const wrong = std::count_if(jumps.begin(), jumps.end(), [&](double jump) { return jump > most; });
  if (4 * wrong > pieces)
    return formatted("`velocity` of the point at %s m changes by %s m/s, and `acceleration` changes it by %s m/s",
                     text(start).c_str(), text(last - before).c_str(), text(gained).c_str());
  return "";
}

/// Throws std::invalid_argument if displacement, velocity and acceleration of a path contradict each other between two
/// times (s): if the way that follows from the velocity, or the displacement that starts at the first of these times
/// instead of at zero, differs from the displacement by more than 1 % of the largest speed times the time, or the
/// change of the velocity from that by the acceleration by more than 1 % in more than a quarter of the time. Velocities
/// may jump, positions may not. Intervals that the sums do not resolve are checked again, in up to 4096 pieces. Values
/// that are not finite are the business of other checks.
[[gnu::cold]] inline void check_path(PathOfPoint const& path, double from, double to) {
  std::string fault;
  for (int const pieces : {8, 64, 512, 4096}) {
    bool const is_resolved = (to - from) / pieces > 1e-9 * std::max(std::abs(from), std::abs(to));
    if (!is_resolved) return;
    fault = fault_of_path(path, from, to, pieces);
    if (fault.empty()) return;
  }
  throw std::invalid_argument(
      formatted("scree: the motion contradicts itself from %.9g to %.9g s: %s", from, to, fault.c_str()));
}

}  // namespace scree::detail
