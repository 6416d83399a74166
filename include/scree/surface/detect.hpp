// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/pass.hpp"
#include "../passes/resolution.hpp"
#include "cell_types.hpp"

namespace scree {

/// Number of particles of all bodies in the umbrella of a particle; the axis of the umbrella is computed from all
/// bodies.
struct Covered : Integer<"particles that cover the umbrella", "1"> {};
/// Number of material particles in the umbrella of a particle; the axis of the umbrella is computed from the material
/// only.
struct CoveredByMaterial : Integer<"material particles that cover the umbrella", "1"> {};
/// The surface set of a particle, limited to Omega_F and Omega_W: `free`, `wall` or `interior`.
struct OnSurface : Integer<"on a surface", "1"> {};
/// Number of neighbours in Omega_F that are closer than 2h - spacing.
struct FreeNeighbours : Integer<"free surface particles in reach", "1"> {};
/// The kernel gradient sum $\sum_{j \in \Omega_F} V_j \nabla W_{ij}$, which points towards the free surface.
struct FreeGradient : Vector<"kernel gradient over the free surface", "1/m"> {};

namespace fields {
inline constexpr Covered covered{};
inline constexpr CoveredByMaterial covered_by_material{};
inline constexpr OnSurface on_surface{};
inline constexpr FreeNeighbours free_neighbours{};
inline constexpr FreeGradient free_gradient{};
}  // namespace fields

namespace surface {

/// Condition that the support of a particle may be truncated.
struct Outer {
  using reads = Fields<CellType>;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[fields::cell_type] < 3;
  }
};
/// Condition that a particle is in a cell next to an empty cell.
struct Outermost {
  using reads = Fields<CellType>;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[fields::cell_type] == 1;
  }
};

/// Returns whether j is in the umbrella region of i, eq. (4.19). The tip of the region is at a distance h from i,
/// opposite to the unit vector `inward`. Within $\sqrt{2} h$ of i the region is a cone of 45 degrees; farther out it is
/// the sphere of radius h around the tip. If neighbours are distributed so evenly that `inward` is undefined, every
/// neighbour counts as covering i.
template <class IJ, class X>
SCREE_FN bool in_umbrella(IJ const& ij, X const& inward) {
  using Real = typename X::Scalar;
  Real const h = ij.h();
  if (!(squared_norm(inward) > Real(0.5))) return true;
  if (sq(ij.r) < 2 * sq(h)) return dot(ij.x, inward) > Real(0.70710678118654752) * ij.r;
  return squared_norm(ij.x - h * inward) < sq(h);
}

/// Returns whether wall particles are within the support of i. On a lattice some wall particles are on the edge of the
/// support; the threshold above zero excludes them whatever the rounding.
template <class I>
SCREE_FN bool sees_wall(I const& i) {
  return i[fields::kernel_sum<Wall>] > 1e-6f;
}

/// Pair term that counts the particles of one body in the umbrella of i.
template <class Body>
struct Umbrella {
  using reads = Fields<>;
  using reads_i = Fields<KernelGradient<Material>, KernelGradient<Wall>>;
  using adds = std::conditional_t<std::is_same_v<Body, Material>, Fields<Covered, CoveredByMaterial>, Fields<Covered>>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const&, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const material = i[kernel_gradient<Material>];
    auto const all = (material + i[kernel_gradient<Wall>]).eval();
    sum[covered] += int(in_umbrella(ij, math::unit_vector(all)));
    if constexpr (std::is_same_v<Body, Material>)
      sum[covered_by_material] += int(in_umbrella(ij, math::unit_vector(material)));
  }
};

/// Finds Omega_F, the particles whose umbrella is empty, and Omega_W, those whose umbrella contains only wall
/// particles.
struct FindSurface {
  using reads = Fields<CellType, KernelSum<Wall>>;
  using writes = Fields<OnSurface>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    out[on_surface] = interior;
    if (i[cell_type] != 1) return;
    if (total[covered] == 0) out[on_surface] = free;
    if (total[covered] > 0 && total[covered_by_material] == 0 && sees_wall(i)) out[on_surface] = surface::wall;
  }
};

/// Pair term for the sums over the neighbours of i in Omega_F.
struct FreeSurfaceSums {
  double spacing;  ///< initial spacing of the particles, m
  using reads = Fields<Volume, OnSurface>;
  using adds = Fields<FreeNeighbours, FreeGradient>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    if (j[on_surface] != free) return;
    sum[free_gradient] += j[volume] * ij.gradW();
    // On a lattice some rows are exactly this far apart; the factor 0.9999 excludes them whatever the rounding.
    sum[free_neighbours] += int(ij.r < typename IJ::real(0.9999) * (2 * ij.h() - spacing));
  }
};

/// Finds Omega_f (4.20), Omega_w (4.21) and the normal of the free surface (4.17). The sign of the second branch of
/// (4.17) is reversed, so that both branches point into the material.
struct FindVicinity {
  using reads = Fields<CellType, OnSurface, KernelSum<Wall>, KernelGradient<Material>, KernelGradient<Wall>>;
  using writes = Fields<SurfaceSet, FreeSurfaceNormal>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    int set = i[on_surface];
    auto normal = zero<typename O::template type<FreeSurfaceNormal>>();
    if (i[cell_type] < 3) {
      if (set & free)
        normal = math::unit_vector((i[kernel_gradient<Material>] + i[kernel_gradient<Wall>]).eval());
      else if (total[free_neighbours] > 0) {
        set |= near_free;
        normal = math::unit_vector((-total[free_gradient]).eval());
      }
      if (!(set & surface::wall) && sees_wall(i)) set |= near_wall;
    }
    out[surface_set] = set;
    out[free_surface_normal] = normal;
  }
};

/// Computes the normal of the walls (4.10), which points away from the wall particles.
struct FindWallNormal {
  using reads = Fields<KernelGradient<Wall>>;
  using writes = Fields<WallNormal>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    out[wall_normal] = math::unit_vector((-i[kernel_gradient<Wall>]).eval());
  }
};

}  // namespace surface

/// Returns the passes that compute the surface sets and normals of the material.
inline auto surface_passes(Resolution const& resolution) {
  using namespace surface;
  return std::tuple(ClassifyCells{},
                    pair_pass_where<Material>("scree::kernel_sums", Outer{}, StoreSums{},
                                              over<Material>(KernelSums<Material>{}), over<Wall>(KernelSums<Wall>{})),
                    pair_pass_where<Material>("scree::umbrella", Outermost{}, FindSurface{},
                                              over<Material>(Umbrella<Material>{}), over<Wall>(Umbrella<Wall>{})),
                    pair_pass_where<Material>("scree::vicinity", Outer{}, FindVicinity{},
                                              over<Material>(FreeSurfaceSums{resolution.spacing})),
                    point_pass<Material>("scree::wall_normal", FindWallNormal{}));
}

/// Diagnostics of a formulation: the surface sets and normals of the material.
struct SurfaceDetection {
  /// Returns the passes that compute the surface sets and normals.
  auto passes(Resolution const& resolution) const { return surface_passes(resolution); }
};

}  // namespace scree

#include "instances.hpp"
