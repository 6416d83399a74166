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

/// V: speed at which small grains percolate along gravity where F = 1, m/s.
struct SegregationVelocity : Scalar<"segregation velocity", "m/s"> {};
/// D, m^2/s.
struct Diffusivity : Scalar<"diffusivity", "m^2/s"> {};

namespace fields {
inline constexpr SegregationVelocity segregation_velocity{};
inline constexpr Diffusivity diffusivity{};
}  // namespace fields

/// A function of one particle that writes V and D. It may read the stress of a mechanics. Members that it may have:
///   warning()        a text that a solver gives to its user before the first step; empty: none
///   under(gravity)   the closure for a gravity, if it depends on the magnitude of that
///   holds_at(i)      whether the closure was fitted to the state of a particle, from its `reads`
///   warning_beyond(share, way)   a text if the share of the segregation that takes place where holds_at(i) is false is
///                                too large; at this rate grains have moved so far (m); empty: not too large
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
/// The closure for a gravity.
template <class Closure>
Closure closure_under(Closure const& closure, Gravity const& gravity) {
  if constexpr (requires { closure.under(gravity); })
    return closure.under(gravity);
  else
    return closure;
}
namespace detail {
/// A message if a closure reads the stress and none evolves.
template <class Closure, class Evolves = Fields<>>
constexpr bool explain_stress_of_closure() {
  constexpr bool known = !OneOf<Stress, reads_of<Closure>> || OneOf<Stress, evolved_fields<Evolves>>;
  static_assert(known,
                "the closure reads the stress, and nothing gives it here: combine the segregation with a mechanics "
                "that evolves the stress, such as Granular; a physics model of your own may call transport() after a "
                "pass that writes the stress");
  return true;  // an error of the caller would say the same again
}

template <class Closure>
concept KnowsItsFit = requires(Closure const& closure) {
  { closure.warning_beyond(1.0, 1.0) } -> std::convertible_to<std::string>;
};
/// C (1 - C) of a particle, this times |V|, and the latter once more where the closure was not fitted, each times the
/// volume.
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

/// The segregation in a body, see beyond_fit().
struct BeyondFit {
  double share = 0;  ///< of the segregation |V| C (1 - C) that takes place where the closure was not fitted, 0 to 1
  double speed = 0;  ///< mean |V| with the weight C (1 - C), m/s
};
/// How much of the segregation in a body (WholeBody) takes place where a closure was not fitted; zeros without a
/// mixture. It runs on the device.
template <detail::KnowsItsFit Closure, class Whole>
BeyondFit beyond_fit(Closure const& closure, Whole const& body) {
  auto const sums = sums_over(body, detail::SegregationBeyondFit<Closure>{closure}, "the segregation beyond a fit");
  return {sums[1] > 0 ? sums[2] / sums[1] : 0, sums[0] > 0 ? sums[1] / sums[0] : 0};
}
/// The warning of a closure about the state that a body (WholeBody) has come to; empty if there is none.
template <detail::KnowsItsFit Closure, class Whole>
[[gnu::cold]] std::string warning_beyond_fit(Closure const& closure, Whole const& body) {
  auto const found = beyond_fit(closure, body);
  return closure.warning_beyond(found.share, found.speed * body.time());
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
