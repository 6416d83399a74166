// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/columns.hpp"
#include "../passes/time_step.hpp"
#include "state.hpp"

namespace scree::detail {

/// Reducer for the longest time step (s) in which no rigid body rotates by more than `angle` (rad) and none of its
/// particles moves farther than `way` (m). The result is NaN if a state is NaN.
template <class P>
struct LongestRigidStep {
  static constexpr int dim = P::dim;
  using Reads = Fields<RigidVelocity, AngularVelocity, RigidForce, RigidContactForce, RigidSpringForce>;
  using value_type = double;
  Columns<P, Reads> states;
  Span<RigidConstants<dim> const> constants;
  Vec<dim, double> gravity;
  double angle, way;

  SCREE_FN void operator()(int body, double& longest) const {
    using namespace fields;
    Vec<dim, double> const F =
        states.load(rigid_force, body) + states.load(rigid_contact_force, body) + states.load(rigid_spring_force, body);
    double const a = norm(Vec<dim, double>(F / constants(body).mass + gravity));
    double const w = norm(states.load(angular_velocity, body));
    double const speed = norm(states.load(rigid_velocity, body)) + w * constants(body).radius;
    join(longest, angle / w);
    join(longest, 2 * way / (speed + Kokkos::sqrt(speed * speed + 2 * a * way)));
  }
  SCREE_FN void init(double& longest) const { longest = TimeStepLimit::never; }
  SCREE_FN void join(double& longest, double const& other) const {
    if (other < longest || other != other) longest = other;
  }
};

}  // namespace scree::detail
