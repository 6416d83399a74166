// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/laws/mu_of_i.hpp>

#include <algorithm>
#include <cmath>

namespace inclined_flow {

/// Steady uniform flow of a mu(I) material down a rough plane, plane strain. p = rho g cos(theta)(H - y) and the shear
/// stress rho g sin(theta)(H - y) have the ratio tan(theta) everywhere, so friction, and with it I, are uniform; the
/// shear rate I sqrt(p/rho_s)/d integrates to Bagnold's profile. The friction of plane shear is k_mu, not mu.
struct Bagnold {
  scree::MuOfI<> law;
  double angle = 0;  ///< theta, rad
  double depth = 0;  ///< H, m
  double gravity = 9.81;

  /// mu for which k_mu = tan(theta): k = 3 mu/sqrt(9 + 12 mu^2) solved for mu. Not a number for k >= sqrt(3)/2.
  static double friction_for(double k) { return 3 * k / std::sqrt(9 - 12 * k * k); }

  /// Flow starts where tan(theta) = k_mu at rest and is steady up to k_mu at large I; angles in rad.
  double least_angle() const { return std::atan(scree::friction_ratio(law.mu_s)); }
  double greatest_angle() const { return std::atan(scree::friction_ratio(law.mu_d)); }

  double pressure(double y) const {
    return law.density() * gravity * std::cos(angle) * std::clamp(depth - y, 0.0, depth);
  }
  double shear_stress(double y) const { return std::tan(angle) * pressure(y); }
  double inertial_number() const {
    double const mu = friction_for(std::tan(angle));
    return law.I0 * (mu - law.mu_s) / (law.mu_d - mu);
  }
  double velocity(double y) const {
    double const fraction = law.density() / law.grain_density, left = 1 - std::clamp(y / depth, 0.0, 1.0);
    double const scale = std::sqrt(fraction * gravity * std::cos(angle)) * std::pow(depth, 1.5);
    return 2.0 / 3 * inertial_number() / law.grains.diameter * scale * (1 - std::pow(left, 1.5));
  }
  /// Kinematic viscosity against small changes of the shear rate, (1/rho) dtau/d(shear rate) at half depth, m^2/s: the
  /// reference for other viscosities; it also sets the settling time of the profile.
  double differential_viscosity() const {
    double const I = inertial_number(), p = pressure(depth / 2), mu = friction_for(std::tan(angle));
    double const dmu_dI = (law.mu_d - law.mu_s) * law.I0 / scree::sq(law.I0 + I);
    double const dk_dmu = 27 / std::pow(9 + 12 * mu * mu, 1.5);
    return p * dk_dmu * dmu_dI * law.grains.diameter / std::sqrt(p / law.grain_density) / law.density();
  }
  /// Decay time of the slowest disturbance of a layer that is fixed below and free above, s.
  double settling_time() const { return scree::sq(2 * depth / 3.14159265358979) / differential_viscosity(); }
};

}  // namespace inclined_flow
