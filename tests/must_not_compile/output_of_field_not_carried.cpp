// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: no body that is written carries this field
#include <scree/io/body_series.hpp>
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Velocity>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
};

void write(scree::Solver<Case>& solver) {
#ifdef FIXED
  scree::BodySeries output("particles.vtkhdf", scree::Fields<scree::Velocity>{});
#else
  scree::BodySeries output("particles.vtkhdf", scree::Fields<scree::Velocity, scree::Stress>{});
#endif
  output.append(solver);
}
