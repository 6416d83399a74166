// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"

namespace scree {

/// Contact among rigid bodies and between rigid bodies and walls, by a penalty. Surfaces are half a spacing outside of
/// the outermost particles; where two of them overlap by d, a pressure `modulus` d/spacing acts along their common
/// normal. It is smaller by the square of the restitution while they separate, so that bodies leave with `restitution`
/// times the speed of approach, whatever their masses and the number of touching particles (Walton & Braun 1986, J.
/// Rheol. 30, 949-980, without their history). Friction follows Coulomb's law with a tangential spring that sticks
/// (Cundall & Strack 1979, Geotechnique 29, 47-65); each surface particle stores its displacement, `contact_stretch`.
struct RigidContact {
  /// False: bodies pass through each other and through walls. A run still stops at `largest_overlap`.
  bool acts = true;
  /// Stiffness of the contact, Pa. With 0 it is $\rho c^2$ of the material, if its law has a constant stiffness; for
  /// other physics models the contact then does not act.
  double modulus = 0;
  double restitution = 0.5;  ///< of speeds, -
  double friction = 0.5;     ///< coefficient, -
  /// Speed below which contact damps like a dashpot, so that bodies come to rest, m/s; 0: 2 g/omega + 1e-4 omega
  /// spacing with the largest frequency omega of a contact.
  double damped_below = 0;
  /// Overlap at which a run stops, in spacings, -; infinite: never.
  double largest_overlap = 0.5;

  static constexpr auto parameters() {
    return std::array{
        parameter("modulus", &RigidContact::modulus, "Pa", "stiffness of the contact; 0: from the material",
                  allowed::at_least(0)),
        parameter("restitution", &RigidContact::restitution, "1", "speed of separation over that of approach",
                  allowed::from_to(0, 1)),
        parameter("friction", &RigidContact::friction, "1", "coefficient of friction", allowed::at_least(0)),
        parameter("damped_below", &RigidContact::damped_below, "m/s",
                  "speed below which contact damps like a dashpot; 0: from gravity and stiffness",
                  allowed::at_least(0)),
        parameter("largest_overlap", &RigidContact::largest_overlap, "1", "overlap in spacings at which a run stops",
                  allowed::above_or_infinite(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "RigidContact"); }
};

}  // namespace scree
