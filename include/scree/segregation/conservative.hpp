// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/symmetric.hpp"
#include "../solver/pass.hpp"
#include "flux.hpp"
#include "transport.hpp"

// Conservative segregation and diffusion: one flux per pair of material particles. See docs/theory/segregation.md.
namespace scree {

/// sum_j V_j (-W'/r) x (x) x (x) x (x) x / r^2, as an operator on symmetric tensors.
struct FourthMoment : SymmetricOperator<"fourth moment of the kernel gradient", "1"> {};
inline constexpr FourthMoment fourth_moment{};
/// A_i: makes the second moments of the pair weights exact.
struct Correction : Symmetric<"correction of the pair weights", "1"> {};
inline constexpr Correction correction{};
/// theta = int dC/F.
struct SegregationPotential : Scalar<"segregation potential", "1"> {};
inline constexpr SegregationPotential segregation_potential{};

struct FourthMomentSum {
  using reads = Fields<Volume>;
  using adds = Fields<FourthMoment>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    auto const xx = square_of(ij.x);
    sum[fourth_moment] += (-j[volume] * ij.slope() / sq(ij.r)) * xx * xx.transpose();
  }
};

/// Solves M : A = I. Where the neighbours do not determine a positive A (a corner, a lone particle), the isotropic A with the
/// right trace is taken.
struct SolveCorrection {
  using reads = Fields<>;
  using writes = Fields<Correction>;
  static constexpr bool stores_sums = false;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    auto const M = total[fourth_moment];
    using Real = typename decltype(M)::Scalar;
    constexpr int n = decltype(M)::RowsAtCompileTime;
    constexpr int dim = n == 3 ? 2 : 3;
    auto const I3 = symmetric_identity<dim, Real>();
    Vec<n, Real> A = I3;
    if (!solve_positive_definite<n, Real>(M, I3, Real(1e-3), A)) A = I3;
    out[correction] = A;
  }
};

struct PotentialOfConcentration {
  SegregationFlux flux;
  using reads = Fields<Concentration>;
  using writes = Fields<SegregationPotential>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[segregation_potential] = flux.potential(i[concentration]);
  }
};

/// dC_i/dt = sum_j V_j w_ij (2 D_ij (C_i - C_j) - 2 V_ij F_ij ghat . x_ij), antisymmetric in i and j, with the symmetric weight
/// w_ij = (W'/r) (x/r) . (A_i + A_j)/2 (x/r), the same for both fluxes.
struct PairTransport {
  SegregationFlux flux;
  using reads = Fields<Volume, Concentration, SegregationPotential, SegregationVelocity, Diffusivity, Correction>;
  using adds = Fields<ConcentrationRate>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    auto const weight = ij.slope() / sq(ij.r) * (i[correction] + j[correction]).dot(square_of(ij.x)) / 2;
    auto const F = flux.mean(i[concentration], j[concentration], i[segregation_potential], j[segregation_potential]);
    auto const diffusion = (i[diffusivity] + j[diffusivity]) * (i[concentration] - j[concentration]);
    auto const segregation = (i[segregation_velocity] + j[segregation_velocity]) * F * along_gravity(ij.x);
    sum[concentration_rate] += j[volume] * weight * (diffusion - segregation);
  }
};

/// Segregation and diffusion without flux through any boundary of the material, conservative and bounded. Needs neither walls
/// nor the free surface to be found.
template <class Closure>
struct ConservativeSegregation {
  Closure closure = {};
  SegregationFlux flux = {};
  TransportStep step = {};

  using evolves = Fields<Concentration>;

  auto passes() const {
    return std::tuple_cat(
        closure_passes(closure),
        std::tuple(pair_pass_then<Material>("scree::correction", SolveCorrection{}, over<Material>(FourthMomentSum{})),
                   point_pass<Material>("scree::potential", PotentialOfConcentration{flux}),
                   pair_pass<Material>("scree::transport", over<Material>(PairTransport{flux}))));
  }
  template <class Sys>
  std::vector<TimeStepLimit> limits(Sys const& system) const {
    return step.limits(system, flux);
  }
};

}  // namespace scree
