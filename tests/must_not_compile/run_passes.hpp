// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

#include <scree/solver/solver.hpp>

// Runs passes of a physics model; `passes_of_case()` gives them.
struct Physics {
  using evolves = scree::Fields<scree::Concentration>;
  auto passes(scree::Resolution const&) const { return passes_of_case(); }
};
struct Case : scree::Formulation<2> {
  using physics = Physics;
};
inline void run(scree::Solver<Case>& solver) { solver.update_rates(); }
