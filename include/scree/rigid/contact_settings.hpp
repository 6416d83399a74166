// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"

namespace scree {

/// Contact among rigid bodies and between rigid bodies and walls, by a penalty method. Surfaces are half a spacing
/// outside the outermost particles. If two surfaces overlap by d, a pressure `modulus` d/spacing acts along their
/// common normal. During separation the pressure is multiplied by the square of the restitution, so that bodies
/// separate at `restitution` times the speed of approach, whatever their masses and the number of touching particles
/// (Walton & Braun 1986, J. Rheol. 30, 949-980, without their history). Friction follows Coulomb's law, with a
/// tangential spring during sticking (Cundall & Strack 1979, Geotechnique 29, 47-65); each surface particle stores the
/// displacement of this spring, `contact_stretch`.
struct RigidContact {
  /// Whether contact forces act. If false, bodies pass through each other and through walls, but a run still stops at
  /// `largest_overlap`.
  bool acts = true;
  /// Stiffness of the contact, Pa. If it is 0, $\rho c^2$ of the material is used if its law has a constant stiffness;
  /// for other physics models no contact forces act.
  double modulus = 0;
  double restitution = 0.5;  ///< speed of separation over speed of approach, -
  double friction = 0.5;     ///< friction coefficient, -
  /// Speed, m/s, below which contact damps like a dashpot, so that bodies come to rest. If it is 0, 2 g/omega + 1e-4
  /// omega spacing is used, with omega the largest angular frequency of a contact.
  double damped_below = 0;
  /// Overlap at which a run stops, in spacings, dimensionless; if infinite, a run never stops because of overlap.
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
