// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/mixture_bound.hpp"
#include "../terms/carried_momentum.hpp"
#include "pair_weights.hpp"
#include "species_velocities.hpp"
#include "transport.hpp"

// Conservative segregation and diffusion of N species, with one flux per pair of material particles and pair of
// species. See docs/theory/segregation.md.
namespace scree {

/// The logarithms ln C_k of the concentrations.
template <int N>
struct LogarithmsOfConcentrations : PerSpecies<N, "logarithms of concentrations", "1"> {};

namespace fields {
template <int N>
inline constexpr LogarithmsOfConcentrations<N> logarithms_of_concentrations{};
}  // namespace fields

/// Computes the logarithms of the concentrations before the sum over pairs.
template <int N>
struct TakeLogarithms {
  using reads = Fields<Concentrations<N>>;
  using writes = Fields<LogarithmsOfConcentrations<N>>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    auto& logarithms = out[logarithms_of_concentrations<N>];
    for (int k = 0; k < N; ++k) {
      auto const C = i[concentrations<N>][k];
      logarithms[k] = Kokkos::log(Kokkos::max(decltype(C + C)(0), C));
    }
  }
};

/// Returns the logarithmic mean (a - b)/(ln a - ln b) of two non-negative products a and b, given a - b, a and ln a -
/// ln b; 0 if one of the products is 0, and NaN if the difference of the logarithms is NaN.
template <class Real>
SCREE_LOOP_FN Real logarithmic_mean(Real const& difference, Real const& a, Real const& difference_of_logarithms) {
  using namespace math;
  // Below this threshold the division loses digits, and the arithmetic mean agrees with its result to second order in
  // the difference.
  Real const threshold = std::is_same_v<number_in<Real>, double> ? 1e-5 : 1e-3;
  auto const alike = magnitude(difference_of_logarithms) <= threshold;
  return select(alike, a - difference / 2, ratio(difference, difference_of_logarithms));
}

/// The rates $dC_{k,i}/dt = -\sum_j V_j w_{ij} \sum_{l \ne k} ((D_i + D_j)(a - b) - (S_{kl,i} + S_{kl,j}) M_{kl} \hat g
/// \cdot x_{ij})$ with the products $a = C_{k,i} C_{l,j}$ and $b = C_{k,j} C_{l,i}$ and their logarithmic mean M_kl.
/// Each term is antisymmetric in k and l, so that the sum of all C_k stays 1, and in i and j, so that the mean of each
/// C_k is conserved. For N = 2 this is PairTransport with the symmetric flux. `Velocities` provides S_kl; `Carries`
/// adds what the exchanged volumes carry.
template <int N, class Carries = CarriesNothing, class Velocities = StoredVelocities<N>>
struct SpeciesTransport {
  GravityDirection down;
  Carries carries;
  Velocities velocities;
  using reads = Merge<
      Fields<Volume, Concentrations<N>, LogarithmsOfConcentrations<N>, Diffusivity, OddCorrection, EvenCorrection>,
      typename Velocities::reads, typename Carries::reads>;
  using adds = Merge<Fields<ConcentrationRates<N>>, typename Carries::adds>;
  static constexpr bool takes_packs = true;
  static constexpr bool is_long = pairs_of_species<N> > 15;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using namespace math;
    auto const along = down.component(ij.x);
    auto const D = i[diffusivity] + j[diffusivity];
    auto const& Ci = i[concentrations<N>];
    auto const& Cj = j[concentrations<N>];
    auto const between = (Ci + Cj) / 2;
    auto const logarithms = i[logarithms_of_concentrations<N>] - j[logarithms_of_concentrations<N>];
    auto exchange = zero<std::remove_cvref_t<decltype(between)>>();
    for_each_pair_of_species<N>([&](auto k, auto l, auto pair) {
      auto const drift = velocities.drift(i, j, along, pair);
      auto const a = Ci[k] * Cj[l], b = Cj[k] * Ci[l];
      // The giver gives grains of species k and takes grains of species l.
      auto const from_j = drift > 0;
      auto const available = select(from_j, b, a), opposite = select(from_j, a, b);
      // The mean is NaN only if a = b = 0, and then nothing is available.
      auto const mean = smaller(logarithmic_mean(a - b, a, logarithms[k] - logarithms[l]), 4 * available);
      // In a shock the ratio of species k to species l is lower in the giver than in the taker.
      auto const shock = available < opposite;
      auto const in_shock = smaller(Ci[k] * Ci[l], Cj[k] * Cj[l]);
      auto const in_fan = smaller(between[k] * between[l], available);
      auto const smooth = drift * mean - D * (a - b), sharp = drift * select(shock, in_shock, in_fan);
      // The chosen flux is the one that brings both mixtures closer to each other.
      auto const sharp_is_closer = (sharp < smooth) == (shock == from_j);
      auto const of_k = select(sharp_is_closer, sharp, smooth);
      exchange[k] += of_k;
      exchange[l] -= of_k;
    });
    auto const w = j[volume] * pair_weights::weight(i, j, ij);
    sum[concentration_rates<N>] += w * exchange;
    carries(i, j, w, exchange, sum);
  }
};

