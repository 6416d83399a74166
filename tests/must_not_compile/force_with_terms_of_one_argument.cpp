// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `terms` of this force cannot be called
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Force {
  template <class I>
  SCREE_FN auto acceleration(I const& i) const {
    return i[scree::fields::velocity];
  }
  using reads = scree::Fields<scree::Velocity>;
#ifdef FIXED
  template <class Body, class Rho>
  std::tuple<> terms(Rho const&, scree::Resolution const&) const {
    return {};
  }
#else
  template <class Body, class Rho>
  std::tuple<> terms(Rho const&) const {
    return {};
  }
#endif
};
struct Models : scree::GranularModels {
  using forces = std::tuple<Force>;
};

struct Case : scree::Formulation<2> {
  using physics = scree::Granular<Models>;
};

void rates(scree::Solver<Case>& solver) { solver.update_rates(); }
