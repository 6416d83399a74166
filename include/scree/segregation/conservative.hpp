// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "pair_weights.hpp"
#include "transport.hpp"

// Conservative segregation and diffusion: one flux per pair of material particles. See docs/theory/segregation.md.
namespace scree {

/// $\theta = \int dC/F$.
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

/// $dC_i/dt = -\sum_j V_j w_{ij} ((D_i + D_j)(C_i - C_j) - (V_i + V_j) F_{ij} \hat g \cdot x_{ij})$, antisymmetric in
/// i and j. Segregation and diffusion share the weight, so that a pair in equilibrium exchanges nothing, even near a
/// boundary.
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
    // The logarithmic mean of F preserves the equilibrium and keeps C within [0, 1] at any cell Peclet number. In one
    // step it may draw more from a particle than it holds if C changes by orders of magnitude between neighbours. The
    // bound is proportional to the small grains of the giver and the large grains of the taker.
    auto const available = 4 * decltype(giver)(flux.amplitude) * giver * (1 - taker);
    auto const mean = min(available, flux.mean(Ci, Cj, i[segregation_potential], j[segregation_potential]));
    // Where diffusion is weak, the mean lets shocks oscillate and keeps a jump from 1 to 0 unchanged: there the sharp
    // flux, which spreads C more, replaces it.
    auto const smooth = drift * mean - diffusion, sharp = drift * flux.sharp(giver, taker);
    auto const exchange = select(Ci > Cj, min(smooth, sharp), max(smooth, sharp));
    sum[concentration_rate] += j[volume] * pair_weights::weight(i, j, ij) * exchange;
  }
};

/// Segregation and diffusion without flux through any boundary of the material, conservative and bounded. It needs
/// neither the free surface nor normals.
template <class Closure>
struct ConservativeSegregation {
  Closure closure = {};       ///< segregation velocity and diffusivity
  SegregationFlux flux = {};  ///< the flux function
  TransportStep step = {};    ///< limits of the time step

  static_assert(detail::explain_closure<Closure>());
  using evolves = Fields<Concentration>;

  /// The passes of the transport and those of the shear rate. Without mechanics gravity acts against the last
  /// coordinate, or as UnderGravity says.
  auto passes(Resolution const& resolution, Gravity const& gravity = {}) const {
    static_assert(detail::explain_stress_of_closure<Closure>());
    return std::tuple_cat(shear_rate_passes<Closure>(), transport(resolution, gravity));
  }
  /// The passes of the transport with mechanics, which computes the shear rate and has the gravity.
  template <class Mechanics>
  auto passes_with(Mechanics const& mechanics, Resolution const& resolution) const {
    static_assert(detail::explain_stress_of_closure<Closure, typename Mechanics::evolves>());
    return transport(resolution, gravity_of(mechanics));
  }
  /// The passes of the transport, if other passes compute the shear rate.
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
  /// The warning of the closure.
  std::string warning() const { return warning_of_closure(closure); }
  /// The warning of the closure about the state that a body (WholeBody) has come to; empty if there is none.
  template <class Whole>
  std::string warning_of_state(Whole const& body) const requires detail::KnowsItsFit<Closure> {
    return warning_beyond_fit(closure, body);
  }
  /// The limits of the step: of the flux and of the diffusion. Throws as check() does.
  auto limits(Resolution const& resolution) const {
    check();
    return step.limits(resolution, flux);
  }
  /// The bound on the state: concentrations stay within 0 and 1, to 1e-3.
  auto validity(Resolution const&) const { return std::tuple(concentration_bound(1e-3)); }
};

}  // namespace scree

#include "instances.hpp"
