// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../formulation/explain.hpp"
#include "population.hpp"

#include <tuple>
#include <type_traits>

// A formulation that replaces a faulty one while the compiler processes the rest of a program, so that the compiler
// reports only the fault. None of this code ever runs.
namespace scree::detail {

struct NothingEvolves {
  using evolves = Fields<>;
  std::tuple<> passes(Resolution const&) const { return {}; }
  std::tuple<> limits(Resolution const&) const { return {}; }
};
template <class P>
struct dimension_and_real {
  using type = Formulation<3, double>;
};
template <class P>
requires((P::dim == 2 || P::dim == 3) && std::is_floating_point_v<typename P::real>) struct dimension_and_real<P> {
  using type = Formulation<P::dim, typename P::real>;
};
/// A formulation that evolves nothing, with the fields that programs usually write or set.
template <class P>
struct StandIn : dimension_and_real<P>::type {
  using physics = NothingEvolves;
  using carries = Fields<Velocity, Acceleration, Density, Stress, ShearRate, Concentration, Group, WallForce>;
};

}  // namespace scree::detail
