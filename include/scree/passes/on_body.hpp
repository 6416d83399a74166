// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "fuse.hpp"

#include <type_traits>

// Passes bound to one of several evolving bodies, see formulation/physics_of_bodies.hpp.
namespace scree {

/// The terms for pairs of a particle in one body and a neighbour in another body.
template <BodyTag Other, class... Terms>
struct InterfaceTerms {
  detail::Tuple<Terms...> terms;
};
/// Returns the interface of a body with another body, from a tuple of terms.
template <BodyTag Other, detail::AnyTuple Terms>
auto interface_with(Terms const& terms) {
  return detail::with_values(
      [](auto const&... each) { return InterfaceTerms<Other, std::remove_cvref_t<decltype(each)>...>{{each...}}; },
      terms);
}

namespace detail {

/// Reports an incomplete interface at compile time, with the same message for all bodies.
template <bool Complete, bool Whole>
constexpr void explain_interface_terms() {
  static_assert(Complete,
                "a pass sums over neighbours in the own body, and `interface_terms(other, resolution)` of the physics "
                "model has no term that adds to the same field over those in another body");
  static_assert(Whole, "a term of `interface_terms(other, resolution)` adds to fields that a pass sums only in part");
}

template <class Named, class Body>
using bound_to = std::conditional_t<std::is_same_v<Named, Material>, Body, Named>;

/// Whether a pass runs only over the particles of the role `Material`, so it can be bound to a body.
template <class Pass>
inline constexpr bool is_over_material = false;
template <class Function>
inline constexpr bool is_over_material<PointPass<Material, Function>> = true;
template <class... Ts>
inline constexpr bool is_over_material<PairPass<Material, Ts...>> = true;
template <class Pass>
inline constexpr bool is_over_material<OnlyIf<Pass>> = is_over_material<Pass>;
template <class... Passes>
inline constexpr bool is_over_material<Tuple<Passes...>> = (is_over_material<Passes> && ...);

/// The binding of passes to a body, which replaces `Material` as the target and as a source. Sums over `Material` also
/// include each body with an interface, by means of the interface terms that add to the same fields.
template <class Body, class... Interfaces>
class OnBody {
 public:
  explicit OnBody(Interfaces const&... interfaces) : interfaces_(interfaces...) {}

  template <class Passes>
  auto all(Passes const& passes) const {
    return with_values([&](auto const&... each) { return Tuple(bound(each)...); }, passes);
  }

 private:
  template <class Function>
  auto bound(PointPass<Material, Function> const& pass) const {
    return point_pass<Body>(pass.label, pass.function);
  }
  template <class Where, class Then, class... Overs>
  auto bound(PairPass<Material, Where, Then, Overs...> const& pass) const {
    using Summed =
        Merge<std::conditional_t<std::is_same_v<typename Overs::body, Material>, typename Overs::adds, Fields<>>...>;
    return with_values(
        [&](Interfaces const&... each) { return with_overs(pass, in_a_row(own(pass.overs), across<Summed>(each)...)); },
        interfaces_);
  }
  template <class Pass>
  auto bound(OnlyIf<Pass> const& pass) const {
    auto const inner = bound(pass.pass);
    return OnlyIf<std::remove_const_t<decltype(inner)>>{pass.active, inner};
  }

  template <class Where, class Then, class... Before, class... Overs>
  static PairPass<Body, Where, Then, Overs...> with_overs(PairPass<Material, Where, Then, Before...> const& pass,
                                                          Tuple<Overs...> const& overs) {
    return {pass.label, pass.where, pass.then, overs};
  }
  template <class... Overs>
  static auto own(Tuple<Overs...> const& overs) {
    return with_values(
        [](Overs const&... each) {
          return Tuple(over_tuple<bound_to<typename Overs::body, Body>>(each.lens, each.terms)...);
        },
        overs);
  }
  template <class Summed, class Other, class... Terms>
  static auto across(InterfaceTerms<Other, Terms...> const& with) {
    using Added = Merge<Fields<>, std::conditional_t<intersects<Summed, adds_of<Terms>>, adds_of<Terms>, Fields<>>...>;
    explain_interface_terms<std::is_same_v<Without<Summed, Added>, Fields<>>,
                            std::is_same_v<Without<Added, Summed>, Fields<>>>();
    if constexpr (std::is_same_v<Summed, Fields<>>)
      return Tuple<>();
    else
      return Tuple(over_tuple<Other>(
          AsIs{},
          with_values([](Terms const&... each) { return in_a_row(if_it_adds_to<Summed>(each)...); }, with.terms)));
  }
  template <class Summed, class Term>
  static auto if_it_adds_to(Term const& term) {
    if constexpr (intersects<Summed, adds_of<Term>>)
      return Tuple<Term>(term);
    else
      return Tuple<>();
  }

  Tuple<Interfaces...> interfaces_;
};

}  // namespace detail

/// Returns passes over the role `Material`, bound to one of several evolving bodies. The body takes the role, and sums
/// over its particles also include the bodies of the interfaces.
template <BodyTag Body, detail::AnyTuple Passes, class... Interfaces>
auto on_body(Passes const& passes, Interfaces const&... interfaces) {
  return detail::OnBody<Body, Interfaces...>(interfaces...).all(passes);
}

}  // namespace scree
