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

/// Nothing, for a strain that is the plain velocity gradient; the corrected one has no forces whose work it is. Members
/// as of ViscosityScheme and of Force.
template <class Strain, class Walls>
struct ForcesOfStrain {
  using computes = Fields<>;
  std::tuple<> passes() const { return {}; }
  template <BodyTag Body, class Rho>
  std::tuple<> terms(Rho const&) const {
    return {};
  }
};
/// The antisymmetric stress, from the stress and the first moment that the strain rates keep.
template <IsObjective Strain, class Walls>
struct ForcesOfStrain<Strain, Walls> {
  using computes = Fields<FirstMoment>;
  auto passes() const {
    auto const of_material = point_pass<Material>("scree::antisymmetric_stress", AntisymmetricStressOf{});
    if constexpr (shows_means<Walls>)
      return std::tuple(of_material,
                        pair_pass_then<Wall>("scree::wall_antisymmetric_stress", walls::MeanAntisymmetricStress{},
                                             over<Material>(adami::Weights{}, adami::Weighted<AntisymmetricStress>{})));
    else
      return std::tuple(of_material);
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
