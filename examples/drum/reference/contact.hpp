// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <Kokkos_Core.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

// The force between two spheres that touch: a linear spring and a dashpot along the normal, which never attract, and a
// tangential spring and dashpot that slide by Coulomb's law.
namespace grains {

/// Four floats that are read and written at once; w is free.
struct alignas(16) Vector {
  float x = 0, y = 0, z = 0, w = 0;
};
KOKKOS_INLINE_FUNCTION Vector operator+(Vector const& a, Vector const& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
KOKKOS_INLINE_FUNCTION Vector operator-(Vector const& a, Vector const& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
KOKKOS_INLINE_FUNCTION Vector operator*(float s, Vector const& a) { return {s * a.x, s * a.y, s * a.z}; }
KOKKOS_INLINE_FUNCTION float dot(Vector const& a, Vector const& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
KOKKOS_INLINE_FUNCTION Vector cross(Vector const& a, Vector const& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Numbers of the grains' material.
struct Material {
  double density = 2500;     ///< of the solid, kg/m^3
  double modulus = 4e4;      ///< Pa; two spheres of radius r have the stiffness modulus * r, see stiffness()
  double restitution = 0.8;  ///< of a head-on collision
  double friction = 0.5;     ///< Coulomb's coefficient, also at walls
};

/// Damping ratio of the dashpot, from the coefficient of restitution e of spheres that part as soon as their force is
/// zero.
inline double damping_ratio(double restitution) {
  if (!(restitution > 0 && restitution <= 1)) throw std::runtime_error("restitution must be in (0, 1]");
  // overlap = sin(w t) exp(-b t), b^2 + w^2 = 1; its second derivative is zero at w t = pi - atan2(2 b w, w^2 - b^2),
  // and the speed there is exp(-b t) of the first
  auto const restitution_of = [](double b) {
    double const w = std::sqrt(1 - b * b);
    return std::exp(-b / w * (std::numbers::pi - std::atan2(2 * b * w, w * w - b * b)));
  };
  double low = 0, high = 1 - 1e-9;
  if (restitution < restitution_of(high)) throw std::runtime_error("restitution is below that of critical damping");
  for (int k = 0; k < 100; ++k) {
    double const middle = (low + high) / 2;
    (restitution_of(middle) > restitution ? low : high) = middle;
  }
  return low;
}

inline double mass(Material const& m, double radius) {
  return 4 * std::numbers::pi / 3 * m.density * radius * radius * radius;
}
/// Stiffness of the contact of two spheres, N/m.
inline double stiffness(Material const& m, double radius_i, double radius_j) {
  return m.modulus * 2 * radius_i * radius_j / (radius_i + radius_j);
}
/// Duration of a head-on collision of two spheres of one radius, s.
inline double collision_time(Material const& m, double radius) {
  double const b = damping_ratio(m.restitution), w = std::sqrt(1 - b * b);
  return (std::numbers::pi - std::atan2(2 * b * w, w * w - b * b)) / w *
         std::sqrt(mass(m, radius) / 2 / stiffness(m, radius, radius));
}

/// The material as the step uses it.
struct Law {
  float modulus = 0, friction = 0;
  float twice_damping = 0;  ///< 2 * damping ratio
  float mass_factor = 0;    ///< mass / radius^3

  Law() = default;
  explicit Law(Material const& m)
      : modulus(float(m.modulus)),
        friction(float(m.friction)),
        twice_damping(float(2 * damping_ratio(m.restitution))),
        mass_factor(float(mass(m, 1))) {}
  KOKKOS_FUNCTION float mass_of(float radius) const { return mass_factor * radius * radius * radius; }
};

/// Tangential over normal stiffness, and the same of the dashpots: then both directions are damped by the same ratio.
inline constexpr float tangential_share = 2.0f / 7.0f;

/// The geometry and motion of a contact. All of it changes its sign, or stays, when they change places.
struct Touch {
  Vector normal;         ///< towards the body that feels the force
  float overlap;         ///< m
  float stiffness;       ///< N/m
  float effective_mass;  ///< kg
  Vector approach;       ///< velocity of the body against the other one at the point of contact, m/s
};

/// Force on the body; advances its tangential spring, which is the elastic slip in m, by a step.
KOKKOS_INLINE_FUNCTION Vector force(Law const& law, Touch const& t, float step, Vector& spring) {
  float const dashpot = law.twice_damping * Kokkos::sqrt(t.effective_mass * t.stiffness);
  float const along = dot(t.approach, t.normal);
  float const normal_force = Kokkos::fmax(0.0f, t.stiffness * t.overlap - dashpot * along);
  Vector const slip = t.approach - along * t.normal;
  // the spring turns with the pair and keeps its length
  float const before = dot(spring, spring);
  Vector turned = spring - dot(spring, t.normal) * t.normal;
  float const after = dot(turned, turned);
  if (after > 0) turned = Kokkos::sqrt(before / after) * turned;
  turned = turned + step * slip;
  float const k = tangential_share * t.stiffness;
  Vector tangential = -k * turned - tangential_share * dashpot * slip;
  float const limit = law.friction * normal_force, size = Kokkos::sqrt(dot(tangential, tangential));
  if (size > limit) {
    tangential = (limit / size) * tangential;
    turned = (-1 / k) * tangential;
  }
  spring = turned;
  return tangential + normal_force * t.normal;
}

}  // namespace grains
