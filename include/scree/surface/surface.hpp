// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../terms/kernel_sums.hpp"

// Detection of particles at a boundary of the material: Zhu et al. (2024), section 4.2.2, after Marrone et al. (2010).
namespace scree {

/// Surface sets that a particle can belong to; a particle near a wall and near the free surface belongs to two.
namespace surface {
/// Value for a particle in none of the surface sets.
inline constexpr int interior = 0;
inline constexpr int free = 1;       ///< Omega_F: on the free surface
inline constexpr int near_free = 2;  ///< Omega_f: closer than 2h - spacing to a particle of Omega_F
inline constexpr int wall = 4;       ///< Omega_W: the outermost row towards a wall
inline constexpr int near_wall = 8;  ///< has a wall particle within its support, but is not in Omega_W
}  // namespace surface

/// The surface sets that a particle belongs to, as a sum of the constants in `surface`.
struct SurfaceSet : Integer<"surface set", "1"> {};

/// The type of the cell of a particle: 1 for a cell next to an empty cell, 2 for a cell next to one of type 1, 3 for
/// all others. Only particles of type 1 can be on a surface; only particles of types 1 and 2 can be near one.
struct CellType : Integer<"cell type", "1"> {};

/// Unit normal of the free surface, pointing into the material; zero for particles away from the free surface.
struct FreeSurfaceNormal : Vector<"free surface normal", "1"> {};

/// Unit normal of the walls, pointing into the material; zero for particles without a wall particle in their support.
struct WallNormal : Vector<"wall normal", "1"> {};

namespace fields {
inline constexpr SurfaceSet surface_set{};
inline constexpr CellType cell_type{};
inline constexpr FreeSurfaceNormal free_surface_normal{};
inline constexpr WallNormal wall_normal{};
}  // namespace fields

}  // namespace scree
