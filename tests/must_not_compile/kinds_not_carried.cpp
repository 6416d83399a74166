// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the material does not carry a field that these kinds of grains read
#include <scree/granular/granular.hpp>
#include <scree/mixing/intensity.hpp>
#include <scree/solver/solver.hpp>

struct Case : scree::Formulation<2> {
  using physics = scree::Granular<>;
#ifdef FIXED
  using carries = scree::Fields<scree::Group>;
#endif
};

double mixing_of(scree::Solver<Case> const& solver) {
  return scree::segregation_intensity(solver, scree::MarkedGroup{1}).value;
}
