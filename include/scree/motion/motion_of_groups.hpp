// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/groups.hpp"
#include "any_motion.hpp"

#include <algorithm>
#include <stdexcept>

namespace scree {

/// A motion for each group of a body, of one of the listed types; groups without a motion are at rest:
///
///     MotionOfGroups<2, Rotation> motion(walls);  // of type Groups<Dim>
///     motion.set(walls.number("blade"), Rotation{.rate = -2});
///
/// `Capacity` is the largest number of groups; the number of groups does not affect the amount of compiled code.
/// Kernels receive all motions by value, so long tables cost time on a GPU; do not give Tabulated more capacity than it
/// needs.
template <int Capacity, class... Motions>
class MotionOfGroups {
  static_assert(Capacity > 0, "MotionOfGroups<Capacity, Motions...> needs room for at least one group");

 public:
  /// Makes a motion without groups, which only a body without particles can follow.
  MotionOfGroups() = default;
  /// Makes the motion of a number of groups, all at rest. Throws std::invalid_argument if the number is negative or
  /// more than `Capacity`.
  explicit MotionOfGroups(int groups) : groups_(groups) {
    if (groups < 0 || groups > Capacity)
      throw std::invalid_argument(
          detail::formatted("scree: MotionOfGroups<%d, ...> holds the motions of at most %d groups, not %d: raise its "
                            "first template argument",
                            Capacity, Capacity, groups));
  }
  template <int Dim>
  explicit MotionOfGroups(Groups<Dim> const& groups) : MotionOfGroups(groups.count()) {}

  /// Sets the motion of one group and returns this object, so that calls can be chained. Throws std::invalid_argument
  /// if the group does not exist.
  template <class Motion>
  MotionOfGroups& set(int number, Motion const& motion) {
    if (number < 0 || number >= groups_)
      throw std::invalid_argument(
          detail::formatted("scree: no group %d: the motion is that of %d groups, counted from 0", number, groups_));
    motions_[number] = motion;
    return *this;
  }

  /// Throws std::invalid_argument if a parameter of the motion of a group is out of range.
  void check() const {
    for (int k = 0; k < groups_; ++k) try {
        motions_[k].check();
      } catch (std::invalid_argument const& error) {
        throw std::invalid_argument(detail::formatted("%s (group %d of MotionOfGroups)", error.what(), k));
      }
  }
  SCREE_FN AnyMotion<Motions...> const& of(int number) const { return motions_[number]; }
  int groups() const { return groups_; }
  /// Returns the largest time step that resolves the motions of all groups, s.
  double time_step() const {
    double shortest = AtRest{}.time_step();
    for (int k = 0; k < groups_; ++k) shortest = std::min(shortest, motions_[k].time_step());
    return shortest;
  }

 private:
  AnyMotion<Motions...> motions_[Capacity] = {};
  int groups_ = 0;
};

}  // namespace scree
