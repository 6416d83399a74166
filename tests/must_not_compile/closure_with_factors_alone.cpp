// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: this closure has `factors`, an int M above 0, and lacks what goes with it
#include <scree/segregation/species_segregation.hpp>

struct Percolation {
  static constexpr int species = 3, factors = 1;
  using factors_of = Percolation;
  using reads = scree::Fields<>;
  using writes = scree::Fields<scree::SegregationVelocities<3>, scree::Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const&, O& out) const {
    out[scree::fields::segregation_velocities<3>] = scree::Vec<3, double>(1, 2, 1);
  }
  template <class I>
  SCREE_FN scree::Vec<1, double> factors_at(I const&) const {
    return scree::Vec<1, double>(1.0);
  }
#ifdef FIXED
  template <class I>
  SCREE_FN double diffusivity_at(I const&) const {
    return 0;
  }
#endif
  scree::Vec<1, double> speeds_of_pair(int k, int l) const { return scree::Vec<1, double>(double(l - k)); }
};

scree::SpeciesSegregation<Percolation> const physics{};
