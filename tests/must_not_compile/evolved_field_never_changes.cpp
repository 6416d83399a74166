// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `evolves` names a field without a rate that no pass writes
#include <scree/solver/solver.hpp>

#include <tuple>

struct Moisture : scree::Scalar<"moisture", "1"> {
#ifdef FIXED
  struct Rate : scree::Scalar<"moisture rate", "1/s"> {};
  using rate = Rate;
#endif
};

struct Drying {
  using evolves = scree::Fields<Moisture>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Case : scree::Formulation<2> {
  using physics = Drying;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
