// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../laws/law.hpp"
#include "strain.hpp"

// Fields and bounds for laws that differ between groups of particles, see laws/by_group.hpp.
namespace scree::granular {

/// Computes the density of a particle from its law.
template <class Law>
struct DensityByLaw {
  Law law;
  using reads = point_of<Law>;
  using writes = Fields<Density>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[fields::density] = law.density(i);
  }
};

/// Computes the distance of the group number of a particle from the range 0 to `groups` - 1.
struct GroupOutside {
  int groups;
  using reads = Fields<Group>;
  template <class I>
  SCREE_FN double operator()(I const& i) const {
    int const number = i[fields::group];
    return Kokkos::max(0, Kokkos::max(-number, number - groups + 1));
  }
};

}  // namespace scree::granular
