// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the closure reads the stress, and nothing gives it here: combine the segregation with a mechanics
#include <scree/granular/segregating.hpp>
#include <scree/scree.hpp>
#include <scree/segregation/trewhela_closure.hpp>

using Segregation = scree::ConservativeSegregation<scree::TrewhelaClosure>;
struct Sorting : scree::Formulation<2> {
#ifdef FIXED
  using physics = scree::SegregatingGranular<scree::Granular<>, Segregation>;
#else
  using physics = Segregation;
#endif
};

scree::Solver<Sorting> solver({.spacing = 0.01}, {}, {});
