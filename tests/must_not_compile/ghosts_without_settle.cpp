// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `ghosts` of this formulation is no GhostProvider
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

template <class P>
struct None {
  using Settings = std::vector<scree::Period>;
  None(Settings const&, double, double) {}
  Settings settings() const { return {}; }
  std::string signature() const { return ""; }
  bool any() const { return false; }
#ifdef FIXED
  template <class Body>
  void settle(Body&) const {}
#endif
  template <class Body>
  void create(Body&) {}
  template <class Body, class List>
  void refresh(Body&, List) const {}
};
struct Flow : scree::Formulation<2> {
  using physics = scree::Granular<>;
  template <class P>
  using ghosts = None<P>;
};
double advance(scree::Solver<Flow>& solver) { return solver.step(1); }
