// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: is not a PrescribedMotion: it needs displaced
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Still {
  template <class X>
  SCREE_FN X displaced(X const& x, double, double) const {
    return x;
  }
  template <class X>
  SCREE_FN X velocity(X const&, double) const {
    return scree::zero<X>();
  }
#ifdef FIXED
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return scree::zero<X>();
  }
#endif
  double time_step() const { return 1; }
};

struct Case : scree::Formulation<2> {
  using physics = NothingHappens;
  using motion = Still;
};

double run(scree::Solver<Case>& solver) { return solver.step(1); }
