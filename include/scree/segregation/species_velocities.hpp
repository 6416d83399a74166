// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/in_both_precisions.hpp"
#include "species_closure.hpp"

#include <type_traits>

// Where the velocities S_kl of the species come from: from the particles, or from factors of the particles and
// constants of the pairs of species.
namespace scree {

/// f_m of a closure that has factors, see FactoredClosure.
template <int M>
struct SegregationFactors : Labelled<"segregation factors", "of the closure"> {
  template <int Dim, class Real>
  using value = Vec<M, Real>;
};

namespace fields {
template <int M>
inline constexpr SegregationFactors<M> segregation_factors{};
}  // namespace fields

/// Velocities that particles store.
template <int N>
struct StoredVelocities {
  using reads = Fields<SegregationVelocities<N>>;
  /// S_kl of both particles together times a distance along gravity, m^2/s; `pair` is the number of the species k and
  /// l.
  template <class I, class J, class Real, class Pair>
  SCREE_LOOP_FN auto drift(I const& i, J const& j, Real const& along, Pair pair) const {
    using namespace fields;
    return (i[segregation_velocities<N>][pair] + j[segregation_velocities<N>][pair]) * along;
  }
  /// The largest |S_kl| of a particle, m/s: no species is faster than $\sum_l S_{kl} C_l$.
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    auto const S = i[fields::segregation_velocities<N>];
    auto fastest = Kokkos::abs(S[0]);
    for (int pair = 1; pair < pairs_of_species<N>; ++pair) fastest = Kokkos::max(fastest, Kokkos::abs(S[pair]));
    return fastest;
  }
};

/// Velocities from M factors of the particles, $S_{kl} = \sum_m f_m s_{kl,m}$.
template <int N, int M>
class VelocitiesFromFactors {
  static constexpr int pairs = pairs_of_species<N>;
  InBothPrecisions<M * pairs> s_;

 public:
  using reads = Fields<SegregationFactors<M>>;

  /// The constants s_kl,m of a closure.
  template <class Closure>
  explicit VelocitiesFromFactors(Closure const& closure) {
    for (int k = 0, pair = 0; k < N; ++k)
      for (int l = k + 1; l < N; ++l, ++pair) {
        Vec<M, double> const s = closure.speeds_of_pair(k, l);
        for (int m = 0; m < M; ++m) s_.set(m * pairs + pair, s[m]);
      }
  }
  /// S_kl of both particles together times a distance along gravity, m^2/s; `pair` is the number of the species k and
  /// l.
  template <class I, class J, class Real, class Pair>
  SCREE_LOOP_FN auto drift(I const& i, J const& j, Real const& along, Pair pair) const {
    using namespace fields;
    auto const& f_i = i[segregation_factors<M>];
    auto const& f_j = j[segregation_factors<M>];
    auto sum = (f_i[0] + f_j[0]) * along * s_.template of<Real>(pair);
    for (int m = 1; m < M; ++m) sum += (f_i[m] + f_j[m]) * along * s_.template of<Real>(m * pairs + pair);
    return sum;
  }
  /// The largest |S_kl| of a particle, m/s.
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    auto const f = i[fields::segregation_factors<M>];
    using Real = std::remove_cvref_t<decltype(f[0])>;
    Real fastest = 0;
    for (int pair = 0; pair < pairs; ++pair) {
      Real S = 0;
      for (int m = 0; m < M; ++m) S += f[m] * s_.template of<Real>(m * pairs + pair);
      fastest = Kokkos::max(fastest, Kokkos::abs(S));
    }
    return fastest;
  }
};

/// Writes the factors and the diffusivity of a closure that has factors.
template <FactoredClosure Closure>
struct WriteFactors {
  Closure closure;
  using reads = reads_of<Closure>;
  using writes = Fields<SegregationFactors<Closure::factors>, Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    using Real = std::remove_cvref_t<decltype(out[diffusivity])>;
    Vec<Closure::factors, double> const f = closure.factors_at(i);
    for (int m = 0; m < Closure::factors; ++m) out[segregation_factors<Closure::factors>][m] = Real(f[m]);
    out[diffusivity] = Real(closure.diffusivity_at(i));
  }
};

namespace detail {
/// Whether the particles of a closure store fewer numbers with factors than with velocities.
template <class Closure>
inline constexpr bool stores_factors = false;
template <FactoredClosure Closure>
inline constexpr bool stores_factors<Closure> = Closure::factors < pairs_of_species<Closure::species>;
}  // namespace detail

/// The function of a particle that writes what the transport reads of a closure.
template <class Closure>
auto function_of_species_closure(Closure const& closure) {
  if constexpr (detail::stores_factors<Closure>)
    return WriteFactors<Closure>{closure};
  else
    return closure;
}
/// The velocities of the species of a closure: between two particles and, as a function of a particle, the largest.
template <class Closure>
auto velocities_of(Closure const& closure) {
  if constexpr (detail::stores_factors<Closure>)
    return VelocitiesFromFactors<Closure::species, Closure::factors>(closure);
  else
    return StoredVelocities<Closure::species>{};
}

}  // namespace scree
