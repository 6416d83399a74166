// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the values of this field are integers, which have no mean
#include <scree/granular/granular.hpp>
#include <scree/probes/coarse_grained.hpp>
#include <scree/solver/solver.hpp>

struct Case : scree::Formulation<2> {
  using physics = scree::Granular<>;
};
#ifdef FIXED
using Field = scree::Velocity;
#else
using Field = scree::Identity;
#endif

auto mean_of(scree::Solver<Case> const& solver) {
  return scree::coarse_grained(solver, {.box = {{0, 0}, {1, 1}}, .cell = {0.1, 0.1}}, scree::Fields<Field>{}).weight;
}
