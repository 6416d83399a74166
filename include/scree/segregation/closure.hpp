// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

#include <string>

namespace scree {

/// V: speed at which small grains percolate along gravity where F = 1, m/s.
struct SegregationVelocity : Scalar<"segregation velocity", "m/s"> {};
/// D, m^2/s.
struct Diffusivity : Scalar<"diffusivity", "m^2/s"> {};

namespace fields {
inline constexpr SegregationVelocity segregation_velocity{};
inline constexpr Diffusivity diffusivity{};
}  // namespace fields

/// A function of one particle that writes V and D. If it has a function warning() const that returns a text which is
/// not empty, a solver gives this to its user before the first step.
template <class C, class P>
concept SegregationClosure =
    PointFunction<C, P> && OneOf<SegregationVelocity, writes_of<C>> && OneOf<Diffusivity, writes_of<C>>;

namespace detail {
template <class C>
constexpr bool explain_closure() {
  static_assert(SegregationClosure<C, AnyPoint>,
                "this is not a SegregationClosure: it needs lists `reads` and `writes`, the latter with "
                "SegregationVelocity and Diffusivity, and operator()(i, out) const");
  return SegregationClosure<C, AnyPoint>;
}
}  // namespace detail

/// The warning of a closure; empty if it has none.
template <class Closure>
std::string warning_of_closure(Closure const& closure) {
  if constexpr (requires { closure.warning(); })
    return closure.warning();
  else
    return "";
}
/// The warning of a closure that was fitted to ratios of the sizes of grains up to `largest`; empty for these.
[[gnu::cold]] inline std::string warning_of_size_ratio(char const* closure, double ratio, double largest) {
  if (!(ratio > largest)) return "";
  return detail::formatted(
      "scree: warning: %s was fitted to grains whose sizes differ by at most a factor of %g; here it is %g, and the "
      "speed of segregation is an extrapolation (docs/theory/segregation.md, closures)",
      closure, largest, ratio);
}

}  // namespace scree
