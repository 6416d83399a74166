// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "motion.hpp"

namespace scree {

/// One update of the rigid bodies, as integrators request it: momenta change over `kick` (s) by the present forces,
/// then positions and attitudes over `drift` (s).
struct RigidStep {
  enum class From { present, start };                    // of the step
  enum class Drift { momentum_before, momentum_after };  // the kick
  double kick = 0, drift = 0;
  From from = From::present;
  Drift with = Drift::momentum_after;
  bool begins = false;  ///< keeps the present state as that at the start of the step
};

namespace detail {

template <class P>
struct RigidUpdate {
  static constexpr int dim = P::dim;
  using X = Vec<dim, double>;
  using reads = Merge<Fields<Identity, AngularVelocity>, RigidForces, RigidEvolved, RigidPrevious, RigidSeen>;
  using writes = Merge<Fields<Position, AngularVelocity>, RigidEvolved, RigidPrevious, RigidSeen>;
  RigidStep step;
  X gravity;
  Span<RigidConstants<dim> const> constants;

  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    RigidConstants<dim> const& body = constants(i[identity]);
    bool const restarts = step.from == RigidStep::From::start;
    keep(i, out);
    X u = restarts ? i[Previous<RigidVelocity>{}] : i[rigid_velocity];
    Turn<dim> L = restarts ? i[Previous<AngularMomentum>{}] : i[angular_momentum];
    X const a = given_or(body, X(force(i) / body.mass + gravity), zero<X>());
    u = given_or(body, X(u + step.kick * a), body.velocity);
    L = L + step.kick * moment(i);
    bool const after = step.with == RigidStep::Drift::momentum_after;
    X const x =
        (restarts ? i[Previous<RigidCentre>{}] : i[rigid_centre]) + step.drift * (after ? u : i[rigid_velocity]);
    Attitude<dim> const q = body.turned_over(restarts ? i[Previous<RigidAttitude>{}] : i[rigid_attitude],
                                             after ? L : Turn<dim>(i[angular_momentum]), step.drift);
    out[rigid_centre] = x;
    out[position] = x.template cast<typename P::real>();
    out[rigid_velocity] = u;
    out[rigid_attitude] = q;
    out[angular_momentum] = L;
    out[angular_velocity] = body.turning_of(q, L);
    see(body, i, a, out);
  }

 private:
  static constexpr double share = 0.125;
  template <class I>
  SCREE_FN static X force(I const& i) {
    using namespace fields;
    return i[rigid_force] + i[rigid_contact_force] + i[rigid_spring_force];
  }
  template <class I>
  SCREE_FN static Turn<dim> moment(I const& i) {
    using namespace fields;
    return i[rigid_moment] + i[rigid_contact_moment] + i[rigid_spring_moment];
  }
  SCREE_FN static X given_or(RigidConstants<dim> const& body, X free, X const& given) {
    for (int axis = 0; axis < dim; ++axis)
      if (body.gives_velocity[axis]) free[axis] = given[axis];
    return free;
  }
  template <class I, class O>
  SCREE_FN void keep(I const& i, O& out) const {
    using namespace fields;
    out[Previous<RigidCentre>{}] = step.begins ? i[rigid_centre] : i[Previous<RigidCentre>{}];
    out[Previous<RigidVelocity>{}] = step.begins ? i[rigid_velocity] : i[Previous<RigidVelocity>{}];
    out[Previous<RigidAttitude>{}] = step.begins ? i[rigid_attitude] : i[Previous<RigidAttitude>{}];
    out[Previous<AngularMomentum>{}] = step.begins ? i[angular_momentum] : i[Previous<AngularMomentum>{}];
  }
  /// The wall stress depends on the acceleration, and the acceleration of a light body on the wall stress. The full
  /// present value would make both oscillate.
  template <class I, class O>
  SCREE_FN void see(RigidConstants<dim> const& body, I const& i, X const& a, O& out) const {
    using namespace fields;
    double const part = step.kick > 0 ? share : 0;
    Turn<dim> const w = i[angular_velocity];
    Inertia<dim> const J = in_space(body.inertia, Attitude<dim>(i[rigid_attitude]));
    Turn<dim> M = moment(i);
    if constexpr (dim == 3) M -= cross(w, Turn<3>(J * w));
    Turn<dim> const turning = body.turning_of(i[rigid_attitude], M, zero<Turn<dim>>());
    out[seen_acceleration] = i[seen_acceleration] + part * X(a - i[seen_acceleration]);
    out[seen_turning] = i[seen_turning] + part * Turn<dim>(turning - i[seen_turning]);
  }
};

}  // namespace detail
}  // namespace scree
