// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the bodies of an output are a list
#include <scree/io/body_series.hpp>
#include <scree/solver/solver.hpp>

#include "nothing_happens.hpp"

void run(S& solver) {
  using List = scree::Fields<scree::Concentration>;
#ifdef FIXED
  scree::BodySeries series("particles.vtkhdf", List{}, scree::Bodies<scree::Material>{});
#else
  scree::BodySeries series("particles.vtkhdf", List{}, scree::Material{});
#endif
  series.append(solver);
}
