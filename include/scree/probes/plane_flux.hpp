// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../setup/shapes/primitives.hpp"
#include "sample.hpp"

#include <stdexcept>

namespace scree {

/// Volumes that have passed a plane, m^dim (in 2D per metre of depth).
struct PassedVolume {
  double forward = 0;   ///< along the normal
  double backward = 0;  ///< against it
  /// The difference `forward - backward`.
  double net() const { return forward - backward; }
};

/// The volume of material that passes a plane, counted by particles:
///
///     PlaneFlux<2> outlet(solver, {.point = {0, 0.1}, .normal = {0, -1}});
///     ... every 0.1 s: csv.row({now.time(), density * outlet.passed(now).net() / 0.1});
///
/// The count is exact, without integration in time: it compares the side of each particle, which it knows by its
/// identity, with that at the last call. A particle that passes and returns between two calls does not count. The plane
/// is unbounded.
template <int Dim>
class PlaneFlux {
 public:
  /// Notes the side of each particle now. Throws std::invalid_argument for a normal of length zero or NaN, and for a
  /// plane across a period, because particles would change sides through the period.
  template <class S>
  PlaneFlux(S const& solver, HalfSpace<Dim> const& behind) : behind_(behind) {
    if (!(norm(behind.normal) > 0)) throw std::invalid_argument("scree: the normal of a plane must not be zero");
    for (Period const& period : solver.settings().periods)
      if (behind.normal[period.axis] != 0)
        throw std::invalid_argument("scree: material cannot be counted at a plane across a period");
    is_behind_.resize(number_of(solver));
    count(solver);
  }

  /// The volumes that have passed since the last call. Throws std::invalid_argument if the number of particles has
  /// changed.
  template <class S>
  PassedVolume passed(S const& solver) {
    if (number_of(solver) != is_behind_.size())
      throw std::invalid_argument("scree: the number of particles has changed since material was first counted");
    return count(solver);
  }

 private:
  template <class S>
  static std::size_t number_of(S const& solver) {
    return static_cast<std::size_t>(solver.whole().size());
  }
  template <class S>
  PassedVolume count(S const& solver) {
    auto const names = solver.whole().values(fields::identity);
    auto const places = detail::sampled<Position>(solver);
    auto const volumes = detail::sampled<Volume>(solver);
    PassedVolume passed;
    for (std::size_t i = 0; i < names.size(); ++i) {
      char& before = is_behind_.at(static_cast<std::size_t>(names[i]));
      char const now = behind_.contains(places[i]);
      if (now != before) (now ? passed.backward : passed.forward) += volumes[i];
      before = now;
    }
    return passed;
  }

  HalfSpace<Dim> behind_;
  std::vector<char> is_behind_;  // by identity
};

}  // namespace scree
