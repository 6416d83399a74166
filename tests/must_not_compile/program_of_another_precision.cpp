// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the points have another dimension or precision than the formulation
#include <scree/scree.hpp>

// A whole program: what follows the mistake must not be compiled either.
#ifdef FIXED
using Real = double;
#else
using Real = float;
#endif
struct Sand : scree::Formulation<2, Real> {
  using physics = scree::Granular<>;
};

double run(scree::Groups<2> const& walls, std::vector<scree::Vec<2, double>> const& column) {
  using namespace scree;
  using S = Solver<Sand>;
  S solver({.spacing = 0.1, .physics = {.law = MuOfI<>{}}}, column, walls);
  solver.set(fields::velocity, [](auto const& x) { return x; });
  double height = 0;
  solver.run(0.5, {every<S>(0.1, [&](S& now) {
               for (auto const& x : now.material().to_host(fields::position)) height = std::max(height, double(x[1]));
             })});
  return height;
}
