// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the groups have another dimension than the formulation
#include <scree/scree.hpp>

// A whole program: what follows the mistake must not be compiled either.
struct Sand : scree::Formulation<3> {
  using physics = scree::Granular<>;
};
#ifdef FIXED
using Walls = scree::Groups<3>;
#else
using Walls = scree::Groups<2>;
#endif

double run(Walls const& walls, std::vector<scree::Vec<3, double>> const& column) {
  using namespace scree;
  using S = Solver<Sand>;
  S solver({.spacing = 0.1, .physics = {.law = MuOfI<>{}}}, column, walls);
  solver.set(fields::velocity, [](auto const& x) { return x; });
  double height = 0;
  solver.run(0.5, {every<S>(0.1, [&](S& now) {
               for (auto const& x : now.material().to_host(fields::position)) height = std::max(height, double(x[2]));
             })});
  return height;
}
