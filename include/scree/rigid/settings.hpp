// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "contact_settings.hpp"
#include "mass_properties.hpp"
#include "spring.hpp"

#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

namespace scree {

/// A rigid body: its properties, its motion at time zero, and the components of its motion that are prescribed instead
/// of computed from forces.
template <int Dim>
struct Rigid {
  MassProperties<Dim> properties = {};                   ///< mass, centre and moments of inertia
  Vec<Dim, double> velocity = Vec<Dim, double>::Zero();  ///< velocity of the centre at time zero, m/s
  Turn<Dim> angular_velocity = Turn<Dim>::Zero();        ///< angular velocity at time zero, rad/s; in 2D one number
  /// Prescribed components of the velocity of the centre, m/s; empty components are free, and 0 holds the body along an
  /// axis.
  std::array<std::optional<double>, Dim> given_velocity = {};
  /// Prescribed components of the angular velocity, rad/s, in the axes of space; empty components are free. A driven
  /// wheel has one prescribed component and is free to sink and travel.
  std::array<std::optional<double>, std::size_t(turns_in<Dim>)> given_turning = {};

  /// Throws std::invalid_argument if a value is out of range.
  void check() const {
    properties.check();
    check_setting(velocity.allFinite(), "velocity of a rigid body (m/s)", velocity.sum(), "finite");
    check_setting(angular_velocity.allFinite(), "angular velocity of a rigid body (rad/s)", angular_velocity.sum(),
                  "finite");
    for (auto const& u : given_velocity)
      check_setting(!u || std::isfinite(*u), "given velocity of a rigid body (m/s)", u.value_or(0), "finite");
    for (auto const& w : given_turning)
      check_setting(!w || std::isfinite(*w), "given angular velocity of a rigid body (rad/s)", w.value_or(0), "finite");
  }
};

/// The rigid bodies of a formulation, in the order of the groups of their particles.
template <int Dim>
struct RigidBodies {
  std::vector<Rigid<Dim>> bodies = {};    ///< one for each group of rigid particles
  RigidContact contact = {};              ///< contact of bodies with each other and with walls
  std::vector<Spring<Dim>> springs = {};  ///< springs between bodies, or between a body and a fixed point
  double angle_per_step = 0.05;           ///< largest rotation in one step, rad
  double spacings_per_step = 0.1;         ///< largest displacement of a particle in one step over the spacing, -

  static constexpr auto parameters() {
    return std::array{
        parameter("angle_per_step", &RigidBodies::angle_per_step, "rad", "largest rotation in one step",
                  allowed::above_or_infinite(0)),
        parameter("spacings_per_step", &RigidBodies::spacings_per_step, "1",
                  "largest way of a surface particle in one step over the spacing", allowed::above_or_infinite(0))};
  }

  /// Throws std::invalid_argument if a value is out of range; errors of Rigid::check() also name the number of the
  /// body.
  void check() const {
    check_parameters(*this, "RigidBodies");
    contact.check();
    for (auto const& spring : springs) spring.check(int(bodies.size()));
    for (std::size_t k = 0; k < bodies.size(); ++k) try {
        bodies[k].check();
      } catch (std::invalid_argument const& error) {
        throw std::invalid_argument(detail::formatted("%s (rigid body %zu)", error.what(), k));
      }
  }
};
/// The settings of a solver without rigid bodies.
struct NoRigidBodies {};

}  // namespace scree
