// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/slip_normal.hpp"
#include "set_group.hpp"

#include <string>

namespace scree {
namespace detail {

/// Returns a given vector, or the value of a given function at a point. Eigen vectors can be called, too, so their
/// member type `Scalar` tells them from functions.
template <class X, class Normal, class Point>
X vector_at(Normal const& normal, Point const& x) {
  if constexpr (requires { typename Normal::Scalar; })
    return X(normal.template cast<double>());
  else
    return X(normal(x).template cast<double>());
}

}  // namespace detail

/// Makes a group of the wall a slip wall. `normal` is a vector, or a function of the present position (m) that returns
/// one, of any length above zero; zero vectors make particles stick again, as they do at the start. Normals are fixed
/// in space. Throws std::invalid_argument as SlipNormal::check_on_wall() does, or if there is no such group.
template <BodyTag Body = Wall, class S, int Dim, class Normal>
void set_slip(S& solver, Groups<Dim> const& groups, std::string const& name, Normal const& normal) {
  using X = Vec<Dim, double>;
  using Value = value_t<typename S::policy, SlipNormal>;
  set_group<Body>(solver, fields::slip_normal, groups, name, [&](auto const& x) {
    X n = detail::vector_at<X>(normal, x);
    double const length = norm(n);
    if (length != 0) n /= length;
    return Value(n.template cast<typename Value::Scalar>());
  });
}

}  // namespace scree
