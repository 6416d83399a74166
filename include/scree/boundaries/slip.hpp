// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../motion/motion.hpp"
#include "../solver/set_group.hpp"
#include "wall.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace scree {
namespace detail {

/// Whether a plane through x (m, at time zero) with unit normal n has this normal at all times; tried at times up to
/// some 1000 s.
template <class Motion, class X>
bool keeps_normal(Motion const& motion, X const& x, X const& n) {
  for (double time = 1e-3; time < 1e3; time *= 1.7) {
    X const here = motion.displaced(x, 0.0, time);
    for (int axis = 0; axis < X::RowsAtCompileTime; ++axis) {
      X along = X::Zero();
      along[axis] = 1;
      along -= n * dot(n, along);
      X const there = motion.displaced(X(x + along), 0.0, time);
      if (!(std::abs(dot(n, X(there - here))) < 1e-6 * (1 + norm(x)))) return false;
    }
  }
  return true;
}

/// The motion of each particle of a body.
template <class Motion, class Body>
auto moves_of(Motion const& motion, Body const& body) {
  std::vector<int> groups;
  if constexpr (MotionByGroup<Motion>) groups = body.to_host(group);
  return [&motion, groups](std::size_t k) -> decltype(auto) {
    return motion_of_group(motion, groups.empty() ? 0 : groups[k]);
  };
}

/// A vector, or the value of a function of a point. Eigen's vectors can be called, too.
template <class X, class Normal, class Point>
X vector_at(Normal const& normal, Point const& x) {
  if constexpr (requires { typename Normal::Scalar; })
    return X(normal.template cast<double>());
  else
    return X(normal(x).template cast<double>());
}

}  // namespace detail

/// Makes a group of the wall a slip wall: `normal` is a vector or a function of the present position (m), of any length
/// above zero; zero vectors make particles stick again, as they do at the start. Normals are fixed in space. Throws
/// std::invalid_argument if the motion of a particle turns its plane, if a normal is not finite, or if there is no such
/// group.
template <BodyTag Body = Wall, class S, int Dim, class Normal>
void set_slip(S& solver, Groups<Dim> const& groups, std::string const& name, Normal const& normal) {
  using P = typename S::policy;
  using X = Vec<Dim, double>;
  auto const& wall = solver.template body<Body>();
  detail::check_number_in(groups, wall);
  auto const range = groups.range(name);
  auto const x = wall.to_host(position), rest = wall.to_host(rest_position);
  auto const particles = wall.to_host(identity);
  auto const moves = detail::moves_of(motion_of_body<Body>(solver.settings().motion), wall);
  auto normals = wall.to_host(slip_normal);
  for (std::size_t w = 0; w < normals.size(); ++w) {
    if (!range.contains(particles[w])) continue;
    X n = detail::vector_at<X>(normal, x[w]);
    double const length = norm(n);
    if (!std::isfinite(length))
      throw std::invalid_argument("scree: a slip normal of group '" + name + "' is not finite");
    if (length > 0) n /= length;
    if (length > 0 && !detail::keeps_normal(moves(w), X(rest[w].template cast<double>()), n))
      throw std::invalid_argument("scree: group '" + name +
                                  "' cannot slip: slip normals are fixed in space, and the motion turns this wall");
    normals[w] = n.template cast<typename P::real>();
  }
  solver.template set<Body>(slip_normal, normals, [](auto const& n) { return n; });
}

}  // namespace scree
