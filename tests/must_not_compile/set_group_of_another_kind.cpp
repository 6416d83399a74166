// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: returns another kind of value than the field has
#include <scree/solver/set_group.hpp>
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver, scree::Groups<2> const& groups) {
  using namespace scree::fields;
#ifdef FIXED
  set_group(solver, position, groups, "gate", [](auto const& x) { return x; });
#else
  set_group(solver, position, groups, "gate", [](auto const&) { return 0.0; });
#endif
}
