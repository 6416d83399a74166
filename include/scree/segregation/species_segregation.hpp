// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/mixture_bound.hpp"
#include "../terms/carried_momentum.hpp"
#include "pair_weights.hpp"
#include "species_closure.hpp"
#include "transport.hpp"

// Conservative segregation and diffusion of N species: one flux per pair of material particles and pair of species. See
// docs/theory/segregation.md.
namespace scree {

/// ln C_k.
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

/// The logarithmic mean (a - b)/(ln a - ln b) of two products that are not negative, where the difference of their
/// logarithms is known; 0 if either is 0 or less.
template <class Real>
SCREE_LOOP_FN Real logarithmic_mean(Real const& a, Real const& b, Real const& difference_of_logarithms) {
  using namespace math;
  Real const difference = a - b, least = min(a, b);
  // Below this the division loses digits and the arithmetic mean agrees with it to second order in the difference.
  Real const threshold = std::is_same_v<number_in<Real>, double> ? 1e-5 : 1e-3;
  auto const alike = max(difference, -difference) <= threshold * least;
  return select(least > Real(0), select(alike, (a + b) / 2, difference / difference_of_logarithms), Real(0));
}

/// $dC_{k,i}/dt = -\sum_j V_j w_{ij} \sum_{l \ne k} ((D_i + D_j)(a - b) - (S_{kl,i} + S_{kl,j}) M_{kl} \hat g \cdot
/// x_{ij})$ with the products $a = C_{k,i} C_{l,j}$ and $b = C_{k,j} C_{l,i}$ and their logarithmic mean M_kl. Each
/// term is antisymmetric in k and l, so that the sum of all C_k stays 1, and in i and j, so that the mean of each C_k
/// stays. With N = 2 it is PairTransport for the symmetric flux. `Carries` adds what the exchanged volumes carry.
template <int N, class Carries = CarriesNothing>
struct SpeciesTransport {
  GravityDirection down;
  Carries carries = {};
  using reads = Merge<Fields<Volume, Concentrations<N>, LogarithmsOfConcentrations<N>, SegregationVelocities<N>,
                             Diffusivity, OddCorrection, EvenCorrection>,
                      typename Carries::reads>;
  using adds = Merge<Fields<ConcentrationRates<N>>, typename Carries::adds>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using namespace math;
    auto const along = down.component(ij.x);
    auto const D = i[diffusivity] + j[diffusivity];
    auto const Ci = i[concentrations<N>];
    auto const Cj = j[concentrations<N>];
    auto const log_i = i[logarithms_of_concentrations<N>];
    auto const log_j = j[logarithms_of_concentrations<N>];
    auto const Si = i[segregation_velocities<N>];
    auto const Sj = j[segregation_velocities<N>];
    auto exchange = zero<Vec<N, std::remove_cvref_t<decltype(D * Ci[0])>>>();
    for_each_pair_of_species<N>([&](auto k, auto l, auto pair) {
      auto const drift = (Si[pair] + Sj[pair]) * along;
      auto const a = Ci[k] * Cj[l], b = Cj[k] * Ci[l];
      // The giver gives grains of species k and takes grains of species l.
      auto const from_j = drift > 0;
      auto const k_of_giver = select(from_j, Cj[k], Ci[k]), l_of_giver = select(from_j, Cj[l], Ci[l]);
      auto const k_of_taker = select(from_j, Ci[k], Cj[k]), l_of_taker = select(from_j, Ci[l], Cj[l]);
      auto const available = k_of_giver * l_of_taker;
      auto const mean = min(4 * available, logarithmic_mean(a, b, (log_i[k] - log_i[l]) - (log_j[k] - log_j[l])));
      // In a shock the giver has fewer grains of species k, relative to those of l, than the taker.
      auto const shock = min(k_of_giver * l_of_giver, k_of_taker * l_of_taker);
      auto const fan = min(min(k_of_giver, l_of_taker), (k_of_giver + k_of_taker) * (l_of_giver + l_of_taker) / 4);
      auto const sharp = drift * select(available < k_of_taker * l_of_giver, shock, fan);
      auto const smooth = drift * mean - D * (a - b);
      auto const of_k = select(a > b, min(smooth, sharp), max(smooth, sharp));
      exchange[k] += of_k;
      exchange[l] -= of_k;
    });
    auto const w = j[volume] * pair_weights::weight(i, j, ij);
    sum[concentration_rates<N>] += w * exchange;
    carries(i, j, w, exchange, sum);
  }
};

