// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/basis.hpp"
#include "../fields/remainder.hpp"
#include "consistent.hpp"
#include "motion.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// Functions that apply a prescribed motion to particles and check it.
namespace scree::detail {

/// The fields of a wall particle that its motion determines.
using GivenByMotion = Fields<Position, Velocity, Acceleration, VelocityGradient>;

/// A function of one particle that displaces it by a motion from an earlier time to a later one.
template <class P, class Motion>
struct Displace {
  using remainder = remainders_of<P, Fields<Position>>;
  using reads = Merge<Fields<Position>, remainder, fields_of_motion<Motion>>;
  using writes = Merge<Fields<Position>, remainder>;
  Motion motion;
  double from, to;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    if constexpr (is_compensated<P, Position>) {
      using real = typename P::real;
      static_assert(PrescribedMotion<Motion, P::dim, double>,
                    "a motion that moves a material in single precision must move points in double as well, so that "
                    "small displacements are not lost: make `displaced` a template of the type of the point");
      Vec<P::dim, double> const before =
          i[position].template cast<double>() + i[Remainder<Position>{}].template cast<double>();
      Vec<P::dim, double> const after = motion_of(motion, i).displaced(before, from, to);
      out[position] = after.template cast<real>();
      out[Remainder<Position>{}] = (after - out[position].template cast<double>()).template cast<real>();
    } else {
      out[position] = motion_of(motion, i).displaced(i[position], from, to);
    }
  }
};

/// Sets velocity, acceleration and velocity gradient to the values for a motion at x, if these fields are in the list.
template <class List, class Motion, class X, class O>
SCREE_FN void set_kinematics(Motion const& motion, X const& x, double time, O& out) {
  using namespace fields;
  if constexpr (OneOf<Velocity, List>) out[velocity] = motion.velocity(x, time);
  if constexpr (OneOf<Acceleration, List>) out[acceleration] = motion.acceleration(x, time);
  if constexpr (OneOf<VelocityGradient, List>) out[velocity_gradient] = velocity_gradient_at(motion, x, time);
}

/// A function of one particle that sets velocity, acceleration and velocity gradient to the values for its motion, if
/// these fields are in the list.
template <class Motion, class List>
struct Kinematics {
  using reads = Merge<Fields<Position>, fields_of_motion<Motion>>;
  using writes = List;
  Motion motion;
  double time;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    set_kinematics<List>(motion_of(motion, i), i[fields::position], time, out);
  }
};

/// A function of one wall particle that sets its position and its motion there. The position is computed from the
/// position at time zero, so that rounding errors do not accumulate.
template <class Motion, class List>
struct Place {
  using reads = Merge<Fields<RestPosition>, fields_of_motion<Motion>>;
  using writes = Merge<Fields<Position>, List>;
  Motion motion;
  double time;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    auto const& own = motion_of(motion, i);
    auto const x = own.displaced(i[rest_position], 0.0, time);
    out[position] = x;
    set_kinematics<List>(own, x, time, out);
  }
};

/// Returns the points of a body divided into parts that move alike: one part for each group if the motion is by group,
/// otherwise a single part.
template <class Motion, class Body, class X>
std::vector<std::vector<X>> parts_that_move(Motion const& motion, Body const& body, std::vector<X> const& points) {
  if constexpr (MotionByGroup<Motion>) {
    std::vector<std::vector<X>> parts(static_cast<std::size_t>(motion.groups()));
    auto const groups = body.to_host(fields::group);
    for (std::size_t k = 0; k < points.size(); ++k) parts[static_cast<std::size_t>(groups[k])].push_back(points[k]);
    return parts;
  } else {
    return {points};
  }
}

/// Returns a function that gives the motion of each particle of a body.
template <class Motion, class Body>
auto moves_of(Motion const& motion, Body const& body) {
  std::vector<int> groups;
  if constexpr (MotionByGroup<Motion>) groups = body.to_host(fields::group);
  return [&motion, groups](std::size_t k) -> decltype(auto) {
    return motion_of_group(motion, groups.empty() ? 0 : groups[k]);
  };
}

