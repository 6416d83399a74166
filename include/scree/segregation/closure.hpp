// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

namespace scree {

/// V: speed at which small grains percolate along gravity where F = 1, m/s.
struct SegregationVelocity : Scalar<"segregation velocity", "m/s"> {};
/// D, m^2/s.
struct Diffusivity : Scalar<"diffusivity", "m^2/s"> {};

namespace fields {
inline constexpr SegregationVelocity segregation_velocity{};
inline constexpr Diffusivity diffusivity{};
}  // namespace fields

/// A function of one particle that writes V and D.
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

}  // namespace scree
