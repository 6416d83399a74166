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

/// Of velocity, acceleration and velocity gradient of the motion at a particle those that are asked for.
template <class Motion, class List>
struct Kinematics {
  using reads = Fields<Position>;
  using writes = List;
  Motion motion;
  double time;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    at(i[position], out);
  }
  template <class X, class O>
  SCREE_FN void at(X const& x, O& out) const {
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

/// A wall particle: its place, from the one it had at time zero, so that rounding errors do not add up, and its motion
/// there.
template <class Motion, class List>
struct Place {
  using reads = Fields<RestPosition>;
  using writes = Merge<Fields<Position>, List>;
  Motion motion;
  double time;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    auto const x = motion.displaced(i[rest_position], 0.0, time);
    out[position] = x;
    Kinematics<Motion, List>{motion, time}.at(x, out);
  }
};

}  // namespace scree::detail
