// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../neighbours/cell_list.hpp"
#include "../neighbours/skin_watch.hpp"
#include "bodies.hpp"

#include <concepts>

// The searches of a system: one per ordered pair of bodies, each updated on demand.
namespace scree {

/// A search by lists with a skin, built from a given cell list of the sources.
template <class N, class P>
concept ListsWithSkin = NeighbourSearch<N, P> &&
    requires(N search, Positions<P> x, typename CellList<P>::View const& cells) {
  { N::skin } -> std::convertible_to<double>;
  { N::reach(1.0) } -> std::convertible_to<double>;
  typename N::OfOthers;  // the same for sources other than the targets
  search.build(x, x, cells);
};

namespace detail {
/// Replaces SkinWatch for searches that are updated after each change of positions.
template <class P>
struct NoWatch {
  struct History {};
  bool may_look_rarely() const { return false; }
  History look_rarely() const { return {}; }
  void look_always() const {}
  bool outrun() const { return false; }
  void go_back(History const&) const {}
  PositionGuard<P> guard_of_first() const { return {}; }
  PositionGuard<P> guard_of_second() const { return {}; }
};
}  // namespace detail

/// Searches that are updated after each change of positions.
template <class P, class Search>
class Searches {
  static_assert(NeighbourSearch<Search, P>, "`search` of this formulation is no NeighbourSearch");

 public:
  using Now = PerBody<Places<P>>;
  explicit Searches(double radius) : slots_{{Search(radius)}, {Search(radius)}, {Search(radius)}} {}

  /// How far two particles may move before renew(), m.
  static double margin(double /*radius*/) { return 0; }
  /// Call it once after each change of positions: whether the searches are still valid.
  bool serve(Now const&) { return false; }
  /// Call it when they are not.
  void renew(Now const&) {
    slots_.material_material.current = slots_.material_wall.current = slots_.wall_material.current = false;
  }
  /// Neighbours of the target body's particles among the source body's, for these positions.
  template <BodyTag Target, BodyTag Source>
  Search const& neighbours(Now const& now) {
    auto& slot = slots_.template of<Target, Source>();
    if (!slot.current) slot.search.update(now.template of<Target>().targets(), now.template of<Source>().all);
    slot.current = true;
    return slot.search;
  }
  long builds() const { return slots_.material_material.search.builds(); }
  using Watch = detail::NoWatch<P>;
  Watch watch() const { return {}; }
  /// Whether the searches are not valid for these positions.
  bool outdated(Now const&) const { return false; }

  /// The order of neighbours depends only on the positions.
  struct Memory {};
  Memory memory() const { return {}; }
  void restore(typename P::space const&, Memory const&) { renew({}); }

 private:
  struct Slot {
    Search search;
    bool current = false;
  };
  PerPair<Slot> slots_;
};

/// Lists with a skin, valid until the displacements of any body end them: one watch over all displacements serves all
/// lists, and all lists with the same source share one cell list.
template <class P, class Search>
requires ListsWithSkin<Search, P>
class Searches<P, Search> {
 public:
  using Now = PerBody<Places<P>>;
  explicit Searches(double radius)
      : watch_(Search::skin * radius),
        cells_{{CellList<P>(Search::reach(radius))}, {CellList<P>(Search::reach(radius))}},
        lists_{{Search(radius)}, {OfOthers(radius)}, {OfOthers(radius)}} {}

  static double margin(double radius) { return Search::skin * radius; }
  bool serve(Now const& now) { return watch_.serves(now.material, now.wall); }
  void renew(Now const& now) { watch_.keep(now.material, now.wall); }

  template <BodyTag Target, BodyTag Source>
  auto const& neighbours(Now const& now) {
    auto& list = lists_.template of<Target, Source>();
    if (list.built != watch_.builds()) {
      // A list may be requested first after the others were built; it uses the same positions as they did.
      Places<P> const targets{kept<Target>(), now.template of<Target>().owned};
      list.what.build(targets.targets(), kept<Source>(), cells_of<Source>());
      list.built = watch_.builds();
    }
    return list.what;
  }
  long builds() const { return watch_.builds(); }
  using Watch = SkinWatch<P>;
  Watch& watch() { return watch_; }
  /// Whether the lists are not valid for these positions.
  bool outdated(Now const& now) const {
    double const crossed = watch_.crossed_since(now.material, now.wall);
    return crossed >= 1 && std::isfinite(crossed);  // lists are also built from positions that are not finite
  }

  /// The state that the order of neighbours depends on besides the positions.
  using Memory = typename SkinWatch<P>::Memory;
  Memory memory() const { return watch_.memory(); }
  /// Sets the searches to the state of others.
  void restore(typename P::space const& space, Memory const& memory) {
    watch_.restore(space, memory);
    cells_.material.built = cells_.wall.built = -1;
    lists_.material_material.built = lists_.material_wall.built = lists_.wall_material.built = -1;
  }

 private:
  using OfOthers = typename Search::OfOthers;
  template <class T>
  struct Built {
    T what;
    long built = -1;  // number of the build
  };
  template <BodyTag Body>
  Positions<P> kept() const {
    return std::is_same_v<Body, Material> ? watch_.first() : watch_.second();
  }
  template <BodyTag Source>
  auto cells_of() {
    auto& cells = cells_.template of<Source>();
    if (cells.built != watch_.builds()) {
      cells.what.update(kept<Source>(), kept<Source>());
      cells.built = watch_.builds();
    }
    return cells.what.view();
  }

  SkinWatch<P> watch_;
  PerBody<Built<CellList<P>>> cells_;
  PerPair<Built<Search>, Built<OfOthers>> lists_;
};

}  // namespace scree
