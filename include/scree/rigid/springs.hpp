// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/loop.hpp"
#include "../core/principal.hpp"
#include "../passes/time_step.hpp"
#include "settings.hpp"
#include "state.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

// The springs and dashpots of the rigid bodies of a solver.
namespace scree::detail {

/// A spring on the device. Its attachment points are relative to the centres at time zero; if `other` is negative,
/// `anchor` is a point fixed in space.
template <int Dim>
struct SpringConstants {
  int body, other;
  Vec<Dim, double> point, anchor;
  double stiffness, damping, length, torsion, torsion_damping;
};

/// Computes the spring forces and moments on each body, summed in the order of the springs.
template <class P>
struct SpringForces {
  static constexpr int dim = P::dim;
  using X = Vec<dim, double>;
  Columns<P, Fields<RigidCentre, RigidVelocity, RigidAttitude, AngularVelocity, RigidSpringForce, RigidSpringMoment>>
      states;
  Span<SpringConstants<dim> const> springs;

  SCREE_FN void operator()(int body) const {
    using namespace fields;
    X force = zero<X>();
    Turn<dim> moment = zero<Turn<dim>>();
    for (int k = 0; k < springs.size(); ++k) {
      auto const& spring = springs(k);
      if (spring.body != body && spring.other != body) continue;
      End const near = end(spring.body, spring.point), far = end(spring.other, spring.anchor);
      X const F = pull(spring, near, far);
      Turn<dim> const M = twist(spring, near, far);
      if (spring.body == body)
        force += F, moment += moment_of(near.arm, F) + M;
      else
        force -= F, moment -= moment_of(far.arm, F) + M;
    }
    states[rigid_spring_force](body) = force;
    states[rigid_spring_moment](body) = moment;
  }

 private:
  struct End {
    X x, u, arm;
    Turn<dim> w;
    Attitude<dim> q;
  };
  SCREE_FN End end(int body, X const& point) const {
    using namespace fields;
    if (body < 0) return {point, zero<X>(), zero<X>(), zero<Turn<dim>>(), upright<dim>()};
    Turn<dim> const w = states.load(angular_velocity, body);
    Attitude<dim> const q = states.load(rigid_attitude, body);
    X const arm = matrix_of(q) * point;
    return {X(states.load(rigid_centre, body) + arm), X(states.load(rigid_velocity, body) + cross(w, arm)), arm, w, q};
  }
  /// Returns the force, N, of a spring on the body at its near end.
  SCREE_FN static X pull(SpringConstants<dim> const& spring, End const& near, End const& far) {
    X const r = near.x - far.x, u = near.u - far.u;
    double const distance = norm(r);
    if (spring.length == 0 || !(distance > 0)) return X(-(spring.stiffness * r + spring.damping * u));
    X const along = r / distance;
    return X(-(spring.stiffness * (distance - spring.length) + spring.damping * dot(u, along)) * along);
  }
  /// Returns the torsional moment, N m, of a spring on the body at its near end.
  SCREE_FN static Turn<dim> twist(SpringConstants<dim> const& spring, End const& near, End const& far) {
    if (spring.torsion == 0 && spring.torsion_damping == 0) return zero<Turn<dim>>();
    Turn<dim> const angle = rotation_vector(relative(near.q, far.q));
    return Turn<dim>(-(spring.torsion * angle + spring.torsion_damping * (near.w - far.w)));
  }
};

template <class P>
class RigidSprings {
 public:
  static constexpr int dim = P::dim;

  void prepare(typename P::space const& space, RigidBodies<dim> const& rigid) {
    std::vector<SpringConstants<dim>> springs;
    std::vector<double> squares(rigid.bodies.size(), 0), rates(rigid.bodies.size(), 0);
    for (auto const& each : rigid.springs) {
      auto const centre = [&](int body) { return rigid.bodies[std::size_t(body)].properties.centre; };
      Vec<dim, double> const point = each.point - centre(each.body);
      Vec<dim, double> anchor = each.anchor;
      if (each.other) anchor -= centre(*each.other);
      springs.push_back({each.body, each.other.value_or(-1), point, anchor, each.stiffness, each.damping,
                         each.length.value_or((each.point - each.anchor).norm()), each.torsion, each.torsion_damping});
      auto const add = [&](int body, Vec<dim, double> const& arm) {
        auto const& properties = rigid.bodies[std::size_t(body)].properties;
        double least = properties.inertia(0, 0);
        if constexpr (dim == 3) least = principal(properties.inertia).values.minCoeff();
        double const shift = 1 / properties.mass + squared_norm(arm) / least, twice = each.other ? 2 : 1;
        squares[std::size_t(body)] += twice * (each.stiffness * shift + each.torsion / least);
        rates[std::size_t(body)] += twice * (each.damping * shift + each.torsion_damping / least);
      };
      add(each.body, point);
      if (each.other) add(*each.other, anchor);
    }
    springs_ = array_of<P>(space, springs);
    for (std::size_t k = 0; k < squares.size(); ++k)
      longest_ = std::min({longest_, 0.1 / std::sqrt(squares[k]), 0.5 / rates[k]});
  }
  template <class States>
  void update(States const& states) const {
    if (springs_.size() > 0)
      for_each_index(states.space(), "scree::springs", 0, states.size(),
                     SpringForces<P>{states.select(Fields<RigidCentre, RigidVelocity, RigidAttitude, AngularVelocity,
                                                          RigidSpringForce, RigidSpringMoment>{}),
                                     springs_});
  }
  /// Returns the limit on the time step, s, up to which all springs are resolved.
  TimeStepLimit limit() const { return {"springs", longest_, TimeStepLimit::never}; }

 private:
  Array<P, SpringConstants<dim>> springs_;
  double longest_ = TimeStepLimit::never;  // s
};

}  // namespace scree::detail
