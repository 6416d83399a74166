// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/species.hpp"
#include "closure.hpp"

#include <type_traits>

namespace scree {

/// The number of pairs of N species.
template <int N>
inline constexpr int pairs_of_species = N*(N - 1) / 2;

/// The speeds S_kl along gravity at which grains of species k move through those of species l, for the pairs k < l in
/// the order 01, 02, ..., 12, .... The flux of species k is $C_k \sum_l S_{kl} C_l$, with S_lk = -S_kl.
template <int N>
struct SegregationVelocities : Labelled<"segregation velocities", "m/s"> {
  template <int Dim, class Real>
  using value = Vec<pairs_of_species<N>, Real>;
};

namespace fields {
template <int N>
inline constexpr SegregationVelocities<N> segregation_velocities{};
}  // namespace fields

/// A function of one particle that writes the speeds S_kl of N species and the diffusivity D, which all species share.
///   species   N, an int
template <class C, class P>
concept SpeciesClosure = PointFunction<C, P> && requires {
  requires C::species >= 2;
  requires OneOf<SegregationVelocities<C::species>, writes_of<C>>;
  requires OneOf<Diffusivity, writes_of<C>>;
};

namespace detail {
template <class C>
constexpr bool explain_species_closure() {
  static_assert(SpeciesClosure<C, AnyPoint>,
                "this is not a SpeciesClosure: it needs the number of its species, `static constexpr int species = N`, "
                "lists `reads` and `writes`, the latter with SegregationVelocities<N> and Diffusivity, and "
                "operator()(i, out) const");
  return SpeciesClosure<C, AnyPoint>;
}
}  // namespace detail

/// A SpeciesClosure whose velocities are sums of a few factors of the particle times constants of the pair of species,
/// $S_{kl} = \sum_m f_m s_{kl,m}$. If there are fewer factors than velocities, which takes three species or more,
/// particles store the factors (SegregationFactors) instead of the velocities, and loops over pairs of particles are
/// faster. In addition to operator(), which gives the same velocities, it has
///   factors                M, an int
///   factors_of             the class itself: a class derived from it, whose operator() may differ, has no factors
///                          unless it names itself
///   factors_at(i)          f_m of a particle, a Vec<M, double>
///   diffusivity_at(i)      D of a particle, m^2/s
///   speeds_of_pair(k, l)   s_kl,m of the species k < l, a Vec<M, double>; f_m s_kl,m is in m/s. It is called on the
///                          host, and also on the device if operator() calls write_velocities()
template <class C>
concept FactoredClosure = requires(C const& closure, Record<detail::AnyPoint, reads_of<C>> const& i) {
  requires C::factors >= 1;
  requires std::is_same_v<typename C::factors_of, C>;
  { closure.factors_at(i) } -> std::convertible_to<Vec<C::factors, double>>;
  { closure.diffusivity_at(i) } -> std::convertible_to<double>;
  { closure.speeds_of_pair(0, 1) } -> std::convertible_to<Vec<C::factors, double>>;
};

namespace detail {
template <class C>
concept NamesFactors = requires {
  std::integral_constant<int, C::factors>::value;
};
template <class C>
concept InheritsFactors = requires {
  requires !std::is_same_v<typename C::factors_of, C> && std::is_base_of_v<typename C::factors_of, C>;
};
template <class C>
constexpr bool explain_factors() {
  constexpr bool complete = !NamesFactors<C> || InheritsFactors<C> || FactoredClosure<C>;
  static_assert(complete,
                "this closure has `factors`, an int M above 0, and lacks what goes with it: factors_at(i) const and "
                "speeds_of_pair(k, l) const, each of which returns a Vec<M, double>, diffusivity_at(i) const, and "
                "`using factors_of =` the closure itself");
  if constexpr (FactoredClosure<C> && SpeciesClosure<C, AnyPoint>) {
    using others = Without<writes_of<C>, Fields<SegregationVelocities<C::species>, Diffusivity>>;
    constexpr bool alone = std::is_same_v<others, Fields<>>;
    static_assert(alone,
                  "this closure has `factors`, with which its operator() is not called, and writes other fields than "
                  "SegregationVelocities<N> and Diffusivity: leave out `factors`");
    return alone;
  }
  return complete;
}
}  // namespace detail

namespace detail {
template <int N, int K, int L, int Pair, class Visit>
SCREE_LOOP_FN void visit_pairs_of_species(Visit const& visit) {
  visit(std::integral_constant<int, K>{}, std::integral_constant<int, L>{}, std::integral_constant<int, Pair>{});
  if constexpr (L + 1 < N)
    visit_pairs_of_species<N, K, L + 1, Pair + 1>(visit);
  else if constexpr (K + 2 < N)
    visit_pairs_of_species<N, K + 1, K + 2, Pair + 1>(visit);
}
}  // namespace detail

/// Calls visit(k, l, pair) for all pairs k < l of N species in the order of SegregationVelocities. The arguments are
/// compile-time constants (std::integral_constant), so that the values that they select stay in registers.
template <int N, class Visit>
SCREE_LOOP_FN void for_each_pair_of_species(Visit const& visit) {
  detail::visit_pairs_of_species<N, 0, 1, 0>(visit);
}

/// Writes the velocities and the diffusivity of a closure with factors, computed from factors_at(), speeds_of_pair()
/// and diffusivity_at().
template <FactoredClosure Closure, class I, class O>
SCREE_FN void write_velocities(Closure const& closure, I const& i, O& out) {
  using namespace fields;
  using Real = std::remove_cvref_t<decltype(out[diffusivity])>;
  auto const f = closure.factors_at(i);
  for_each_pair_of_species<Closure::species>([&](auto k, auto l, auto pair) {
    out[segregation_velocities<Closure::species>][pair] = Real(dot(f, closure.speeds_of_pair(k, l)));
  });
  out[diffusivity] = Real(closure.diffusivity_at(i));
}

}  // namespace scree
