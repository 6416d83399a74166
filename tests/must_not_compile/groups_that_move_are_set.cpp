// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the motion of this body is by group, so its groups are fixed: make the solver from `Groups`
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/solver/solver.hpp>

struct Falls {
  using evolves = scree::Fields<scree::Velocity, scree::Position>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};
struct Case : scree::Formulation<2> {
  using physics = Falls;
  using motion = scree::MotionOfGroups<2, scree::Rotation>;
};

scree::Solver<Case> start(scree::Vec<2, double> const& x) {
#ifdef FIXED
  return scree::Solver<Case>({.spacing = 0.1}, {}, scree::Groups<2>().add("wall", {x}));
#else
  scree::Solver<Case> solver({.spacing = 0.1}, {}, {x});
  solver.set<scree::Wall>(scree::fields::group, [](scree::Vec<2, double> const&) { return 1; });
  return solver;
#endif
}
