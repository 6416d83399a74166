// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../surface/detect.hpp"
#include "../terms/consistent_gradient.hpp"
#include "transport.hpp"

// The hybrid continuum surface reaction scheme (HCSR) of Zhu et al. (2024), section 4.2. Volumetric sources near the
// boundary impose zero flux through walls (CCSR, from dummy particles) and through the free surface (MCSR, from the
// material itself). Three changes make the scheme stable, see docs/theory/segregation.md: the gradient of the flux Q =
// V F is used instead of those of C and V (the indirect form (2.10) causes the blow-up); psi = 1 replaces (4.14) and
// (4.18); the sources of walls and of the free surface are added after the normals are eliminated, so that corners need
// no special rule.
namespace scree {

/// The segregation flux Q = V F, m/s.
struct SegregationFluxValue : Scalar<"segregation flux", "m/s"> {};

/// The contribution of the boundary to the rate of the concentration, 1/s.
struct BoundaryRate : Scalar<"boundary rate", "1/s"> {};

namespace fields {
inline constexpr SegregationFluxValue segregation_flux{};
inline constexpr BoundaryRate boundary_rate{};
}  // namespace fields

namespace hybrid {

/// Computes the flux Q = V F before the sums over neighbours.
struct FluxOfConcentration {
  SegregationFlux flux;
  using reads = Fields<Concentration, SegregationVelocity>;
  using writes = Fields<SegregationFluxValue>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    out[segregation_flux] = i[segregation_velocity] * flux.value(i[concentration]);
  }
};

/// Whether a particle is in one of the surface sets.
struct NearBoundary {
  using reads = Fields<SurfaceSet>;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[fields::surface_set] != surface::interior;
  }
};

/// The rate near boundaries: $-\nabla_g Q$ from the C1-consistent gradient, and the sources that compensate for the
/// missing support, $q = 2 Q \hat g \cdot \sum_\text{walls} V \nabla W$ (CCSR) and $q = -2 Q \hat g \cdot
/// \sum_\text{material and walls} V \nabla W$ (MCSR). If the normal n points along the respective sum, these are (4.9)
/// and (4.16) with $f = -Q n \cdot \hat g$.
struct BoundaryFlux {
  double h;  ///< smoothing length, m
  GravityDirection down;
  using reads = Fields<SurfaceSet, SegregationFluxValue, KernelGradient<Material>, KernelGradient<Wall>>;
  using writes = Fields<BoundaryRate>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    out[boundary_rate] = 0;
    if (i[surface_set] == surface::interior) return;
    auto const Q = i[segregation_flux];
    auto const wall = i[kernel_gradient<Wall>];
    auto const all = (i[kernel_gradient<Material>] + wall).eval();
    auto rate = -down.component(
        consistent_gradient(total[consistency_matrix], total[ConsistencyVector<SegregationFluxValue>{}], h));
    rate += 2 * Q * down.component(wall);
    if (i[surface_set] & (surface::free | surface::near_free)) rate -= 2 * Q * down.component(all);
    out[boundary_rate] = rate;
  }
};

/// The sum over pairs of material particles: diffusion everywhere and, in the interior, $-\nabla_g Q$ from the plain
/// gradient. Because the sum excludes walls, nothing diffuses through them or through the free surface.
struct InteriorTransport {
  GravityDirection down;
  using reads = Fields<Volume, Concentration, SegregationFluxValue, Diffusivity>;
  using reads_i = Fields<SurfaceSet>;
  using adds = Fields<ConcentrationRate>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const slope = j[volume] * ij.slope();
    sum[concentration_rate] += slope * (i[diffusivity] + j[diffusivity]) * (i[concentration] - j[concentration]);
    if (i[surface_set] == surface::interior)
      sum[concentration_rate] += slope * (i[segregation_flux] - j[segregation_flux]) * down.component(ij.x);
  }
};

/// Adds the rate from the boundary to the rate from the sum over pairs.
struct AddBoundaryRate {
  using reads = Fields<BoundaryRate>;
  using writes = Fields<ConcentrationRate>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    out[concentration_rate] = total[concentration_rate] + i[boundary_rate];
  }
};

}  // namespace hybrid

/// A scheme for segregation and diffusion with the HCSR boundary treatment. Like the scheme of the paper, it is neither
/// conservative nor strictly bounded.
template <class Closure>
struct HybridSegregation {
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
    using namespace hybrid;
    GravityDirection const down = gravity.direction();
    return std::tuple_cat(
        surface_passes(resolution),
        std::tuple(
            point_pass<Material>("scree::closure", closure_under(closure, gravity)),
            point_pass<Material>("scree::segregation_flux", FluxOfConcentration{flux}),
            pair_pass_where<Material>(
                "scree::boundary_flux", NearBoundary{}, BoundaryFlux{resolution.smoothing_length, down},
                over<Material>(ConsistencyMatrixSum{}, ConsistencyVectorSum<SegregationFluxValue>{})),
            pair_pass_then<Material>("scree::transport", AddBoundaryRate{}, over<Material>(InteriorTransport{down}))));
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
  /// Returns the bound on the state: concentrations must start within [0, 1] to 1e-3, and may then leave it by up to
  /// 0.5.
  auto validity(Resolution const& resolution) const {
    return std::tuple(concentration_bound(resolution.steps == 0 ? 1e-3 : 0.5));
  }
};

}  // namespace scree

#include "hybrid_instances.hpp"
