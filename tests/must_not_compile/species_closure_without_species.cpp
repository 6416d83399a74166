// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this is not a SpeciesClosure: it needs the number of its species
#include <scree/segregation/species_segregation.hpp>

struct Percolation {
#ifdef FIXED
  static constexpr int species = 3;
#endif
  using reads = scree::Fields<>;
  using writes = scree::Fields<scree::SegregationVelocities<3>, scree::Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[scree::fields::segregation_velocities<3>][0] = 1;
  }
};

scree::SpeciesSegregation<Percolation> const physics{};
