// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/slip_normal.hpp"
#include "set_group.hpp"

#include <string>

namespace scree {
namespace detail {

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
/// std::invalid_argument as SlipNormal::check_on_wall() does, or if there is no such group.
template <BodyTag Body = Wall, class S, int Dim, class Normal>
void set_slip(S& solver, Groups<Dim> const& groups, std::string const& name, Normal const& normal) {
  using namespace fields;
  using P = typename S::policy;
  using X = Vec<Dim, double>;
  auto const& wall = solver.template body<Body>();
  detail::check_number_in(groups, solver.template whole<Body>().size());
  auto const range = groups.range(name);
  auto const x = wall.to_host(position);
  auto const particles = wall.to_host(identity);
  auto normals = wall.to_host(slip_normal);
  for (std::size_t w = 0; w < normals.size(); ++w) {
    if (!range.contains(particles[w])) continue;
    X n = detail::vector_at<X>(normal, x[w]);
    double const length = norm(n);
    if (length != 0) n /= length;
    normals[w] = n.template cast<typename P::real>();
  }
  solver.template set<Body>(slip_normal, normals, [](auto const& n) { return n; });
}

}  // namespace scree
