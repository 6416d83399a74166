// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the fields of an output are a list
#include <scree/io/body_series.hpp>
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver) {
#ifdef FIXED
  scree::BodySeries series("particles.vtkhdf", scree::Fields<scree::Concentration>{});
#else
  scree::BodySeries series("particles.vtkhdf", scree::fields::concentration);
#endif
  series.append(solver);
}
