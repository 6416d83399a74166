// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/rate.hpp"
#include "../fields/standard.hpp"
#include "../pairs/term.hpp"
#include "../passes/sums.hpp"
#include "../terms/gravity.hpp"

#include <string>

namespace scree {

/// The speed V at which small grains percolate along gravity where F = 1, m/s.
struct SegregationVelocity : Scalar<"segregation velocity", "m/s"> {};
/// The diffusivity D, m^2/s.
struct Diffusivity : Scalar<"diffusivity", "m^2/s"> {};

namespace fields {
inline constexpr SegregationVelocity segregation_velocity{};
inline constexpr Diffusivity diffusivity{};
}  // namespace fields

/// A function of one particle that writes V and D. It may read the stress of the mechanics. Optional members:
///   warning()        a text that a solver shows to its user before the first step; empty: none
///   under(gravity)   a copy of the closure for this gravity, needed if V or D depends on its magnitude
///   holds_at(i)      whether the closure was fitted to the state of a particle, which it reads from its `reads`
///   warning_beyond(share, way)   a text if `share`, the part of the segregation that takes place where holds_at(i) is
///                                false, is too large; `way` is the distance (m) that grains have moved at the present
///                                rate; empty: not too large
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

/// Returns the warning of a closure; empty if it has none.
template <class Closure>
std::string warning_of_closure(Closure const& closure) {
  if constexpr (requires { closure.warning(); })
    return closure.warning();
  else
    return "";
}
/// Returns the closure for a gravity: closure.under(gravity), or the closure itself if it has no such member.
template <class Closure>
Closure closure_under(Closure const& closure, Gravity const& gravity) {
  if constexpr (requires { closure.under(gravity); })
    return closure.under(gravity);
  else
    return closure;
}
namespace detail {
/// Fails to compile, with a message, if a closure reads the stress and no model evolves it.
template <class Closure, class Evolves = Fields<>>
constexpr bool explain_stress_of_closure() {
  constexpr bool known = !OneOf<Stress, reads_of<Closure>> || OneOf<Stress, evolved_fields<Evolves>>;
  static_assert(known,
                "the closure reads the stress, and nothing gives it here: combine the segregation with a mechanics "
                "that evolves the stress, such as Granular; a physics model of your own may call transport() after a "
                "pass that writes the stress");
  return true;  // a false result would cause a second error, in the caller
}

template <class Closure>
concept KnowsItsFit = requires(Closure const& closure) {
  { closure.warning_beyond(1.0, 1.0) } -> std::convertible_to<std::string>;
};
/// Three terms of a particle: its volume times C (1 - C); this product times |V|; and the latter product again if the
/// closure was not fitted to the state of the particle, otherwise 0.
template <class Closure>
struct SegregationBeyondFit {
  static constexpr int count = 3;
  using reads = Merge<Fields<Volume, Concentration, SegregationVelocity>, reads_of<Closure>>;
  Closure closure;
  template <class I>
  SCREE_FN Vec<3, double> operator()(I const& i) const {
    using namespace fields;
    double const C = Kokkos::clamp(double(i[concentration]), 0.0, 1.0), mixed = double(i[volume]) * C * (1 - C);
    double const flux = mixed * Kokkos::abs(double(i[segregation_velocity]));
    return {mixed, flux, closure.holds_at(i) ? 0 : flux};
  }
};
}  // namespace detail

/// The part of the segregation in a body that takes place beyond the fit of a closure, and the mean speed of
/// segregation.
struct BeyondFit {
  double share = 0;  ///< part of the segregation |V| C (1 - C), by volume, where the closure was not fitted, 0 to 1
  double speed = 0;  ///< mean |V|, weighted by C (1 - C), m/s
};
/// Returns how much of the segregation in a body (WholeBody) takes place where a closure was not fitted; zeros if there
/// is no mixture. Runs on the device.
template <detail::KnowsItsFit Closure, class Whole>
BeyondFit beyond_fit(Closure const& closure, Whole const& body) {
  auto const sums = sums_over(body, detail::SegregationBeyondFit<Closure>{closure}, "the segregation beyond a fit");
  return {sums[1] > 0 ? sums[2] / sums[1] : 0, sums[0] > 0 ? sums[1] / sums[0] : 0};
}
/// Returns the warning of a closure about the present state of a body (WholeBody); empty if there is none.
template <detail::KnowsItsFit Closure, class Whole>
[[gnu::cold]] std::string warning_beyond_fit(Closure const& closure, Whole const& body) {
  auto const found = beyond_fit(closure, body);
  return closure.warning_beyond(found.share, found.speed * body.time());
}

/// Returns a warning if the size ratio of grains exceeds `largest`, the largest ratio to which a closure was fitted;
/// otherwise an empty text.
[[gnu::cold]] inline std::string warning_of_size_ratio(char const* closure, double ratio, double largest) {
  if (!(ratio > largest)) return "";
  return detail::formatted(
      "scree: warning: %s was fitted to grains whose sizes differ by at most a factor of %g; here it is %g, and the "
      "speed of segregation is an extrapolation (docs/theory/segregation.md, closures)",
      closure, largest, ratio);
}

}  // namespace scree
