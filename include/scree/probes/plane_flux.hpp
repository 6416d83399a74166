// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../setup/shapes/primitives.hpp"
#include "sample.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace scree {

/// Volumes that have passed a plane, m^dim (in 2D, per metre of depth).
struct PassedVolume {
  double forward = 0;   ///< along the normal
  double backward = 0;  ///< against the normal
  /// Returns the difference `forward - backward`.
  double net() const { return forward - backward; }
};

/// A counter of the volume of material that passes a plane, particle by particle:
///
///     PlaneFlux<2> outlet(solver, {.point = {0, 0.1}, .normal = {0, -1}});
///     ... every 0.1 s: csv.row({now.time(), density * outlet.passed(now).net() / 0.1});
///
/// The count is exact, without integration in time: the side of each particle, known by its identity, is compared with
/// its side at the last call. A particle that passes and returns between two calls is not counted. The plane is
/// unbounded.
template <int Dim>
class PlaneFlux {
 public:
  /// Records the current side of each particle. Throws std::invalid_argument for a normal of length zero or NaN, and
  /// for a plane that crosses a periodic axis, because particles would change sides through the period.
  template <class S>
  PlaneFlux(S const& solver, HalfSpace<Dim> const& behind) : behind_(behind) {
    if (!(norm(behind.normal) > 0)) throw std::invalid_argument("scree: the normal of a plane must not be zero");
    for (Period const& period : solver.settings().periods)
      if (behind.normal[period.axis] != 0)
        throw std::invalid_argument("scree: material cannot be counted at a plane across a period");
    auto const whole = solver.whole();
    auto const names = whole.values(fields::identity);
    auto const places = detail::sampled<Position>(solver);
    for (std::size_t i = 0; i < names.size(); ++i) is_behind_[names[i]] = behind_.contains(places[i]);
  }

  /// Returns the volumes that have passed since the last call. Throws std::invalid_argument if particles have been
  /// added or removed since the material was first counted.
  template <class S>
  PassedVolume passed(S const& solver) {
    auto const names = solver.whole().values(fields::identity);
    auto const is_known = [&](auto name) { return is_behind_.contains(name); };
    if (names.size() != is_behind_.size() || !std::all_of(names.begin(), names.end(), is_known))
      throw std::invalid_argument("scree: particles came or went since material was first counted");
    auto const places = detail::sampled<Position>(solver);
    auto const volumes = detail::sampled<Volume>(solver);
    PassedVolume passed;
    for (std::size_t i = 0; i < names.size(); ++i) {
      bool& before = is_behind_.at(names[i]);
      bool const now = behind_.contains(places[i]);
      if (now != before) (now ? passed.backward : passed.forward) += volumes[i];
      before = now;
    }
    return passed;
  }

 private:
  HalfSpace<Dim> behind_;
  std::unordered_map<long, bool> is_behind_;  // by identity
};

}  // namespace scree
