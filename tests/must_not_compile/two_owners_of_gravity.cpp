// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the transport has a gravity of its own, which may differ from that of the mechanics
#include <scree/granular/segregating.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/under_gravity.hpp>

using Segregation = scree::ConservativeSegregation<scree::ConstantClosure>;
#ifdef FIXED
using Physics = scree::SegregatingGranular<scree::Granular<>, Segregation>;
#else
using Physics = scree::SegregatingGranular<scree::Granular<>, scree::UnderGravity<Segregation>>;
#endif

auto passes(Physics const& physics) { return physics.passes({}); }
