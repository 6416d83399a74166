// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../system/ghosts.hpp"
#include "../terms/wall_force.hpp"
#include "set_group.hpp"

#include <string>
#include <type_traits>
#include <vector>

namespace scree {

/// The load of the material on a group of wall particles; in 2D, the load on a slice one metre deep.
template <int Dim>
struct WallLoad {
  /// The type of moments: in 2D a number, positive from the first axis towards the last as in Rotation; in 3D a vector.
  using Moment = std::conditional_t<Dim == 2, double, Vec<3, double>>;
  std::string name;                                   ///< name of the group
  Vec<Dim, double> force = Vec<Dim, double>::Zero();  ///< sum of F, N
  Moment moment = zero<Moment>();                     ///< sum of (x - about) x F, N m
  double power = 0;  ///< sum of F . u_w, W: the power that the group takes from the material

  /// Adds the force F (N) on a particle with the lever arm (m) and the velocity u (m/s) of the particle.
  void add(Vec<Dim, double> const& F, Vec<Dim, double> const& arm, Vec<Dim, double> const& u) {
    force += F;
    power += dot(F, u);
    if constexpr (Dim == 2)
      moment += arm[0] * F[1] - arm[1] * F[0];
    else
      moment += Moment(arm[1] * F[2] - arm[2] * F[1], arm[2] * F[0] - arm[0] * F[2], arm[0] * F[1] - arm[1] * F[0]);
  }
};

/// Returns the loads on all groups of the wall in the present state, in the order of the groups, with moments about a
/// point (m). Calls Solver::update_diagnostics(); the diagnostics must contain WallForces (granular/wall_forces.hpp) or
/// another source of `wall_force`. `groups` are the groups from which the wall was made, or other groups of the same
/// particles in the same order. Throws std::invalid_argument if `groups` and the wall have different numbers of
/// particles. Positions are those of the particles, not of their periodic images.
template <BodyTag Body = Wall, class S, int Dim>
std::vector<WallLoad<Dim>> wall_loads(S& solver, Groups<Dim> const& groups,
                                      std::type_identity_t<Vec<Dim, double>> const& about = zero<Vec<Dim, double>>()) {
  using namespace fields;
  constexpr bool has_forces =
      OneOf<WallForce, typename std::remove_cvref_t<decltype(solver.template body<Body>())>::fields>;
  static_assert(has_forces, "no pass computes `wall_force`: name WallForces in `diagnostics` of the formulation");
  std::vector<WallLoad<Dim>> loads(static_cast<std::size_t>(groups.count()));
  if constexpr (has_forces) {
    auto const wall = solver.template whole<Body>();
    detail::check_number_in(groups, wall.size());
    solver.update_diagnostics();
    auto const [x, F, u, particles] = wall.values(position, wall_force, velocity, identity);
    auto const numbers = groups.numbers_of_all();
    for (std::size_t w = 0; w < x.size(); ++w)
      loads[std::size_t(numbers[std::size_t(particles[w])])].add(
          F[w].template cast<double>(), x[w].template cast<double>() - about, u[w].template cast<double>());
    auto const names = groups.names();
    for (std::size_t k = 0; k < loads.size(); ++k) loads[k].name = names[k];
  }
  return loads;
}
/// Returns the load on one group, as wall_loads() does. Throws std::invalid_argument if there is no such group.
template <BodyTag Body = Wall, class S, int Dim>
WallLoad<Dim> wall_load(S& solver, Groups<Dim> const& groups, std::string const& name,
                        std::type_identity_t<Vec<Dim, double>> const& about = zero<Vec<Dim, double>>()) {
  return wall_loads<Body>(solver, groups, about)[std::size_t(groups.number(name))];
}

}  // namespace scree
