// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// One more formulation with the basis of the first: it shares the loops of the basis.
#include <scree/laws/drucker_prager.hpp>

#include "one_formulation.cpp"

namespace {

struct Cohesive : scree::GranularModels {
  using law = scree::DruckerPrager;
};
struct Soil : scree::Formulation<2> {
  using physics = scree::Granular<Cohesive>;
};

}  // namespace

void simulate_soil(std::vector<scree::Vec<2, double>> const& points) {
  scree::Solver<Soil>({.spacing = 0.01}, points).run(1);
}
