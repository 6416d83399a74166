// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/periodic.hpp"
#include "../kernels/kernel.hpp"
#include "../neighbours/neighbours.hpp"

#include <type_traits>
#include <vector>

namespace scree {

/// The bodies of a simulation, as tags.
struct Material {};
struct Wall {};
template <class B>
concept BodyTag = std::is_same_v<B, Material> || std::is_same_v<B, Wall>;

namespace detail {
/// One search per ordered pair of bodies, brought up to date when it is asked for.
template <class Target, class SourceBody, class Search>
struct SearchSlot {
  Search search;
  bool current = false;
};
}  // namespace detail

/// Particles of all bodies with their kernel, neighbours and periodic images: what passes work on.
template <class P, class Search, class MaterialFields, class WallFields>
class System {
 public:
  using policy = P;
  static_assert(NeighbourSearch<Search, P>, "`search` of this formulation is no NeighbourSearch");

  System(double smoothing_length, std::vector<Period> periods)
      : kernel_(smoothing_length),
        material_images_(periods, kernel_.radius()),
        wall_images_(std::move(periods), kernel_.radius()),
        material_material_{Search(kernel_.radius())},
        material_wall_{Search(kernel_.radius())},
        wall_material_{Search(kernel_.radius())} {}

  kernel_of<P> const& kernel() const { return kernel_; }

  template <class Body>
  auto& body() {
    if constexpr (std::is_same_v<Body, Material>)
      return material_;
    else
      return wall_;
  }
  template <class Body>
  auto const& body() const {
    return const_cast<System*>(this)->template body<Body>();
  }

  /// Neighbours of the target body's particles among the source body's, for the present positions.
  template <class Target, class SourceBody>
  Search const& neighbours() {
    auto& slot = slot_of<Target, SourceBody>();
    if (!slot.current) {
      // Periodic images are made anew, and particles that leave a period jump.
      if constexpr (requires { slot.search.look_at_displacements(); })
        if (material_images_.any()) slot.search.look_at_displacements();
      auto const targets = body<Target>()[position];
      auto const owned = Kokkos::subview(targets, Kokkos::pair<int, int>(0, body<Target>().size()));
      slot.search.update(owned, body<SourceBody>()[position]);
      slot.current = true;
    }
    return slot.search;
  }
  /// Calls visit(name, search) for each pair of bodies, "material-wall" for targets in the material: for snapshots.
  template <class Visit>
  void for_each_search(Visit const& visit) {
    visit("material-material", material_material_.search);
    visit("material-wall", material_wall_.search);
    visit("wall-material", wall_material_.search);
  }
  template <class Visit>
  void for_each_search(Visit const& visit) const {
    visit("material-material", material_material_.search);
    visit("material-wall", material_wall_.search);
    visit("wall-material", wall_material_.search);
  }
  long neighbour_builds() const { return material_material_.search.builds(); }

  /// To be called after positions changed.
  void positions_changed() {
    material_images_.create(material_);
    wall_images_.create(wall_);
    material_material_.current = material_wall_.current = wall_material_.current = false;
  }
  /// To be called at the beginning of a step.
  void wrap_periods() {
    if (!material_images_.any()) return;
    material_images_.wrap(material_);
    wall_images_.wrap(wall_);
    positions_changed();
  }
  template <class Body, class List>
  void refresh_ghosts(List fields) {
    if constexpr (std::is_same_v<Body, Material>)
      material_images_.refresh(material_, fields);
    else
      wall_images_.refresh(wall_, fields);
  }

 private:
  template <class Target, class SourceBody>
  auto& slot_of() {
    if constexpr (std::is_same_v<Target, Wall>) {
      static_assert(std::is_same_v<SourceBody, Material>, "walls do not interact with walls");
      return wall_material_;
    } else if constexpr (std::is_same_v<SourceBody, Wall>) {
      return material_wall_;
    } else {
      return material_material_;
    }
  }

  kernel_of<P> kernel_;
  Particles<P, MaterialFields> material_;
  Particles<P, WallFields> wall_;
  PeriodicImages<P> material_images_, wall_images_;
  detail::SearchSlot<Material, Material, Search> material_material_;
  detail::SearchSlot<Material, Wall, Search> material_wall_;
  detail::SearchSlot<Wall, Material, Search> wall_material_;
};

}  // namespace scree
