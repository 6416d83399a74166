// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/in_both_precisions.hpp"
#include "../core/setting.hpp"
#include "../fields/rate.hpp"
#include "../fields/species.hpp"
#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

#include <cmath>
#include <string>
#include <type_traits>

// The momentum carried by the mass of the species that particles exchange. See docs/theory/segregation.md.
namespace scree {

/// The momentum that a particle gains with the mass of species from its neighbours, less the momentum of this mass at
/// the particle's own velocity, per volume and time: $\frac{1}{2} \sum_j q_{ij} (u_j - u_i)/V_i$ with the mass $q_{ij}
/// = -q_{ji}$ that moves from j to i per time. The field is zero if all species have the same density.
struct CarriedMomentum : Vector<"carried momentum", "N/m^3"> {
  static constexpr bool may_stay_zero = true;
};

namespace fields {
inline constexpr CarriedMomentum carried_momentum{};
}  // namespace fields

/// The exchange of species of equal density, which carries no mass.
struct CarriesNothing {
  using reads = Fields<>;
  using adds = Fields<>;
  template <class I, class J, class Weight, class Exchange, class S>
  SCREE_FN void operator()(I const&, J const&, Weight const&, Exchange const&, S&) const {}
};

/// The contribution of a pair to CarriedMomentum: the exchanged mass moves with the mean velocity of the two particles.
/// Total momentum and kinetic energy are conserved: the exchange of a pair gives $\frac{1}{2} q_{ij} u_i \cdot u_j$ to
/// i and takes it from j.
template <int N>
class CarriesMomentum {
  InBothPrecisions<N> above_last_;

 public:
  using reads = Fields<Velocity>;
  using adds = Fields<CarriedMomentum>;
  /// Takes the densities of the species, kg/m^3.
  explicit CarriesMomentum(Vec<N, double> const& densities) {
    for (int k = 0; k < N; ++k) above_last_.set(k, densities[k] - densities[N - 1]);
  }
  /// Adds the contribution of a pair, given the rates of the concentrations as `weight` times `exchange`, 1/s.
  template <class I, class J, class Weight, class Exchange, class S>
  SCREE_FN void operator()(I const& i, J const& j, Weight const& weight, Exchange const& exchange, S& sum) const {
    using namespace fields;
    // The exchanged volumes add up to zero, so species of equal density exchange no mass at all.
    Weight gained = above_last_.template of<Weight>(0) * exchange[0];
    for (int k = 1; k < N - 1; ++k) gained += above_last_.template of<Weight>(k) * exchange[k];
    sum[carried_momentum] += (weight * gained / 2) * (j[velocity] - i[velocity]);
  }
};

/// The acceleration of a particle due to CarriedMomentum.
struct AccelerationByCarriedMomentum {
  using reads = Fields<Density, CarriedMomentum>;
  /// Returns the carried momentum divided by the density, m/s^2.
  template <class I>
  SCREE_FN auto acceleration(I const& i) const {
    using namespace fields;
    using vector = std::remove_cvref_t<decltype(i[carried_momentum])>;
    return vector(i[carried_momentum] / i[density]);
  }
};

/// Whether the species of a physics model have different densities, as in Granular with MixtureDensity:
/// species_densities() returns rho_k (kg/m^3) as a Vec<N, double>. A model of this kind has stages, and each stage
/// after the first reads CarriedMomentum.
template <class Physics>
concept GivesSpeciesDensities = requires(Physics const& physics) {
  physics.species_densities();
};

namespace detail {
template <class Physics>
struct species_densities_in {
  static constexpr int species = 0;
};
template <GivesSpeciesDensities Physics>
struct species_densities_in<Physics> {
  static constexpr int species = decltype(std::declval<Physics const&>().species_densities())::RowsAtCompileTime;
};
template <class Physics>
requires(!GivesSpeciesDensities<Physics> && requires { &Physics::mechanics; }) struct species_densities_in<Physics>
    : species_densities_in<std::remove_cvref_t<decltype(std::declval<Physics const&>().mechanics)>> {
};

template <class F>
inline constexpr bool is_of_species = false;
template <>
inline constexpr bool is_of_species<Concentration> = true;
template <int N>
inline constexpr bool is_of_species<Concentrations<N>> = true;
template <class List>
inline constexpr bool has_concentrations = false;
template <class... Fs>
inline constexpr bool has_concentrations<Fields<Fs...>> = (is_of_species<Fs> || ...);

template <class Transport>
concept CarriesMass = requires {
  requires Transport::carries_momentum;
};
}  // namespace detail

/// The number of species with different densities in a physics model, or in the mechanics of a combined model; 0 if
/// there is one density.
template <class Physics>
inline constexpr int species_with_densities = detail::species_densities_in<Physics>::species;

/// Returns the densities of the species of a physics model, or of the mechanics of a combined model, kg/m^3.
template <class Physics>
auto species_densities_of(Physics const& physics) {
  if constexpr (GivesSpeciesDensities<Physics>)
    return physics.species_densities();
  else
    return species_densities_of(physics.mechanics);
}

namespace detail {
/// Whether the closure of a transport has densities of the species.
template <class Transport>
concept HasDensitiesOfClosure = requires(Transport const& transport) {
  transport.closure.densities[0];
};
/// Throws std::invalid_argument unless the densities of the species have the same ratios in a closure (kg/m^3) as in
/// the law. Only ratios matter because all species have the same packing fraction, so a closure may use the densities
/// of the grains.
template <class Densities>
void check_same_densities(Densities const& of_law, Densities const& of_closure) {
  for (int k = 1; k < int(of_law.size()); ++k) {
    double const ratio = of_closure[k] / of_closure[0], wanted = of_law[k] / of_law[0];
    std::string const name = "densities[" + std::to_string(k) + "] over densities[0] of the closure of the segregation";
    check_setting(std::abs(ratio - wanted) <= 1e-3 * wanted, name.c_str(), ratio,
                  formatted("%.6g, as in the law", wanted).c_str());
  }
}

/// Whether a transport that moves mass also carries the momentum of this mass; true if it moves none.
template <class Mechanics, class Transport>
constexpr bool explain_carried_momentum() {
  constexpr bool carried = species_with_densities<Mechanics> == 0 ||
                           !has_concentrations<evolved_fields<typename Transport::evolves>> || CarriesMass<Transport>;
  static_assert(carried,
                "the species of the mechanics have densities of their own, so that mass and momentum move with them: "
                "combine it with SpeciesSegregation, not with a segregation of two sizes");
  return carried;
}
}  // namespace detail

}  // namespace scree
