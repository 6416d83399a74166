// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A granular bed, as a user writes it.
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

namespace {

struct Bed : scree::Formulation<2> {
  using physics = scree::Granular<>;
};

}  // namespace

void simulate_bed(std::vector<scree::Vec<2, double>> const& points) {
  scree::Solver<Bed>({.spacing = 0.01}, points).run(1);
}
