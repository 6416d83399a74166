// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `kernel` is not a SmoothingKernel: it needs support, w\(q\), dw_over_q\(q\) and sigma<Dim>\(\)
#include <scree/solver/solver.hpp>

struct NothingHappens {
  using evolves = scree::Fields<scree::Concentration>;
  std::tuple<> passes(scree::Resolution const&) const { return {}; }
  std::tuple<> limits(scree::Resolution const&) const { return {}; }
};

struct Cone {
  static constexpr double support = 2;
  template <class T>
  SCREE_FN static T w(T q) {
    return 2 - q;
  }
#ifdef FIXED
  template <class T>
  SCREE_FN static T dw_over_q(T q) {
    return -1 / q;
  }
#endif
  template <int Dim>
  static constexpr double sigma() {
    return 1;
  }
};

struct Case : scree::Formulation<2> {
  using kernel = Cone;
  using physics = NothingHappens;
};

double run(scree::Solver<Case>& solver) { return solver.time(); }
