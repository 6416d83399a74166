// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "../core/setting.hpp"
#include "consistent.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace scree {

SCREE_BODY std::string detail::fault_of_path(PathOfPoint const& path, double from, double to, int pieces) {
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
  // The velocity itself may jump in up to a quarter of the pieces.
  double const rounded = 4e-15 * (start.norm() + end.norm()) / length;  // m/s; for velocities that depend on position
  double const most = 0.01 * largest * piece + 1e-11 * (fastest + speed) + rounded;
  long const wrong = std::count_if(jumps.begin(), jumps.end(), [&](double jump) { return jump > most; });
  if (4 * wrong > pieces)
    return formatted("`velocity` of the point at %s m changes by %s m/s, and `acceleration` changes it by %s m/s",
                     text(start).c_str(), text(last - before).c_str(), text(gained).c_str());
  return "";
}

SCREE_BODY void detail::check_path(PathOfPoint const& path, double from, double to) {
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

}  // namespace scree
