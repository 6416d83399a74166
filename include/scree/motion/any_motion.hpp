// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "motion.hpp"

#include <type_traits>

namespace scree {
namespace detail {

/// One motion of each of several types. `kind` is the index of a motion in the list; the index after the last means
/// rest.
template <class... Motions>
struct MotionList {
  int put(AtRest const&) { return 0; }
  template <class X>
  SCREE_FN X displaced(int, X const& x, double, double) const {
    return x;
  }
  template <class X>
  SCREE_FN X velocity(int, X const&, double) const {
    return zero<X>();
  }
  template <class X>
  SCREE_FN X acceleration(int, X const&, double) const {
    return zero<X>();
  }
  template <class X>
  SCREE_FN auto velocity_gradient(int, X const&, double) const {
    return zero<Mat<X::RowsAtCompileTime, typename X::Scalar>>();
  }
  double time_step(int) const { return AtRest{}.time_step(); }
  void check(int) const {}
  template <int Dim, class Real>
  bool gives_gradient(int) const {
    return true;
  }
};
template <class First, class... Others>
struct MotionList<First, Others...> {
  First first = {};
  MotionList<Others...> others = {};

  template <class Motion>
  int put(Motion const& motion) {
    if constexpr (std::is_same_v<Motion, First>)
      return first = motion, 0;
    else
      return 1 + others.put(motion);
  }
  template <class X>
  SCREE_FN X displaced(int kind, X const& x, double from, double to) const {
    return kind == 0 ? X(first.displaced(x, from, to)) : others.displaced(kind - 1, x, from, to);
  }
  template <class X>
  SCREE_FN X velocity(int kind, X const& x, double time) const {
    return kind == 0 ? X(first.velocity(x, time)) : others.velocity(kind - 1, x, time);
  }
  template <class X>
  SCREE_FN X acceleration(int kind, X const& x, double time) const {
    return kind == 0 ? X(first.acceleration(x, time)) : others.acceleration(kind - 1, x, time);
  }
  template <class X>
  SCREE_FN auto velocity_gradient(int kind, X const& x, double time) const {
    return kind == 0 ? velocity_gradient_at(first, x, time) : others.velocity_gradient(kind - 1, x, time);
  }
  void check(int kind) const {
    if (kind == 0)
      check_settings_of(first);
    else
      others.check(kind - 1);
  }
  double time_step(int kind) const { return kind == 0 ? double(first.time_step()) : others.time_step(kind - 1); }
  template <int Dim, class Real>
  bool gives_gradient(int kind) const {
    return kind == 0 ? GivesVelocityGradient<First, Dim, Real> : others.template gives_gradient<Dim, Real>(kind - 1);
  }
};

template <class Motion, class... Motions>
inline constexpr bool is_among = (std::is_same_v<Motion, AtRest> || ... || std::is_same_v<Motion, Motions>);

}  // namespace detail

/// A motion of one of several types, chosen at run time; at rest until a motion is chosen:
///
///     AnyMotion<Rotation, Tabulated<2>> motion = Rotation{.rate = 2};
///
/// Only the listed types are compiled. The object stores one motion of each type, so it needs no device memory.
template <class... Motions>
class AnyMotion {
 public:
  AnyMotion() = default;
  /// Takes a motion of one of the listed types, or AtRest.
  template <class Motion>
  AnyMotion(Motion const& motion) {
    static_assert(detail::is_among<Motion, Motions...>,
                  "this motion is not among those that AnyMotion or MotionOfGroups names: add its type to the list");
    if constexpr (detail::is_among<Motion, Motions...>) kind_ = list_.put(motion);
  }

  /// Throws std::invalid_argument if a parameter of the chosen motion is out of range.
  void check() const { list_.check(kind_); }
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    return list_.displaced(kind_, x, from, to);
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double time) const {
    return list_.velocity(kind_, x, time);
  }
  template <class X>
  SCREE_FN X acceleration(X const& x, double time) const {
    return list_.acceleration(kind_, x, time);
  }
  template <class X>
  SCREE_FN auto velocity_gradient(X const& x, double time) const {
    return list_.velocity_gradient(kind_, x, time);
  }
  /// Returns the largest time step that resolves the chosen motion, s.
  double time_step() const { return list_.time_step(kind_); }
  /// Whether the chosen motion has its own function for the velocity gradient.
  template <int Dim, class Real>
  bool gives_gradient() const {
    return list_.template gives_gradient<Dim, Real>(kind_);
  }

 private:
  detail::MotionList<Motions...> list_ = {};
  int kind_ = sizeof...(Motions);
};

}  // namespace scree
