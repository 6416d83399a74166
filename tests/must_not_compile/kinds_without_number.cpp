// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: these are no GrainKinds: they need their number
#include <scree/granular/granular.hpp>
#include <scree/mixing/intensity.hpp>
#include <scree/solver/solver.hpp>

struct Case : scree::Formulation<2> {
  using physics = scree::Granular<>;
};
/// Particles on both sides of a line.
struct Sides {
#ifdef FIXED
  static constexpr int kinds = 2;
#endif
  using reads = scree::Fields<scree::Position>;
  template <class I>
  SCREE_FN scree::Vec<2, double> operator()(I const& i) const {
    double const left = i[scree::fields::position][0] < 0 ? 1 : 0;
    return {left, 1 - left};
  }
};

double mixing_of(scree::Solver<Case> const& solver) { return scree::segregation_intensity(solver, Sides{}).value; }
