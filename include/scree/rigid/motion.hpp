// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../motion/motion.hpp"
#include "state.hpp"

namespace scree::detail {

/// The motion of the particles of one rigid body at the present time. Rest positions are the positions at time zero.
template <int Dim>
struct RigidMotion {
  Vec<Dim, double> rest_centre, centre, u, a;
  Mat<Dim, double> R, W, A;  ///< attitude; w x and its rate, as matrices

  template <class X>
  SCREE_FN X displaced(X const& rest, double, double) const {
    return X((centre + R * Vec<Dim, double>(as_double(rest) - rest_centre)).template cast<typename X::Scalar>());
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double) const {
    return X((u + W * arm(x)).template cast<typename X::Scalar>());
  }
  template <class X>
  SCREE_FN X acceleration(X const& x, double) const {
    return X((a + A * arm(x) + W * Vec<Dim, double>(W * arm(x))).template cast<typename X::Scalar>());
  }
  template <class X>
  SCREE_FN Mat<Dim, typename X::Scalar> velocity_gradient(X const&, double) const {
    return W.template cast<typename X::Scalar>();
  }
  double time_step() const { return AtRest{}.time_step(); }

 private:
  template <class X>
  SCREE_FN static Vec<Dim, double> as_double(X const& x) {
    return x.template cast<double>();
  }
  template <class X>
  SCREE_FN Vec<Dim, double> arm(X const& x) const {
    return as_double(x) - centre;
  }
};

/// The motions of all rigid bodies, computed on the device from their states.
template <class P>
struct RigidMotions {
  using Reads = Merge<Fields<RigidCentre, RigidVelocity, RigidAttitude, AngularVelocity>, RigidSeen>;
  Columns<P, Reads> states;
  Span<RigidConstants<P::dim> const> constants;

  SCREE_FN RigidMotion<P::dim> of(int number) const {
    using namespace fields;
    auto const w = states.load(angular_velocity, number);
    return {constants(number).rest_centre,
            states.load(rigid_centre, number),
            states.load(rigid_velocity, number),
            states.load(seen_acceleration, number),
            matrix_of(states.load(rigid_attitude, number)),
            cross_matrix(w),
            cross_matrix(states.load(seen_turning, number))};
  }
  int groups() const { return constants.size(); }
  double time_step() const { return AtRest{}.time_step(); }
};

}  // namespace scree::detail
