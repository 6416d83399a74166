// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/granular/granular.hpp>

#include <support/points.hpp>

// Sand without weight, for tests of particles that come and go.
namespace scree::test {

inline Granular<> weightless() {
  Granular<> physics;
  physics.gravity = {0};
  physics.law.elastic = {1e5, 0.3, 1500};
  physics.law.grains = {0.01};
  return physics;
}
/// Points in the precision of a formulation.
template <class F>
auto points_of(Points<F::dim> const& points) {
  return cast<typename F::real>(points);
}

}  // namespace scree::test
