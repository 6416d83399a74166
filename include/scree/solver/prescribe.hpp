// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../motion/motion.hpp"
#include "../pairs/for_each_particle.hpp"
#include "../terms/velocity_gradient.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// Applies a prescribed motion to particles.
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

/// The gradient of the motion, or the difference over one metre, which is exact for affine motions.
template <class Motion, class X>
SCREE_FN auto velocity_gradient_at(Motion const& motion, X const& x, double time) {
  using Real = typename X::Scalar;
  constexpr int dim = X::RowsAtCompileTime;
  Mat<dim, Real> L;
  if constexpr (GivesVelocityGradient<Motion, dim, Real>) {
    L = motion.velocity_gradient(x, time);
  } else {
    for (int axis = 0; axis < dim; ++axis) {
      X there = x;
      there[axis] += 1;
      L.col(axis) = motion.velocity(there, time) - motion.velocity(x, time);
    }
  }
  return L;
}

/// Those of velocity, acceleration and velocity gradient of the motion at a particle that are in the list.
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
      out[velocity_gradient] = velocity_gradient_at(motion, x, time);
    }
  }
};

/// A wall particle: its position, computed from the one at time zero so that rounding errors do not accumulate, and its
/// motion there.
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

/// Evenly spaced picks from many points, including the first and the last.
template <class X>
auto picked(std::vector<X> const& points, std::size_t most = 64) {
  std::vector<Vec<X::RowsAtCompileTime, double>> some;
  std::size_t const count = std::min(points.size(), most);
  for (std::size_t k = 0; k < count; ++k)
    some.push_back(points[count == 1 ? 0 : k * (points.size() - 1) / (count - 1)].template cast<double>());
  return some;
}

/// Throws std::invalid_argument if a motion without its own gradient is not affine over the points of a wall, which are
/// given at time zero.
template <class Motion, class X>
void check_affine(Motion const& motion, std::vector<X> const& at_rest, double time) {
  if constexpr (!GivesVelocityGradient<Motion, X::RowsAtCompileTime, double>) {
    if (at_rest.empty()) return;
    X const origin = motion.displaced(at_rest.front(), 0.0, time), u0 = motion.velocity(origin, time);
    auto const L = velocity_gradient_at(motion, origin, time);
    for (X const& rest : at_rest) {
      X const x = motion.displaced(rest, 0.0, time), u = motion.velocity(x, time);
      // The rounding error of u is that of coordinates of up to |x| + 1 m times the gradient.
      double const scale = norm(u) + norm(u0) + norm(L) * (1 + norm(x) + norm(origin));
      if (norm(X(u - u0 - L * X(x - origin))) > 1e-9 * scale)
        throw std::invalid_argument(
            "scree: the velocity of the motion is not affine over the wall: give the motion a function "
            "velocity_gradient(x, time) (1/s), which walls need to show the material what they do");
    }
  }
}

}  // namespace scree::detail
