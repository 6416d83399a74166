// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: both models of Combined evolve the same field
#include <scree/granular/segregating.hpp>
#include <scree/segregation/constant_closure.hpp>

using Segregation = scree::ConservativeSegregation<scree::ConstantClosure>;
using Sorting = scree::SegregatingGranular<scree::Granular<>, Segregation>;
#ifdef FIXED
using Physics = Sorting;
#else
using Physics = scree::Combined<Sorting, Segregation>;
#endif

auto limits(Physics const& physics) { return physics.limits({}); }
