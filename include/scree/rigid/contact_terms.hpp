// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/span.hpp"
#include "../pairs/term.hpp"
#include "contact_fields.hpp"

// Contact as sums over pairs of surface particles. Both particles of a pair compute the same values, so that their
// forces are exactly equal and opposite.
namespace scree::detail {

/// The normal force of contacts: sums over the neighbours of f n, of f (ContactPressing) and of $f u_{ij}$
/// (ContactDragging).
struct ContactNormalForce : Vector<"contact normal force", "N"> {};
struct ContactPressing : Scalar<"contact pressing", "N"> {};
struct ContactDragging : Vector<"contact dragging", "W"> {};

/// The normal force of a pair, $k w d (1 + e^2 - (1 - e^2) \tanh(v/v_0))/2$, with the stiffness k, the overlap d, the
/// restitution e, the speed of separation v and the share w of the pair in the face of a particle.
struct ContactLaw {
  double spacing = 0;          ///< m
  double stiffness = 0;        ///< N/m
  double mean = 0, swing = 0;  ///< (1 + e^2)/2, (1 - e^2)/2
  double damped_below = 1;     ///< m/s

  template <class X>
  struct Touch {
    X normal, velocity;  // normal towards i; relative velocity of i and j at their midpoint, m/s
    typename X::Scalar overlap = 0, nearness = 0, force = 0;  // m, -, N
  };
  using reads = Fields<ContactOwner, Facing, Velocity, VelocityGradient>;

  template <class I, class J, class IJ>
  SCREE_FN Touch<typename IJ::vector> operator()(I const& i, J const& j, IJ const& ij) const {
    using namespace fields;
    using X = typename IJ::vector;
    using Real = typename IJ::real;
    Touch<X> touch{zero<X>(), zero<X>()};
    int const a = i[contact_owner], b = j[contact_owner];
    Real const dr = Real(spacing);
    if (ij.r > Real(reach) * dr || a == b || a < of_wall || b < of_wall || !(ij.r > 0)) return touch;
    Real const fi = norm(i[facing]), fj = norm(j[facing]);
    // Both surfaces face the same way: the back of a thin wall, or adjacent sides.
    if (dot(i[facing], j[facing]) > Real(alike) * fi * fj) return touch;
    // The flatter surface determines the normal; edges and corners touch each other like spheres.
    X const toward = math::power<by_flatness>(fj) * j[facing] - math::power<by_flatness>(fi) * i[facing];
    Real const length = norm(toward), flat = length > 0 ? flatness(Kokkos::max(fi, fj)) : Real(0);
    X n = ((1 - flat) / ij.r) * ij.x;
    if (flat > 0) n += (flat / length) * toward;
    n = n / norm(n);
    Real const away = dot(ij.x, n), gap = flat * away + (1 - flat) * ij.r;
    if (away < -dr) return touch;
    Real const beside = Kokkos::sqrt(Kokkos::max(Real(0), sq(ij.r) - sq(away)));
    Real const share = Kokkos::max(Real(0), 1 - beside / dr) / Real(X::RowsAtCompileTime == 2 ? 1 : pi_third);
    touch.normal = n;
    if (gap < Real(near_below) * dr) touch.nearness = share;
    touch.overlap = share * Kokkos::max(Real(0), dr - gap);
    X const half = ij.x / Real(2);
    touch.velocity = (i[velocity] - i[velocity_gradient] * half) - (j[velocity] + j[velocity_gradient] * half);
    Real const apart = dot(touch.velocity, n);
    touch.force =
        Real(stiffness) * touch.overlap * (Real(mean) - Real(swing) * Kokkos::tanh(apart / Real(damped_below)));
    return touch;
  }

  /// Returns the weight of flat contact, which rises from 0 at edges to 1 on flat surfaces.
  template <class Real>
  SCREE_FN static Real flatness(Real f) {
    return Kokkos::clamp((f - Real(flat_above)) / Real(rise), Real(0), Real(1));
  }
  static constexpr int of_wall = -1, inside = -2;  ///< owners
  /// The gap between two particles, in spacings, below which their surfaces are near each other.
  static constexpr double near_below = 1.5;
  /// The distance of two particles, in spacings, beyond which their pair contributes nothing. In a contributing pair
  /// the particles are at most `near_below` apart along the normal and at most one spacing across it, and the gap is
  /// not smaller than the distance along the normal. The value has a small margin for rounding.
  static constexpr double reach = 1.81;
  /// Cosine of the angle between normals (84 degrees) above which two surfaces face the same way.
  static constexpr double alike = 0.1;
  /// The range of |facing| over which the weight rises from 0 to 1. On a lattice |facing| is 1 on faces, 0.965 in the
  /// row next to an edge, 0.92 on edges and 0.90 at corners: the row counts as flat and the edge does not.
  static constexpr double flat_above = 0.94, rise = 0.02;
  /// The power of |facing| by which the normals of two surfaces are weighted: a row next to an edge has a tenth of the
  /// weight of a face (0.965^63), an edge 0.005 of that weight.
  static constexpr int by_flatness = 63;
  static constexpr double pi_third = 1.0471975511965977;
};

struct ContactSums {
  ContactLaw law;
  using reads = ContactLaw::reads;
  using adds = Fields<ContactOverlap, ContactNearness, ContactPressing, ContactNormalForce, ContactDragging>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const touch = law(i, j, ij);
    sum[contact_overlap] += touch.overlap;
    sum[contact_nearness] += touch.nearness;
    sum[ContactPressing{}] += touch.force;
    sum[ContactNormalForce{}] += touch.force * touch.normal;
    sum[ContactDragging{}] += touch.force * touch.velocity;
  }
};

