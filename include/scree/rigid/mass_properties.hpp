// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/principal.hpp"
#include "../core/setting.hpp"
#include "turning.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

/// Mass, centre of mass and inertia of a rigid body; in 2D of a slice one metre deep. The functions in
/// measured_mass.hpp compute them for shapes and meshes.
template <int Dim>
struct MassProperties {
  double mass = 0;                                     ///< kg
  Vec<Dim, double> centre = Vec<Dim, double>::Zero();  ///< centre of mass at time zero, m
  Inertia<Dim> inertia = Inertia<Dim>::Zero();         ///< about the centre, in the axes of space at time zero, kg m^2

  /// Throws std::invalid_argument if no body can have these properties: mass and principal moments must be finite and
  /// positive, the centre finite, and the inertia symmetric, and no principal moment may exceed the sum of the other
  /// two.
  void check() const {
    check_setting(mass > 0 && std::isfinite(mass), "mass of a rigid body (kg)", mass, "above 0");
    check_setting(centre.allFinite(), "centre of a rigid body (m)", centre.sum(), "finite");
    if constexpr (Dim == 2) {
      check_setting(inertia(0, 0) > 0 && std::isfinite(inertia(0, 0)), "inertia of a rigid body (kg m^2)",
                    inertia(0, 0), "above 0");
    } else {
      double const skew = (inertia - inertia.transpose()).norm();
      check_setting(skew <= 1e-9 * inertia.norm(), "inertia of a rigid body (kg m^2), its skew part,", skew, "0");
      Vec<3, double> I = principal(inertia).values;
      std::sort(I.data(), I.data() + 3);
      check_setting(I[0] > 0 && std::isfinite(I[2]), "least principal moment of a rigid body (kg m^2)", I[0],
                    "above 0");
      check_setting(I[2] <= (I[0] + I[1]) * (1 + 1e-9), "largest principal moment of a rigid body (kg m^2)", I[2],
                    "at most the sum of the other two");
    }
  }
};

}  // namespace scree
