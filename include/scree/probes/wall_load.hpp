// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../setup/groups.hpp"
#include "../terms/wall_force.hpp"
#include "sample.hpp"

#include <limits>

namespace scree {

/// Force and torque of the material on walls.
template <int Dim>
struct WallLoad {
  Vec<Dim, double> force = Vec<Dim, double>::Zero();                                 ///< N, in 2D N/m
  Vec<Dim == 2 ? 1 : 3, double> torque = Vec < Dim == 2 ? 1 : 3, double > ::Zero();  ///< N m; in 2D N, from axis 0 to 1
};

namespace detail {
inline Vec<3, double> torque_of(Vec<3, double> const& arm, Vec<3, double> const& force) {
  return {arm[1] * force[2] - arm[2] * force[1], arm[2] * force[0] - arm[0] * force[2],
          arm[0] * force[1] - arm[1] * force[0]};
}
inline Vec<1, double> torque_of(Vec<2, double> const& arm, Vec<2, double> const& force) {
  return Vec<1, double>(arm[0] * force[1] - arm[1] * force[0]);
}
}  // namespace detail

/// The load of the material on the wall particles of a range of identity numbers (setup/groups.hpp), with the torque
/// about a point (m), for the present state: it brings diagnostics up to date. Needs a diagnostic that computes
/// `wall_force`, for instance WallForces of granular formulations.
template <class S>
WallLoad<S::policy::dim> wall_load(S& solver, Vec<S::policy::dim, double> const& about, IdentityRange const& range) {
  using Body = std::remove_cvref_t<decltype(solver.wall())>;
  static_assert(detail::carries<WallForce, Body>,
                "the walls carry no `wall_force`: name a pass that computes it in `diagnostics`, such as WallForces");
  solver.update_diagnostics();
  auto const names = solver.wall().to_host(identity);
  auto const places = solver.wall().to_host(position);
  auto const forces = solver.wall().to_host(wall_force);
  WallLoad<S::policy::dim> load;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!range.contains(names[i])) continue;
    Vec<S::policy::dim, double> const force = detail::in_double(forces[i]), arm = detail::in_double(places[i]) - about;
    load.force += force;
    load.torque += detail::torque_of(arm, force);
  }
  return load;
}
/// The load on all walls.
template <class S>
WallLoad<S::policy::dim> wall_load(S& solver, Vec<S::policy::dim, double> const& about) {
  return wall_load(solver, about, {0, std::numeric_limits<int>::max()});
}

}  // namespace scree
