// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/segregation/closure.hpp>
#include <scree/segregation/species_closure.hpp>

namespace scree::test::archetypes {

struct Closure {
  using reads = Fields<>;
  using writes = Fields<SegregationVelocity, Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    using namespace fields;
    out[segregation_velocity] = 0.1;
    out[diffusivity] = 0.01;
  }
};
static_assert(SegregationClosure<Closure, detail::AnyPoint>);

struct ClosureOfSpecies {
  static constexpr int species = 3;
  using reads = Fields<>;
  using writes = Fields<SegregationVelocities<3>, Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    using namespace fields;
    out[segregation_velocities<3>] = Vec<3, double>(0.1, 0.2, 0.1);
    out[diffusivity] = 0.01;
  }
};
static_assert(SpeciesClosure<ClosureOfSpecies, detail::AnyPoint>);
static_assert(!FactoredClosure<ClosureOfSpecies>);

struct ClosureWithFactors : ClosureOfSpecies {
  static constexpr int factors = 1;
  using factors_of = ClosureWithFactors;
  template <class I>
  SCREE_FN Vec<1, double> factors_at(I const&) const {
    return Vec<1, double>(0.1);
  }
  template <class I>
  SCREE_FN double diffusivity_at(I const&) const {
    return 0.01;
  }
  Vec<1, double> speeds_of_pair(int k, int l) const { return Vec<1, double>(double(l - k)); }
};
static_assert(SpeciesClosure<ClosureWithFactors, detail::AnyPoint> && FactoredClosure<ClosureWithFactors>);

}  // namespace scree::test::archetypes