/// The largest |S_kl|, m/s: no species is faster than $\sum_l S_{kl} C_l$.
template <int N>
struct FastestSpecies {
  using reads = Fields<SegregationVelocities<N>>;
  template <class I>
  SCREE_FN auto operator()(I const& i) const {
    auto const S = i[fields::segregation_velocities<N>];
    auto fastest = Kokkos::abs(S[0]);
    for (int pair = 1; pair < pairs_of_species<N>; ++pair) fastest = Kokkos::max(fastest, Kokkos::abs(S[pair]));
    return fastest;
  }
};

/// Segregation and diffusion of N species without flux through any boundary of the material: conservative, bounded, and
/// with concentrations that add up to 1. For two species of grains use ConservativeSegregation, which stores one number
/// instead of two.
template <class Closure>
struct SpeciesSegregation {
  static constexpr int species = Closure::species;
  static constexpr bool carries_momentum = true;  ///< with the mass of species of different densities
  Closure closure = {};                           ///< velocities of pairs of species, and diffusivity
  TransportStep step = {};                        ///< limits of the time step

  static_assert(detail::explain_species_closure<Closure>());
  using evolves = Fields<Concentrations<species>>;

  /// Grains segregate along the gravity of the mechanics. Without mechanics it acts against the last coordinate, or as
  /// UnderGravity says.
  auto passes(Resolution const& resolution, Gravity const& gravity = {}) const {
    static_assert(detail::explain_stress_of_closure<Closure>());
    return std::tuple_cat(shear_rate_passes<Closure>(), transport(resolution, gravity));
  }
  /// The passes with mechanics, which computes the shear rate and has the gravity.
  template <class Mechanics>
  auto passes_with(Mechanics const& mechanics, Resolution const& resolution) const {
    static_assert(detail::explain_stress_of_closure<Closure, typename Mechanics::evolves>());
    constexpr int with_densities = species_with_densities<Mechanics>;
    static_assert(with_densities == 0 || with_densities == species,
                  "the mechanics has the densities of another number of species than the closure of the segregation");
    if constexpr (with_densities == species)
      return transport(resolution, gravity_of(mechanics), CarriesMomentum<species>{species_densities_of(mechanics)});
    else
      return transport(resolution, gravity_of(mechanics));
  }
  /// The passes where the shear rate is already known; `carries` adds what the exchanged volumes carry.
  template <class Carries = CarriesNothing>
  auto transport(Resolution const& resolution, Gravity const& gravity, Carries const& carries = {}) const {
    SpeciesTransport<species, Carries> const pairs{gravity.direction(), carries};
    return std::tuple_cat(pair_weights::passes(resolution),
                          std::tuple(point_pass<Material>("scree::closure", closure_under(closure, gravity)),
                                     point_pass<Material>("scree::logarithms", TakeLogarithms<species>{}),
                                     pair_pass<Material>("scree::transport", over<Material>(pairs))));
  }
  /// Throws std::invalid_argument where a setting is out of range.
  void check() const {
    check_settings_of(closure);
    step.check();
  }
  /// The warning of the closure.
  std::string warning() const { return warning_of_closure(closure); }
  /// The limits of the step: of the fastest species and of the diffusion. Throws as check() does.
  auto limits(Resolution const& resolution) const {
    check();
    return step.limits(resolution, FastestSpecies<species>{});
  }
  /// The bound on the state: the concentrations of a particle stay those of a mixture.
  auto validity(Resolution const&) const { return std::tuple(mixture_bound<species>()); }
};

}  // namespace scree
