// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/conserving.hpp"
#include "../laws/mu_of_i.hpp"
#include "advection.hpp"
#include "default_control.hpp"
#include "section.hpp"
#include "strain.hpp"
#include "stress_filter.hpp"
#include "viscosity.hpp"

#include <tuple>

namespace scree {

/// The models of Granular with their defaults. A class derived from GranularModels overrides any of them:
///
///     struct Clay : GranularModels { using law = DruckerPrager; using filter = NoFilter; };
///     using physics = Granular<Clay>;
///
/// parts_of() returns the models of a formulation as text.
struct GranularModels {
  using law = MuOfI<>;                  ///< ConstitutiveLaw
  using section = SectionByLaw;         ///< YieldSection; by default that of sand in 3D, see SectionByLaw
  using filter = LinearFilter;          ///< StressFilter
  using volume_control = ControlByLaw;  ///< VolumeControl; by default the one that the law needs
  using walls = ConservingWalls;        ///< WallScheme
  using viscosity = PlainViscosity;     ///< ViscosityScheme; or ResidualViscosity
  using strain = PlainStrain;           ///< StrainChoice; or CorrectedStrain, ObjectiveStrain
  using forces = std::tuple<>;          ///< forces in addition to stress, viscosity and gravity; see forces.hpp
  using advection = OwnVelocity;        ///< AdvectionScheme, the velocity that moves particles; or Xsph
};

}  // namespace scree
