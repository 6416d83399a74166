// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/in_both_precisions.hpp"
#include "species_closure.hpp"

#include <type_traits>

// Two sources of the velocities S_kl of species: values stored for each particle, or factors of the particles times
// constants of the pairs of species.
namespace scree {

/// The factors f_m of a closure that has factors, see FactoredClosure.
template <int M>
struct SegregationFactors : Labelled<"segregation factors", "of the closure"> {
  template <int Dim, class Real>
  using value = Vec<M, Real>;
};

namespace fields {
template <int M>
inline constexpr SegregationFactors<M> segregation_factors{};
}  // namespace fields

/// The velocities S_kl as stored for each particle.
template <int N>
struct StoredVelocities {
  using reads = Fields<SegregationVelocities<N>>;
  /// Returns the sum of S_kl of both particles times a distance along gravity, m^2/s; `pair` is the index of the pair
  /// of species k and l.
  template <class I, class J, class Real, class Pair>
  SCREE_LOOP_FN auto drift(I const& i, J const& j, Real const& along, Pair pair) const {
    using namespace fields;
    return (i[segregation_velocities<N>][pair] + j[segregation_velocities<N>][pair]) * along;
  }
  /// Returns the largest |S_kl| of a particle, m/s, a bound on the speed $\sum_l S_{kl} C_l$ of every species.
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    auto const S = i[fields::segregation_velocities<N>];
    auto fastest = Kokkos::abs(S[0]);
    for (int pair = 1; pair < pairs_of_species<N>; ++pair) fastest = Kokkos::max(fastest, Kokkos::abs(S[pair]));
    return fastest;
  }
};

/// The velocities $S_{kl} = \sum_m f_m s_{kl,m}$, computed from M factors stored for each particle.
template <int N, int M>
class VelocitiesFromFactors {
  static constexpr int pairs = pairs_of_species<N>;
  InBothPrecisions<M * pairs> s_;

 public:
  using reads = Fields<SegregationFactors<M>>;

  /// Stores the constants s_kl,m of a closure.
  template <class Closure>
  explicit VelocitiesFromFactors(Closure const& closure) {
    for (int k = 0, pair = 0; k < N; ++k)
      for (int l = k + 1; l < N; ++l, ++pair) {
        Vec<M, double> const s = closure.speeds_of_pair(k, l);
        for (int m = 0; m < M; ++m) s_.set(m * pairs + pair, s[m]);
      }
  }
  /// Returns the sum of S_kl of both particles times a distance along gravity, m^2/s; `pair` is the index of the pair
  /// of species k and l.
  template <class I, class J, class Real, class Pair>
  SCREE_LOOP_FN auto drift(I const& i, J const& j, Real const& along, Pair pair) const {
    using namespace fields;
    auto const& f_i = i[segregation_factors<M>];
    auto const& f_j = j[segregation_factors<M>];
    auto sum = (f_i[0] + f_j[0]) * along * s_.template of<Real>(pair);
    for (int m = 1; m < M; ++m) sum += (f_i[m] + f_j[m]) * along * s_.template of<Real>(m * pairs + pair);
    return sum;
  }
  /// Returns the largest |S_kl| of a particle, m/s.
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
/// Whether particles store the factors of a closure, because there are fewer factors than velocities.
template <class Closure>
inline constexpr bool stores_factors = false;
template <FactoredClosure Closure>
inline constexpr bool stores_factors<Closure> = Closure::factors < pairs_of_species<Closure::species>;
}  // namespace detail

/// Returns the function of a particle that writes the fields that the transport reads from a closure.
template <class Closure>
auto function_of_species_closure(Closure const& closure) {
  if constexpr (detail::stores_factors<Closure>)
    return WriteFactors<Closure>{closure};
  else
    return closure;
}
/// Returns an object that computes the velocities of species for a closure, with drift() for two particles and with
/// operator() for the largest |S_kl| of one particle.
template <class Closure>
auto velocities_of(Closure const& closure) {
  if constexpr (detail::stores_factors<Closure>)
    return VelocitiesFromFactors<Closure::species, Closure::factors>(closure);
  else
    return StoredVelocities<Closure::species>{};
}

}  // namespace scree
