// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the velocity of particles that enter is that of the inlet
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

// The particles behind an inlet would move with one velocity and be made as if they moved with another.
struct Fed : scree::Formulation<2> {
  using physics = scree::Granular<>;
  using carries = scree::Fields<scree::Held>;
};

void feed(scree::Solver<Fed>& solver, scree::Inlet<2> const& inlet) {
#ifdef FIXED
  solver.feed(inlet);
#else
  solver.feed(inlet, scree::given(scree::fields::velocity, scree::Vec<2, double>(1, 0)));
#endif
}
