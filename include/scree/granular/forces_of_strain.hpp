// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/antisymmetric_stress.hpp"
#include "../passes/pass.hpp"
#include "strain.hpp"

#include <tuple>
#include <type_traits>

// The forces in the momentum balance that belong to a choice of strain: with them the forces do the same work as the
// stress on that strain.
namespace scree::granular {

/// The forces of PlainStrain and CorrectedStrain: none in addition to the divergence of the stress. The type `computes`
/// has the same meaning as in ViscosityScheme.
template <class Strain, class Walls>
struct ForcesOfStrain {
  using computes = Fields<>;
  /// Returns the passes that run before the strain rates, if the argument is true: none.
  std::tuple<> passes_if(bool) const { return {}; }
  /// Returns the passes that run before the acceleration: none.
  std::tuple<> passes() const { return {}; }
  /// Returns the passes that run after an update of the stress: none.
  std::tuple<> projections() const { return {}; }
  /// Returns the terms of the acceleration over the particles of a body: none.
  template <BodyTag Body, class Rho>
  std::tuple<> terms(Rho const&) const {
    return {};
  }
};
/// The forces of ObjectiveStrain: the antisymmetric stress, computed from the stress and from the first moment that the
/// last evaluation of strain rates stored. All rates of a state can therefore be computed in one sweep over neighbours,
/// as without an antisymmetric stress.
template <IsObjective Strain, class Walls>
struct ForcesOfStrain<Strain, Walls> {
  using computes = Fields<FirstMoment>;
  using Lens = decltype(std::declval<Walls const&>().lens(UniformDensity{}, Gravity{}));
  static constexpr ShownByWall shown = !shows_means<Walls>              ? ShownByWall::own
                                       : OneOf<OnPlate, reads_of<Lens>> ? ShownByWall::own_on_plates
                                                                        : ShownByWall::mean;
  /// Returns the pass of projections(), which runs only if `active` is true.
  auto passes_if(bool active) const { return only_if(active, projections()); }
  /// Returns the pass that computes the antisymmetric stress of the material.
  auto projections() const {
    return std::tuple(point_pass<Material>("scree::antisymmetric_stress", AntisymmetricStressOf{}));
  }
  /// Returns the pass that computes the antisymmetric stress of walls, if the scheme computes means for them.
  auto passes() const {
    if constexpr (shows_means<Walls>)
      return std::tuple(pair_pass_then<Wall>("scree::wall_antisymmetric_stress", walls::MeanAntisymmetricStress{},
                                             over<Material>(adami::Weights{}, adami::Weighted<AntisymmetricStress>{})));
    else
      return std::tuple<>();
  }
  /// Returns the divergence of the antisymmetric stress over the particles of a body.
  template <BodyTag Body, class Rho>
  auto terms(Rho const& rho) const {
    if constexpr (std::is_same_v<Body, Material>)
      return std::tuple(AntisymmetricStressDivergence<Rho>{rho});
    else
      return std::tuple(AntisymmetricStressAtWall<Rho, shown>{rho});
  }
};

}  // namespace scree::granular
