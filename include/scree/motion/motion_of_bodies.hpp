// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/bodies.hpp"
#include "motion.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <type_traits>

namespace scree {

/// A body and its motion.
template <BodyTag Body, class Motion>
struct MovedBy {
  using body = Body;
  using type = Motion;
  Motion motion = {};
};

/// A motion for each of several bodies, for the `motion` of a formulation with several moving walls:
///   using motion = MotionOfBodies<MovedBy<Vessel, Rotation>, MovedBy<Blade, Oscillation<2>>>;
/// The constructor takes the motions in this order. A body that is not listed is at rest.
template <class... Parts>
struct MotionOfBodies {
  std::tuple<typename Parts::type...> motions;

  MotionOfBodies() = default;
  /// Takes the motions in the order of the parts.
  explicit MotionOfBodies(typename Parts::type const&... each) requires(sizeof...(Parts) > 0) : motions(each...) {}

  /// Returns the motion of a body, or AtRest for a body that is not listed.
  template <BodyTag Body>
  auto of_body() const {
    constexpr std::size_t found = (std::size_t(std::is_same_v<Body, typename Parts::body>) + ... + 0);
    static_assert(found < 2, "a body is listed twice in MotionOfBodies");
    if constexpr (found == 1)
      return std::get<detail::index_among<Body>(Bodies<typename Parts::body...>{})>(motions);
    else
      return AtRest{};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    std::apply([](auto const&... each) { (check_settings_of(each), ...); }, motions);
  }
  /// Returns the largest time step that resolves all motions, s.
  double time_step() const {
    return std::apply(
        [](auto const&... each) {
          return std::min({std::numeric_limits<double>::infinity(), each.time_step()...});
        },
        motions);
  }
};

/// Returns the motion of a body, which is `motion` unless the motion differs between bodies.
template <BodyTag Body, class Motion>
auto motion_of_body(Motion const& motion) {
  if constexpr (requires { motion.template of_body<Body>(); })
    return motion.template of_body<Body>();
  else
    return motion;
}

}  // namespace scree
