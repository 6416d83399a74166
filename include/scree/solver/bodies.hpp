// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <type_traits>

namespace scree {

/// The bodies of a simulation, as tags.
struct Material {};
struct Wall {};
template <class B>
concept BodyTag = std::is_same_v<B, Material> || std::is_same_v<B, Wall>;
/// A list of bodies.
template <BodyTag... Bs>
struct Bodies {};

namespace detail {
/// A body of a solver.
template <BodyTag Tag, class S>
auto const& body_of(S const& solver) {
  if constexpr (std::is_same_v<Tag, Material>)
    return solver.material();
  else
    return solver.wall();
}
}  // namespace detail

/// One object per body.
template <class OfMaterial, class OfWall = OfMaterial>
struct PerBody {
  OfMaterial material;
  OfWall wall;
  template <BodyTag Body>
  auto& of() {
    if constexpr (std::is_same_v<Body, Material>)
      return material;
    else
      return wall;
  }
  template <BodyTag Body>
  auto const& of() const {
    return const_cast<PerBody*>(this)->template of<Body>();
  }
};

/// One object per ordered pair of bodies that interact.
template <class Own, class OfOthers = Own>
struct PerPair {
  Own material_material;
  OfOthers material_wall, wall_material;
  template <BodyTag Target, BodyTag Source>
  auto& of() {
    if constexpr (std::is_same_v<Target, Wall>) {
      static_assert(std::is_same_v<Source, Material>, "walls do not interact with walls");
      return wall_material;
    } else if constexpr (std::is_same_v<Source, Wall>) {
      return material_wall;
    } else {
      return material_material;
    }
  }
};

}  // namespace scree
