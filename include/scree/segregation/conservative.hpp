// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "pair_weights.hpp"
#include "transport.hpp"

// Conservative segregation and diffusion: one flux per pair of material particles. See docs/theory/segregation.md.
namespace scree {

/// The potential $\theta = \int dC/F$ of the concentration.
struct SegregationPotential : Scalar<"segregation potential", "1"> {};

namespace fields {
inline constexpr SegregationPotential segregation_potential{};
}  // namespace fields

/// Computes the potential theta of the concentration before the sum over pairs.
struct PotentialOfConcentration {
  SegregationFlux flux;
  using reads = Fields<Concentration>;
  using writes = Fields<SegregationPotential>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    out[segregation_potential] = flux.potential(i[concentration]);
  }
};

/// The rate $dC_i/dt = -\sum_j V_j w_{ij} ((D_i + D_j)(C_i - C_j) - (V_i + V_j) F_{ij} \hat g \cdot x_{ij})$. The flux
/// between two particles is antisymmetric in i and j. Segregation and diffusion share the weight, so that a pair in
/// equilibrium exchanges nothing, even near a boundary.
struct PairTransport {
  SegregationFlux flux;
  GravityDirection down;
  using reads = Fields<Volume, Concentration, SegregationPotential, SegregationVelocity, Diffusivity, OddCorrection,
                       EvenCorrection>;
  using adds = Fields<ConcentrationRate>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using namespace math;
    auto const Ci = i[concentration], Cj = j[concentration];
    auto const drift = (i[segregation_velocity] + j[segregation_velocity]) * down.component(ij.x);
    auto const diffusion = (i[diffusivity] + j[diffusivity]) * (Ci - Cj);
    auto const giver = select(drift > 0, Cj, Ci), taker = select(drift > 0, Ci, Cj);
    // The logarithmic mean of F preserves the equilibrium and keeps C within [0, 1] at any cell Peclet number. If C
    // changes by orders of magnitude between neighbours, it may take more from a particle in one step than the particle
    // holds. It is therefore bounded by a value proportional to the small grains of the giver and the large grains of
    // the taker.
    auto const available = 4 * decltype(giver)(flux.amplitude) * giver * (1 - taker);
    auto const mean = min(available, flux.mean(Ci, Cj, i[segregation_potential], j[segregation_potential]));
    // Where diffusion is weak, shocks oscillate with the logarithmic mean, and a jump from 1 to 0 persists: there the
    // mean is replaced by the sharp flux, which spreads C more.
    auto const smooth = drift * mean - diffusion, sharp = drift * flux.sharp(giver, taker);
    auto const exchange = select(Ci > Cj, min(smooth, sharp), max(smooth, sharp));
    sum[concentration_rate] += j[volume] * pair_weights::weight(i, j, ij) * exchange;
  }
};

/// A conservative and bounded scheme for segregation and diffusion without flux through any boundary of the material.
/// It needs neither the free surface nor normals.
template <class Closure>
struct ConservativeSegregation {
  Closure closure = {};       ///< segregation velocity and diffusivity
  SegregationFlux flux = {};  ///< the flux function
  TransportStep step = {};    ///< limits of the time step

  static_assert(detail::explain_closure<Closure>());
  using evolves = Fields<Concentration>;

  /// Returns the passes of the transport, after those of the shear rate if the closure reads it, for a run without
  /// mechanics. Gravity acts against the last coordinate, unless UnderGravity sets another one.
  auto passes(Resolution const& resolution, Gravity const& gravity = {}) const {
    static_assert(detail::explain_stress_of_closure<Closure>());
    return std::tuple_cat(shear_rate_passes<Closure>(), transport(resolution, gravity));
  }
  /// Returns the passes of the transport with mechanics, which provides the shear rate and the gravity.
  template <class Mechanics>
  auto passes_with(Mechanics const& mechanics, Resolution const& resolution) const {
    static_assert(detail::explain_stress_of_closure<Closure, typename Mechanics::evolves>());
    return transport(resolution, gravity_of(mechanics));
  }
  /// Returns the passes of the transport alone, for models in which other passes compute the shear rate.
  auto transport(Resolution const& resolution, Gravity const& gravity) const {
    PairTransport const pairs{flux, gravity.direction()};
    return std::tuple_cat(pair_weights::passes(resolution),
                          std::tuple(point_pass<Material>("scree::closure", closure_under(closure, gravity)),
                                     point_pass<Material>("scree::potential", PotentialOfConcentration{flux}),
                                     pair_pass<Material>("scree::transport", over<Material>(pairs))));
  }
  /// Throws std::invalid_argument if a setting is out of range.
  void check() const {
    check_settings_of(closure);
    flux.check();
    step.check();
  }
  /// Returns the warning of the closure; empty if it has none.
  std::string warning() const { return warning_of_closure(closure); }
  /// Returns the warning of the closure about the present state of a body (WholeBody); empty if there is none.
  template <class Whole>
  std::string warning_of_state(Whole const& body) const requires detail::KnowsItsFit<Closure> {
    return warning_beyond_fit(closure, body);
  }
  /// Returns the limits of the time step from segregation and from diffusion. Throws as check() does.
  auto limits(Resolution const& resolution) const {
    check();
    return step.limits(resolution, flux);
  }
  /// Returns the bound on the state: concentrations stay within [0, 1] to 1e-3.
  auto validity(Resolution const&) const { return std::tuple(concentration_bound(1e-3)); }
};

}  // namespace scree

#include "instances.hpp"