/// The friction of a surface particle: a spring in parallel with a dashpot, both in series with a slider.
struct StickOrSlip {
  double friction, stiffness;   ///< -, N/m
  Span<double const> dashpots;  ///< N s/m, of each body
  using reads = Fields<ContactStretch, ContactOwner>;
  using writes = Fields<ContactOverlap, ContactNearness, ContactSlip, HeldStretch, Traction>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    using X = std::remove_cvref_t<decltype(i[contact_stretch])>;
    using Real = typename X::Scalar;
    out[contact_overlap] = total[contact_overlap];
    out[contact_nearness] = total[contact_nearness];
    out[contact_slip] = out[held_stretch] = out[traction] = zero<X>();
    Real const pressing = total[ContactPressing{}], N = norm(total[ContactNormalForce{}]);
    if (!(pressing > 0 && N > 0)) return;
    X const n = total[ContactNormalForce{}] / N;
    Real const most = Real(friction) * pressing, k = Real(stiffness);
    X const slip = along(n, X(total[ContactDragging{}] / pressing));
    X const stretch = at_most<X>(most / k, along(n, i[contact_stretch]));
    out[contact_slip] = slip;
    out[held_stretch] = stretch;
    out[traction] = at_most<X>(most, -(k * stretch + Real(dashpots(i[contact_owner])) * slip)) / pressing;
  }

 private:
  template <class X>
  SCREE_FN static X along(X const& n, X const& v) {
    return v - n * dot(n, v);
  }
  template <class X>
  SCREE_FN static X at_most(typename X::Scalar most, X const& v) {
    auto const length = norm(v);
    return length > most ? X(v * (most / length)) : v;
  }
};

template <class X>
SCREE_FN Vec<turns_in<X::RowsAtCompileTime>, typename X::Scalar> moment_about_particle(X const& r, X const& F) {
  if constexpr (X::RowsAtCompileTime == 2) {
    Vec<1, typename X::Scalar> M;
    M[0] = r[0] * F[1] - r[1] * F[0];
    return M;
  } else {
    return cross(r, F);
  }
}

/// Pair term for the contact force and moment of a pair. The force acts at the midpoint between the particles, so that
/// angular momentum is conserved, too.
struct ContactForces {
  ContactLaw law;
  using reads = Merge<ContactLaw::reads, Fields<Traction>>;
  using adds = Fields<ContactForce, ContactMoment>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using X = typename IJ::vector;
    auto const touch = law(i, j, ij);
    if (!(touch.overlap > 0)) return;
    X const F = touch.force * (touch.normal + friction(i, j));
    sum[contact_force] += F;
    sum[contact_moment] += moment_about_particle(X(typename IJ::real(-0.5) * ij.x), F);
  }

 private:
  template <class I, class J>
  SCREE_FN static auto friction(I const& i, J const& j) {
    using namespace fields;
    using X = std::remove_cvref_t<decltype(i[traction])>;
    if (i[contact_owner] == ContactLaw::of_wall) return X(-j[traction]);
    if (j[contact_owner] == ContactLaw::of_wall) return X(i[traction]);
    return X((i[traction] - j[traction]) / typename X::Scalar(2));
  }
};

/// Conditions on target particles.
struct OnSurface {
  using reads = Fields<ContactOwner>;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[fields::contact_owner] >= 0;
  }
};
struct InContact {
  using reads = Fields<ContactOverlap>;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[fields::contact_overlap] > 0;
  }
};

/// A surface particle with its stretch limited by friction.
template <class I>
struct HeldContact {
  I const& i;
  template <Field F>
  SCREE_FN auto const& operator[](F field) const {
    if constexpr (std::is_same_v<F, ContactStretch>)
      return i[fields::held_stretch];
    else
      return i[field];
  }
};
/// The update of contact stretches by a function of an integrator for StretchEvolves; the rate of the stretch is the
/// slip.
template <class Function>
struct UpdateStretch {
  using reads = Merge<Without<reads_of<Function>, Fields<ContactStretch>>, Fields<HeldStretch>>;
  using writes = writes_of<Function>;
  Function function;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    function(HeldContact<I>{i}, out);
  }
};

}  // namespace scree::detail
