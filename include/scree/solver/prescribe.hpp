// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../pairs/for_each_particle.hpp"
#include "../terms/velocity_gradient.hpp"

#include <string>

// What a prescribed motion gives to particles.
namespace scree::detail {

/// The motion since an earlier time.
template <class Motion>
struct Displace {
  using reads = Fields<Position>;
  using writes = Fields<Position>;
  Motion motion;
  double from, to;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[position] = motion.displaced(i[position], from, to);
  }
};

/// The place of a wall particle, from the one it had at time zero, so that rounding errors do not add up.
template <class Motion>
struct Place {
  using reads = Fields<RestPosition>;
  using writes = Fields<Position>;
  Motion motion;
  double time;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[position] = motion.displaced(i[rest_position], 0.0, time);
  }
};

/// Of velocity, acceleration and velocity gradient of the motion at a particle those that are asked for.
template <class Motion, class List>
struct Kinematics {
  using reads = Fields<Position>;
  using writes = List;
  Motion motion;
  double time;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    auto const x = i[position];
    if constexpr (OneOf<Velocity, List>) out[velocity] = motion.velocity(x, time);
    if constexpr (OneOf<Acceleration, List>) out[acceleration] = motion.acceleration(x, time);
    if constexpr (OneOf<VelocityGradient, List>) {
      // A difference over one metre: exact for the affine motions of rigid walls.
      for (int axis = 0; axis < x.size(); ++axis) {
        auto there = x;
        there[axis] += 1;
        out[velocity_gradient].col(axis) = motion.velocity(there, time) - motion.velocity(x, time);
      }
    }
  }
};

/// Those of `Wanted` that the body carries.
template <class P, class Wanted, class Carried, class Body, class Motion>
void prescribe(Body& body, Motion const& motion, double time) {
  using List = Without<Wanted, Without<Wanted, Carried>>;
  if constexpr (!std::is_same_v<List, Fields<>>)
    for_each_particle<basis_of<P>>("scree::kinematics", body, Kinematics<Motion, List>{motion, time});
}

}  // namespace scree::detail
