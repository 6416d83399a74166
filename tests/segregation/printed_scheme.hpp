// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/segregation/hybrid.hpp>

// HCSR as Zhu et al. (2024) print it, from the terms of the library, for tests that show why the library differs.
namespace scree::test {

/// psi of (4.14) and (4.18).
struct Degenerate : Scalar<"degenerate function", "1"> {};
inline constexpr Degenerate degenerate{};
/// psi D.
struct Weakened : Scalar<"weakened diffusivity", "m^2/s"> {};
inline constexpr Weakened weakened{};
/// Unit normal of a wall particle, into the material.
struct NormalOfWall : Vector<"normal of a wall particle", "1"> {
  static constexpr bool may_stay_zero = true;  // of the material
};
inline constexpr NormalOfWall normal_of_wall{};
/// sum_{walls} V_j (n_i + n_j) . gradW_ij.
struct WallReaction : Scalar<"wall reaction", "1/m"> {};
inline constexpr WallReaction wall_reaction{};

struct FindNormalOfWall {
  using reads = Fields<>;
  using writes = Fields<NormalOfWall>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    out[normal_of_wall] = math::unit_vector(total[fields::kernel_gradient<Material>]);
  }
};

/// (4.18) near the free surface, otherwise (4.14): material counts +1, walls -1.
struct FindDegenerate {
  using reads = Fields<SurfaceSet, KernelSum<Material>, KernelSum<Wall>, Diffusivity>;
  using writes = Fields<Degenerate, Weakened>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    auto const material = i[kernel_sum<Material>], wall = i[kernel_sum<Wall>];
    auto psi = material;
    psi = 1;
    if (i[surface_set] & (surface::free | surface::near_free))
      psi = 2 * material - 1;
    else if (i[surface_set] != surface::interior)
      psi = (material - wall) / (material + wall);
    out[degenerate] = psi;
    out[weakened] = psi * i[diffusivity];
  }
};

struct WallReactionSum {
  using reads = Fields<Volume, NormalOfWall>;
  using reads_i = Fields<WallNormal>;
  using adds = Fields<WallReaction>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[wall_reaction] += j[volume] * (i[wall_normal] + j[normal_of_wall]).dot(ij.gradW());
  }
};

/// The indirect form (2.10) near boundaries, -V F' ghat . grad C with the C1-consistent gradient, and q: (4.16) near
/// the free surface, otherwise (4.9), f = -V F n . ghat.
struct PrintedBoundary {
  SegregationFlux flux;
  double h;
  using reads = Fields<SurfaceSet, Concentration, SegregationVelocity, FreeSurfaceNormal, WallNormal, WallReaction,
                       KernelGradient<Material>>;
  using writes = Fields<BoundaryRate>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    out[boundary_rate] = 0;
    if (i[surface_set] == surface::interior) return;
    auto const slope = GravityDirection{}.component(
        consistent_gradient(total[consistency_matrix], total[ConsistencyVector<Concentration>{}], h));
    auto const V = i[segregation_velocity], Q = V * flux.value(i[concentration]);
    auto rate = -V * flux.slope(i[concentration]) * slope;
    if (i[surface_set] & (surface::free | surface::near_free)) {
      auto const n = i[free_surface_normal];
      rate += 2 * -Q * GravityDirection{}.component(n) * n.dot(i[kernel_gradient<Material>]);
    } else {
      rate += Q * GravityDirection{}.component(i[wall_normal]) * i[wall_reaction];
    }
    out[boundary_rate] = rate;
  }
};

/// The indirect form (2.10) inside, with the plain gradient, and diffusion (3.8) with psi everywhere.
struct PrintedTransport {
  SegregationFlux flux;
  using reads = Fields<Volume, Concentration, Weakened>;
  using reads_i = Fields<SurfaceSet, SegregationVelocity>;
  using adds = Fields<ConcentrationRate>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const difference = i[concentration] - j[concentration];
    auto const radial = sq(ij.r) * ij.slope() / (sq(ij.r) + sq(ij.h()) / 100);
    sum[concentration_rate] += j[volume] * (i[weakened] + j[weakened]) * difference * radial;
    if (i[surface_set] == surface::interior)
      sum[concentration_rate] += i[segregation_velocity] * flux.slope(i[concentration]) * j[volume] * difference *
                                 GravityDirection{}.component(ij.gradW());
  }
};

template <class Closure>
struct PrintedSegregation {
  Closure closure = {};
  SegregationFlux flux = {};
  TransportStep step = {};

  using evolves = Fields<Concentration>;

  auto passes(Resolution const& resolution) const {
    using namespace hybrid;
    return std::tuple_cat(
        surface_passes(resolution), shear_rate_passes<Closure>(),
        std::tuple(point_pass<Material>("scree::closure", closure)),
        std::tuple(
            pair_pass_then<Wall>("normals of walls", FindNormalOfWall{}, over<Material>(KernelSums<Material>{})),
            point_pass<Material>("psi", FindDegenerate{}),
            pair_pass<Material>("wall reaction", over<Wall>(WallReactionSum{})),
            pair_pass_where<Material>("boundary", NearBoundary{}, PrintedBoundary{flux, resolution.smoothing_length},
                                      over<Material>(ConsistencyMatrixSum{}, ConsistencyVectorSum<Concentration>{})),
            pair_pass_then<Material>("transport", AddBoundaryRate{}, over<Material>(PrintedTransport{flux}))));
  }
  auto limits(Resolution const& resolution) const { return step.limits(resolution, flux); }
};

}  // namespace scree::test
