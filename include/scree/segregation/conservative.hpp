// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "pair_weights.hpp"
#include "transport.hpp"

// Conservative segregation and diffusion: one flux per pair of material particles. See docs/theory/segregation.md.
namespace scree {

/// theta = int dC/F.
struct SegregationPotential : Scalar<"segregation potential", "1"> {};
inline constexpr SegregationPotential segregation_potential{};

struct PotentialOfConcentration {
  SegregationFlux flux;
  using reads = Fields<Concentration>;
  using writes = Fields<SegregationPotential>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[segregation_potential] = flux.potential(i[concentration]);
  }
};

/// dC_i/dt = -sum_j V_j w_ij ((D_i + D_j)(C_i - C_j) - (V_i + V_j) F_ij ghat . x_ij), antisymmetric in i and j.
/// Segregation and diffusion share the weight, so that a pair in equilibrium exchanges nothing, beside a boundary too.
struct PairTransport {
  SegregationFlux flux;
  using reads = Fields<Volume, Concentration, SegregationPotential, SegregationVelocity, Diffusivity, OddCorrection,
                       EvenCorrection>;
  using adds = Fields<ConcentrationRate>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    auto const descent = along_gravity(ij.x);
    auto const diffusion = (i[diffusivity] + j[diffusivity]) * (i[concentration] - j[concentration]);
    auto const segregation = (i[segregation_velocity] + j[segregation_velocity]) * mean_flux(i, j, descent) * descent;
    sum[concentration_rate] += j[volume] * pair_weights::weight(i, j, ij) * (segregation - diffusion);
  }

 private:
  // The logarithmic mean of F keeps C within [0, 1] at any cell Peclet number. It may draw more from a particle in a
  // step than it holds where C changes by orders of magnitude between neighbours; no more than in proportion to the
  // small grains of the upper particle and the large grains of the lower one may change places.
  template <class I, class J, class Real>
  SCREE_FN Real mean_flux(I const& i, J const& j, Real const& descent) const {
    Real const Ci = i[concentration], Cj = j[concentration];
    Real const mean = flux.mean(Ci, Cj, i[segregation_potential], j[segregation_potential]);
    Real const available = select(descent < 0, Ci * (1 - Cj), Cj * (1 - Ci));
    return min(4 * Real(flux.amplitude) * available, mean);
  }
};

/// Segregation and diffusion without flux through any boundary of the material, conservative and bounded. Needs neither
/// the free surface nor normals.
template <class Closure>
struct ConservativeSegregation {
  Closure closure = {};
  SegregationFlux flux = {};
  TransportStep step = {};

  using evolves = Fields<Concentration>;

  auto passes(Resolution const& resolution) const {
    return std::tuple_cat(shear_rate_passes<Closure>(), transport(resolution));
  }
  /// The same where the shear rate is known already.
  auto transport(Resolution const& resolution) const {
    return std::tuple_cat(pair_weights::passes(resolution),
                          std::tuple(point_pass<Material>("scree::closure", closure),
                                     point_pass<Material>("scree::potential", PotentialOfConcentration{flux}),
                                     pair_pass<Material>("scree::transport", over<Material>(PairTransport{flux}))));
  }
  auto limits(Resolution const& resolution) const {
    check_settings_of(closure);
    return step.limits(resolution, flux);
  }
};

}  // namespace scree