/// Whether a motion rotates or strains the surroundings, over a length (m), of a point that is at x (m) at time zero.
/// The check uses seven times from 1 ms to 31 159 s.
template <class Motion, class X>
bool may_turn(Motion const& motion, X const& x, double length) {
  X beside = x;
  beside[0] += typename X::Scalar(length);
  for (double const time : {1e-3, 0.0371, 0.713, 3.17, 29.3, 311.0, 31'159.0}) {
    X way = motion.displaced(beside, 0.0, time);
    X const of_x = motion.displaced(x, 0.0, time);
    for (int axis = 0; axis < X::RowsAtCompileTime; ++axis)
      way[axis] = way[axis] - of_x[axis] - (beside[axis] - x[axis]);
    if (norm(way) > 1e-3 * length) return true;
  }
  return false;
}

/// Throws std::invalid_argument if a value of a field that must agree with the motion of the wall does not.
template <class F, class Motion, class Body, class Value>
void check_on_wall(Motion const& motion, Body const& wall, std::vector<Value> const& values) {
  using X = Vec<Value::RowsAtCompileTime, double>;
  auto const rest = wall.to_host(fields::rest_position);
  auto const moves = moves_of(motion, wall);
  for (std::size_t k = 0; k < std::min(values.size(), rest.size()); ++k)
    F::check_on_wall(moves(k), X(rest[k].template cast<double>()), X(values[k].template cast<double>()));
}
template <class F>
inline constexpr bool is_checked_on_wall = requires {
  &F::template check_on_wall<AtRest, Vec<2, double>>;
};

/// Returns up to `most` points, picked at even intervals from many points, including the first and the last.
template <class X>
auto picked(std::vector<X> const& points, std::size_t most = 64) {
  std::vector<Vec<X::RowsAtCompileTime, double>> some;
  std::size_t const count = std::min(points.size(), most);
  for (std::size_t k = 0; k < count; ++k) {
    X const& point = points[count == 1 ? 0 : k * (points.size() - 1) / (count - 1)];
    auto& same = some.emplace_back();
    for (int axis = 0; axis < X::RowsAtCompileTime; ++axis) same[axis] = double(point[axis]);
  }
  return some;
}

/// Whether a motion of points has its own function for the velocity gradient.
template <int Dim, class Motion>
bool gives_gradient(Motion const& motion) {
  if constexpr (requires { motion.template gives_gradient<Dim, double>(); })
    return motion.template gives_gradient<Dim, double>();
  else
    return GivesVelocityGradient<Motion, Dim, double>;
}

/// Throws std::invalid_argument if the velocity of a motion without its own velocity gradient is not affine over the
/// points of a wall. The points are given at time zero.
template <class Motion, class X>
void check_affine(Motion const& motion, std::vector<X> const& at_rest, double time) {
  if (at_rest.empty() || gives_gradient<X::RowsAtCompileTime>(motion)) return;
  X const origin = motion.displaced(at_rest.front(), 0.0, time), u0 = motion.velocity(origin, time);
  auto const L = velocity_gradient_at(motion, origin, time);
  for (X const& rest : at_rest) {
    X const x = motion.displaced(rest, 0.0, time), u = motion.velocity(x, time);
    // The rounding error of u is the rounding error of coordinates up to |x| + 1 m, multiplied by the gradient.
    double const scale = norm(u) + norm(u0) + norm(L) * (1 + norm(x) + norm(origin));
    if (norm(X(u - u0 - L * X(x - origin))) > 1e-9 * scale)
      throw std::invalid_argument(
          "scree: the velocity of the motion is not affine over the wall, or over one of its groups: give the motion a "
          "function velocity_gradient(x, time) (1/s), which walls need to show the material what they do");
  }
}

/// Returns the path of a point that is at `at_rest` (m) at time zero.
template <class Motion, int Dim>
[[gnu::cold]] PathOfPoint path_of(Motion const& motion, Vec<Dim, double> const& at_rest, bool with_acceleration) {
  using X = Vec<Dim, double>;
  auto const in_space = [](X const& x) {
    PathOfPoint::vector y = PathOfPoint::vector::Zero();
    for (int axis = 0; axis < Dim; ++axis) y[axis] = x[axis];
    return y;
  };
  auto const place = [&motion, at_rest](double t) { return X(motion.displaced(at_rest, 0.0, t)); };
  PathOfPoint path;
  path.place = [=](double t) { return in_space(place(t)); };
  path.velocity = [=, &motion](double t) { return in_space(X(motion.velocity(place(t), t))); };
  if (with_acceleration)
    path.acceleration = [=, &motion](double t) { return in_space(X(motion.acceleration(place(t), t))); };
  path.moved = [=, &motion](PathOfPoint::vector const& y, double from, double to) {
    X x;
    for (int axis = 0; axis < Dim; ++axis) x[axis] = y[axis];
    return in_space(X(motion.displaced(x, from, to)));
  };
  return path;
}

/// A selection of points, at time zero, from each portion of a body (WholeBody) that moves alike.
template <int Dim>
class SomeOfBody {
 public:
  SomeOfBody() = default;
  template <class X, class Whole>
  SomeOfBody(std::vector<std::vector<X>> const& portions, Whole const& body) {
    for (auto const& portion : portions) portions_.push_back(body.all_of(picked(portion)));
  }
  /// Throws std::invalid_argument as check_affine() does, for each portion.
  template <class Motion>
  void check_gradient(Motion const& motion, double time) const {
    for (std::size_t k = 0; k < portions_.size(); ++k)
      check_affine(motion_of_group(motion, static_cast<int>(k)), portions_[k], time);
  }
  /// Throws std::invalid_argument as check_path() does, for up to four points of each portion.
  template <class Motion>
  [[gnu::cold]] void check_paths(Motion const& motion, double from, double to, bool with_acceleration) const {
    if constexpr (PrescribedMotion<Motion, Dim, double>)
      for (std::size_t k = 0; k < portions_.size(); ++k)
        for (auto const& x : picked(portions_[k], 4))
          check_path(path_of<std::remove_cvref_t<decltype(motion_of_group(motion, 0))>, Dim>(
                         motion_of_group(motion, static_cast<int>(k)), x, with_acceleration),
                     from, to);
  }

 private:
  std::vector<std::vector<Vec<Dim, double>>> portions_;
};

}  // namespace scree::detail