/// A conservative and bounded scheme for segregation and diffusion of N species without flux through any boundary of
/// the material. The concentrations add up to 1. For two species use ConservativeSegregation, which stores one number
/// per particle instead of two.
template <class Closure>
struct SpeciesSegregation {
  static constexpr int species = Closure::species;
  static constexpr bool carries_momentum = true;  ///< species of different densities carry momentum with their mass
  Closure closure = {};                           ///< velocities of pairs of species, and diffusivity
  TransportStep step = {};                        ///< limits of the time step

  static_assert(detail::explain_species_closure<Closure>() && detail::explain_factors<Closure>());
  using evolves = Fields<Concentrations<species>>;

  /// Returns the passes of the transport, after those of the shear rate if the closure reads it, for a run without
  /// mechanics. Gravity acts against the last coordinate, unless UnderGravity sets another one.
  auto passes(Resolution const& resolution, Gravity const& gravity = {}) const {
    static_assert(detail::explain_stress_of_closure<Closure>());
    return std::tuple_cat(shear_rate_passes<Closure>(), transport(resolution, gravity));
  }
  /// Returns the passes of the transport with mechanics, which provides the shear rate and the gravity along which
  /// grains segregate.
  template <class Mechanics>
  auto passes_with(Mechanics const& mechanics, Resolution const& resolution) const {
    static_assert(detail::explain_stress_of_closure<Closure, typename Mechanics::evolves>());
    constexpr int with_densities = species_with_densities<Mechanics>;
    static_assert(with_densities == 0 || with_densities == species,
                  "the mechanics has the densities of another number of species than the closure of the segregation");
    if constexpr (with_densities == species)
      return transport(resolution, gravity_of(mechanics), CarriesMomentum<species>(species_densities_of(mechanics)));
    else
      return transport(resolution, gravity_of(mechanics));
  }
  /// Returns the passes of the transport alone, for models in which other passes compute the shear rate; `carries` adds
  /// what the exchanged volumes carry.
  template <class Carries = CarriesNothing>
  auto transport(Resolution const& resolution, Gravity const& gravity, Carries const& carries = {}) const {
    auto const of_gravity = closure_under(closure, gravity);
    auto const velocities = velocities_of(of_gravity);
    SpeciesTransport<species, Carries, decltype(velocities_of(closure))> const pairs{gravity.direction(), carries,
                                                                                     velocities};
    return std::tuple_cat(pair_weights::passes(resolution),
                          std::tuple(point_pass<Material>("scree::closure", function_of_species_closure(of_gravity)),
                                     point_pass<Material>("scree::logarithms", TakeLogarithms<species>{}),
                                     pair_pass<Material>("scree::transport", over<Material>(pairs))));
  }
  /// Throws std::invalid_argument if a setting is out of range.
  void check() const {
    check_settings_of(closure);
    step.check();
  }
  /// Returns the warning of the closure; empty if it has none.
  std::string warning() const { return warning_of_closure(closure); }
  /// Returns the limits of the time step from the fastest species and from diffusion. Throws as check() does.
  auto limits(Resolution const& resolution) const {
    check();
    return step.limits(resolution, velocities_of(closure));
  }
  /// Returns the bound on the state: the concentrations of a particle remain those of a mixture.
  auto validity(Resolution const&) const { return std::tuple(mixture_bound<species>()); }
};

}  // namespace scree
