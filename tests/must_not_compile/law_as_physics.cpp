// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a law is no `physics`: name it as `law` in a class of models
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Case : scree::Formulation<2> {
#ifdef FIXED
  using physics = scree::Granular<>;
#else
  using physics = scree::MuOfI<>;
#endif
};

double run(std::vector<scree::Vec<2, double>> const& points) {
  scree::Solver<Case> solver({.spacing = 0.1}, points);
  solver.set(scree::fields::velocity, [](auto const& x) { return x; });
  return solver.time();
}
