// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "granular.hpp"

#include <scree/granular/wall_forces.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/solver/slip.hpp>
#include <scree/solver/wall_loads.hpp>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

// Soil in plane strain that yields against a slowly moving wall.
namespace scree::test::soil {

using X = Vec<2, double>;

/// Along `direction`, with the speed growing evenly from zero for `rise`, then steady.
struct Push {
  X direction = X::Zero();
  double speed = 0, rise = 1;  // m/s, s

  SCREE_FN double distance(double time) const {
    double const gained = Kokkos::max(0.0, Kokkos::min(time, rise));
    return speed * (gained * gained / (2 * rise) + Kokkos::max(0.0, time - rise));
  }
  template <class Point>
  SCREE_FN Point displaced(Point const& x, double from, double to) const {
    return x + (direction * (distance(to) - distance(from))).template cast<typename Point::Scalar>();
  }
  template <class Point>
  SCREE_FN Point velocity(Point const&, double time) const {
    return (direction * (speed * Kokkos::min(time / rise, 1.0))).template cast<typename Point::Scalar>();
  }
  template <class Point>
  SCREE_FN Point acceleration(Point const&, double time) const {
    return (direction * (time < rise ? speed / rise : 0.0)).template cast<typename Point::Scalar>();
  }
  double time_step() const { return rise / 10; }
};

struct PlasticModels : GranularModels {
  using law = DruckerPrager;
  using filter = NoFilter;
};
template <class Integrator>
struct Plane : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<PlasticModels>;
  using integrator = Integrator;
  using motion = MotionOfGroups<4, Push>;
  using diagnostics = WallForces;
};

inline constexpr int rows = 4;  // of wall particles

/// A body of soil and its walls, of which the group "moving" is pushed.
struct Case {
  double spacing;
  Box<2> soil;
  double gravity;
  Groups<2> walls = {};
  DruckerPrager law = {};
  Push push = {};

  /// With Midpoint and the default step, or with SymplecticEuler, which takes a sixth of the time.
  template <class Integrator = Midpoint>
  Solver<Plane<Integrator>> solver() const {
    double const cfl = std::is_same_v<Integrator, Midpoint> ? Granular<>().cfl : 0.6;
    MotionOfGroups<4, Push> motion(walls);
    motion.set(walls.number("moving"), push);
    return Solver<Plane<Integrator>>({.spacing = spacing,
                                      .physics = {.law = law,
                                                  .gravity = {.magnitude = gravity},
                                                  .viscosity_speed = 0.1 * law.sound_speed(),
                                                  .cfl = cfl},
                                      .motion = motion},
                                     fill_lattice(soil, spacing), walls);
  }
  /// Until the moving wall has gone a distance (m).
  double time_to(double distance) const { return distance / push.speed + push.rise / 2; }
};

/// The force (N/m) of the soil on the moving wall against its motion, on average while the wall goes the last fifth of
/// its way (m).
template <class S>
double resistance(Case const& what, S& solver, double distance) {
  double const end = what.time_to(distance), begin = what.time_to(0.8 * distance);
  solver.run(begin);
  std::vector<double> forces;
  solver.run(end, {every<S>((end - begin) / 20, [&](S& now) {
               forces.push_back(-what.push.direction.dot(wall_load(now, what.walls, "moving").force));
             })});
  double sum = 0;
  for (double const force : forces) sum += force;
  return sum / double(forces.size());
}

}  // namespace scree::test::soil
