// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "turning.hpp"

#include <cmath>
#include <optional>

namespace scree {

/// A spring and a dashpot between a point of a rigid body and either a fixed point or a point of another rigid body. In
/// 2D all values are per metre of depth.
template <int Dim>
struct Spring {
  int body = 0;                                        ///< number of the rigid body
  Vec<Dim, double> point = Vec<Dim, double>::Zero();   ///< attachment point on the body at time zero, m
  std::optional<int> other = {};                       ///< number of another rigid body; empty: fixed in space
  Vec<Dim, double> anchor = Vec<Dim, double>::Zero();  ///< attachment point at the other end at time zero, m
  double stiffness = 0;                                ///< N/m
  double damping = 0;                 ///< along the line between the points; in all directions if `length` is 0; N s/m
  std::optional<double> length = {};  ///< length without load, m; if empty, the distance at time zero
  double torsion = 0;                 ///< against relative rotation since time zero, below pi, N m/rad
  double torsion_damping = 0;         ///< N m s/rad

  static constexpr auto parameters() {
    return std::array{
        parameter("stiffness", &Spring::stiffness, "N/m", "force over elongation", allowed::at_least(0)),
        parameter("damping", &Spring::damping, "N s/m", "force over speed of elongation", allowed::at_least(0)),
        parameter("torsion", &Spring::torsion, "N m/rad", "moment over angle", allowed::at_least(0)),
        parameter("torsion_damping", &Spring::torsion_damping, "N m s/rad", "moment over angular velocity",
                  allowed::at_least(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range or a body does not exist.
  void check(int bodies) const {
    check_parameters(*this, "Spring");
    check_setting(body >= 0 && body < bodies, "body of a Spring", body, "the number of a rigid body, from 0");
    check_setting(!other || (*other >= 0 && *other < bodies && *other != body), "other of a Spring", other.value_or(0),
                  "the number of another rigid body, from 0");
    check_setting(point.allFinite() && anchor.allFinite(), "a point of a Spring (m)", (point + anchor).sum(), "finite");
    check_setting(!length || (*length >= 0 && std::isfinite(*length)), "length (m) of a Spring", length.value_or(0),
                  "0 or more");
  }
};

namespace detail {

/// Returns the rotation vector of an attitude, rad.
SCREE_FN Turn<2> rotation_vector(Attitude<2> const& q) { return q; }
SCREE_FN Turn<3> rotation_vector(Attitude<3> q) {
  if (q[0] < 0) q = -q;
  Turn<3> const v(q[1], q[2], q[3]);
  double const s = norm(v);
  return s > 1e-9 ? Turn<3>(v * (2 * Kokkos::atan2(s, q[0]) / s)) : Turn<3>(2.0 * v);
}
/// Returns the attitude q relative to the attitude p.
SCREE_FN Attitude<2> relative(Attitude<2> const& q, Attitude<2> const& p) { return q - p; }
SCREE_FN Attitude<3> relative(Attitude<3> const& q, Attitude<3> const& p) {
  Vec<3, double> const a(q[1], q[2], q[3]), b(-p[1], -p[2], -p[3]);
  Vec<3, double> v = cross(a, b);
  v += q[0] * b + p[0] * a;
  Attitude<3> r;
  r[0] = q[0] * p[0] - dot(a, b), r[1] = v[0], r[2] = v[1], r[3] = v[2];
  return r;
}

}  // namespace detail
}  // namespace scree
