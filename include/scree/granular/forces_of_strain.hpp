// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/antisymmetric_stress.hpp"
#include "../passes/pass.hpp"
#include "strain.hpp"

#include <tuple>
#include <type_traits>

// What the choice of the strain adds to the momentum balance, so that the forces do the work of the stress on it.
namespace scree::granular {

/// Nothing, for a strain that is the plain velocity gradient; the corrected one has no forces whose work it is.
///   computes                    as of ViscosityScheme
///   passes_if(active)           passes before the strain rates, made to run only if `active` is true
///   passes()                    passes before the acceleration
///   projections()               passes after an update of the stress
///   terms<Body>(rho)            terms of the acceleration
template <class Strain, class Walls>
struct ForcesOfStrain {
  using computes = Fields<>;
  std::tuple<> passes_if(bool) const { return {}; }
  std::tuple<> passes() const { return {}; }
  std::tuple<> projections() const { return {}; }
  template <BodyTag Body, class Rho>
  std::tuple<> terms(Rho const&) const {
    return {};
  }
};
/// The antisymmetric stress, from the stress and from the first moment that the last evaluation of strain rates left:
/// so all rates of a state are computed in one sweep over neighbours, as without it.
template <IsObjective Strain, class Walls>
struct ForcesOfStrain<Strain, Walls> {
  using computes = Fields<FirstMoment>;
  auto passes_if(bool active) const { return only_if(active, projections()); }
  auto projections() const {
    return std::tuple(point_pass<Material>("scree::antisymmetric_stress", AntisymmetricStressOf{}));
  }
  auto passes() const {
    if constexpr (shows_means<Walls>)
      return std::tuple(pair_pass_then<Wall>("scree::wall_antisymmetric_stress", walls::MeanAntisymmetricStress{},
                                             over<Material>(adami::Weights{}, adami::Weighted<AntisymmetricStress>{})));
    else
      return std::tuple<>();
  }
  template <BodyTag Body, class Rho>
  auto terms(Rho const& rho) const {
    if constexpr (std::is_same_v<Body, Material>)
      return std::tuple(AntisymmetricStressDivergence<Rho>{rho});
    else
      return std::tuple(AntisymmetricStressAtWall<Rho, shows_means<Walls>>{rho});
  }
};

}  // namespace scree::granular
