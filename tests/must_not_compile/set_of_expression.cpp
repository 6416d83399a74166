// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: must return a value, not an expression of Eigen
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Velocity>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Case : scree::Formulation<2, float> {
  using physics = NothingHappens;
};

scree::Vec<2, double> speed_at(scree::Vec<2, float> const& x) { return {x[1], 0}; }

void start(scree::Solver<Case>& solver) {
  using namespace scree::fields;
#ifdef FIXED
  solver.set(velocity, [](scree::Vec<2, float> const& x) { return speed_at(x).cast<float>().eval(); });
#else
  solver.set(velocity, [](scree::Vec<2, float> const& x) {
    return speed_at(x).cast<float>();
  });  // refers to destroyed temporaries
#endif
}
