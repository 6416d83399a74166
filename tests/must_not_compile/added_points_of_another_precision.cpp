// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the points have another dimension or precision than the formulation
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

struct InFloat : scree::Formulation<2, float> {
  using physics = NothingHappens;
};
void run(scree::Solver<InFloat>& solver, Points const& points) {
  using scree::fields::concentration;
#ifdef FIXED
  solver.add(scree::cast<float>(points), scree::given(concentration, 1));
#else
  solver.add(points, scree::given(concentration, 1));
#endif
}
