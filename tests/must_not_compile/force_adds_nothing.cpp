// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this force adds nothing: it needs acceleration\(i\), or terms<Body>\(rho, resolution\)
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

struct Drag {
  using reads = scree::Fields<scree::Velocity>;
#ifdef FIXED
  template <class I>
  SCREE_FN auto acceleration(I const& i) const {
    return i[scree::fields::velocity];
  }
#else
  template <class I>
  SCREE_FN auto accelerate(I const& i) const {
    return i[scree::fields::velocity];
  }
#endif
};
struct Models : scree::GranularModels {
  using forces = std::tuple<Drag>;
};
struct Case : scree::Formulation<2> {
  using physics = scree::Granular<Models>;
};

void rates(scree::Solver<Case>& solver) { solver.update_rates(); }
