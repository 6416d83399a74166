// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../fields/species.hpp"
#include "law.hpp"
#include "relative_density.hpp"
#include "response.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

/// A law for a mixture of N species with different densities, $\rho = \sum_k C_k \rho_k$. The mass of a particle
/// depends on its composition; its volume does not.
///
///     struct Models : GranularModels { using law = MixtureDensity<MuOfI<PolydisperseGrains<3>>, 3>; };
///     using physics = Combined<Granular<Models>, SpeciesSegregation<SizeDensityClosure<3>>>;
///
/// All mixtures have the stiffness of the law, and the speed of sound is proportional to $1/\sqrt{\rho}$. The density
/// of the law must be the one for which its other parameters hold. All species are assumed to have the same packing, so
/// that the grain density in the inertial number of MuOfI is `grain_density` times rho over the density of the law. A
/// user-defined law that uses the density of its grains multiplies it by relative_density_of(point). Modifiers such as
/// VolumeMemory may be inside or around MixtureDensity; MixtureDensity cannot be inside ByGroup.
template <class Law, int N>
struct MixtureDensity : Law {
  static_assert(detail::explain_law<Law>());
  static_assert(detail::GivesDensity<Law>,
                "the law in MixtureDensity needs density(), one density that its other parameters belong to");

  static constexpr int species_of_density = N;
  Vec<N, double> densities = zero<Vec<N, double>>();  ///< rho_k, bulk density at rest of each pure species, kg/m^3

  using reads = Merge<Fields<Concentrations<N>>, reads_of<Law>>;
  using history = typename Law::history;

  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_settings_of(static_cast<Law const&>(*this));
    detail::check_response(static_cast<Law const&>(*this));
    check_densities<N>(densities, "MixtureDensity");
  }
  /// Returns the density of a mixture, kg/m^3.
  template <class Real>
  SCREE_FN double density_of(Vec<N, Real> const& C) const {
    // Summing differences gives exactly this density if all densities are equal.
    double const last = densities[N - 1];
    double rho = last;
    for (int k = 0; k < N - 1; ++k) rho += double(C[k]) * (densities[k] - last);
    return rho;
  }
  template <class Point>
  SCREE_FN double density(Point const& point) const {
    return density_of(point[fields::concentrations<N>]);
  }
  /// Returns the speed of sound of the lightest species, m/s, for a law of constant stiffness.
  double largest_sound_speed() const requires ConstantStiffness<Law> {
    double lightest = densities[0];
    for (int k = 1; k < N; ++k) lightest = std::min(lightest, densities[k]);
    return Law::sound_speed() * std::sqrt(Law::density() / lightest);
  }
  /// Returns $\rho c^2$, Pa, which is the same for all mixtures, for a law of constant stiffness.
  double modulus_of_waves() const requires ConstantStiffness<Law> { return Law::density() * sq(Law::sound_speed()); }
  template <class Real, class Point>
  SCREE_FN Real bulk_modulus(StressTensor<Real> const& sigma, Point const& point) const {
    return bulk_modulus_at(alone(), sigma, of_mixture(point));
  }
  template <class Real, class Point>
  SCREE_FN Real sound_speed(StressTensor<Real> const& sigma, Point const& point) const {
    auto const mixed = of_mixture(point);
    return sound_speed_at(alone(), sigma, mixed) / Real(Kokkos::sqrt(mixed.relative_density));
  }
  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L,
                                          Point const& point) const {
    return Law::stress_rate(sigma, L, of_mixture(point));
  }
  template <class Real, class Point, class Rates>
  SCREE_FN void history_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L, Point const& point,
                             Rates& rates) const requires EvolvesHistory<Law> {
    Law::history_rate(sigma, L, of_mixture(point), rates);
  }
  /// Returns $\sqrt{J_2}$ (Pa) at yield in plane shear at a pressure p (Pa).
  template <class Real, class Point>
  SCREE_FN Real shear_strength(Real p, Point const& point) const {
    return Law::shear_strength(p, of_mixture(point));
  }
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&& memory) const {
    return Law::admissible(trial, of_mixture(point), memory);
  }

 private:
  SCREE_FN Law const& alone() const { return *this; }
  template <class Point>
  SCREE_FN PointOfMixture<Point> of_mixture(Point const& point) const {
    return {point, density(point) / Law::density()};
  }
};

}  // namespace scree
