// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../neighbours/cell_list.hpp"
#include "../neighbours/skin_watch.hpp"

#include <cmath>
#include <concepts>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

// The searches of a system: one for each ordered pair of interacting bodies, made on the first request. Bodies are
// identified by their numbers.
namespace scree {

/// Whether N is a search by lists with a skin, built from a given cell list of the sources.
template <class N, class P>
concept ListsWithSkin = NeighbourSearch<N, P> &&
    requires(N search, Positions<P> x, typename CellList<P>::View const& cells) {
  { N::skin } -> std::convertible_to<double>;
  { N::reach(1.0) } -> std::convertible_to<double>;
  typename N::OfOthers;  // the lists for sources other than the targets
  search.build(x, x, cells);
};

namespace detail {
template <class Search>
concept HasSkin = requires {
  Search::skin;
};
/// Whether a search is complete; otherwise the compiler reports each missing part.
template <class Search, class P>
constexpr bool explain_search() {
  constexpr bool searches = NeighbourSearch<Search, P>, is_whole = !HasSkin<Search> || ListsWithSkin<Search, P>;
  static_assert(searches,
                "`search` is not a NeighbourSearch: it needs a constructor from a radius, update(targets, sources), "
                "builds() and view(), which has for_each(i, x_i, f, range)");
  static_assert(
      !searches || is_whole,
      "`search` has a skin but is not ListsWithSkin: it also needs reach(radius), OfOthers and build(targets, "
      "sources, cells), or its lists would be built again after each change of positions");
  return searches && is_whole;
}

/// The cell lists from which neighbour lists are built.
template <class P, class Search>
struct cells_of {
  using type = CellList<P>;
};
template <class P, class Search>
requires requires { typename Search::Cells; }
struct cells_of<P, Search> {
  using type = typename Search::Cells;
};
/// A substitute for SkinWatch for searches that are updated after each change of positions.
template <class P>
struct NoWatch {
  struct History {};
  bool looks_now() const { return false; }
  double crossed(std::vector<Places<P>> const&) const { return 1; }
  bool serves(double) const { return false; }
  bool may_look_rarely() const { return false; }
  History look_rarely() const { return {}; }
  void look_always() const {}
  bool outrun() const { return false; }
  void go_back(History const&) const {}
  PositionGuard<P> guard(std::size_t) const { return {}; }
};
}  // namespace detail

/// Searches that are updated after each change of positions.
template <class P, class Search>
class Searches {
 public:
  using Now = std::vector<Places<P>> const&;  // positions of each body
  using OfOthers = Search;
  /// Makes searches among a number of bodies within a radius, m.
  Searches(double radius, std::size_t bodies) : radius_(radius), bodies_(bodies), slots_(bodies * bodies) {
    detail::explain_search<Search, P>();
  }

  /// Returns the distance that two particles together may move before renew() is needed, m.
  static double margin(double /*radius*/) { return 0; }
  /// Marks all searches as outdated. Call this when the searches are not valid for the present positions.
  void renew(Now) {
    for (auto& slot : slots_) slot.current = false;
  }
  /// Extends the frames of grids with `join(frames)`. There are none.
  template <class Join>
  void join_frames(Join const&) const {}
  /// Returns the neighbours of the particles of a body in the same body, for these positions.
  Search const& within(std::size_t body, Now now) { return among(body, body, now); }
  /// Returns the neighbours of the particles of the target body in the source body, for these positions.
  OfOthers const& among(std::size_t target, std::size_t source, Now now) {
    auto& slot = slots_[target * bodies_ + source];
    if (!slot.search) slot.search = std::make_unique<Search>(radius_);
    if (!slot.current) slot.search->update(now[target].targets(), now[source].all);
    slot.current = true;
    return *slot.search;
  }
  /// Returns the number of builds of the search for neighbours of the first body in itself.
  long builds() const { return slots_[0].search ? slots_[0].search->builds() : 0; }
  using Watch = detail::NoWatch<P>;
  /// Returns an empty watch, because no lists outlive a change of positions.
  Watch watch() const { return {}; }
  /// Whether the searches are not valid for these positions.
  bool outdated(Now) const { return false; }

  /// The state that, in addition to the positions, determines the order of neighbours; here it is empty.
  struct Memory {
    /// Makes the state for a number of bodies.
    explicit Memory(std::size_t /*bodies*/) {}
  };
  /// Returns an empty state.
  Memory memory() const { return Memory(bodies_); }
  /// Restores the state from memory(). The state is empty, so the next request updates the search.
  void restore(typename P::space const&, Memory const&) { renew({}); }

 private:
  struct Slot {
    std::unique_ptr<Search> search;
    bool current = false;
  };
  double radius_;
  std::size_t bodies_;
  std::vector<Slot> slots_;  // for each pair of target and source
};

/// Lists with a skin, which are valid until particles of any body have moved too far. All lists share one watch over
/// the displacements of all bodies, and all lists with the same source share one cell list.
template <class P, class Search>
requires ListsWithSkin<Search, P>
class Searches<P, Search> {
 public:
  using Watch = SkinWatch<P>;
  using Now = typename Watch::Now;
  using OfOthers = typename Search::OfOthers;
  Searches(double radius, std::size_t bodies)
      : radius_(radius),
        watch_(Search::skin * radius, bodies),
        frames_(bodies),
        of_(bodies),
        others_(bodies * bodies) {}

  static double margin(double radius) { return Search::skin * radius; }
  void renew(Now now) {
    watch_.keep(now);
    find_frames(now);
  }
  /// Extends the frames of grids around the particles of each body: `join(frames)`. Call it after renew() and
  /// restore().
  template <class Join>
  void join_frames(Join const& join) {
    join(frames_);
  }

  Search const& within(std::size_t body, Now now) { return up_to_date(of_[body].own, now, body, body); }
  OfOthers const& among(std::size_t target, std::size_t source, Now now) {
    return up_to_date(others_[target * of_.size() + source], now, target, source);
  }
  long builds() const { return watch_.builds(); }
  Watch& watch() { return watch_; }
  /// Whether the lists are not valid for these positions.
  bool outdated(Now now) const {
    double const crossed = watch_.crossed_since(now);
    return crossed >= 1 && std::isfinite(crossed);  // lists are also built from positions that are not finite
  }

  /// The state that, in addition to the positions, determines the order of neighbours.
  using Memory = typename Watch::Memory;
  Memory memory() const { return watch_.memory(); }
  /// Restores the state of the searches from memory().
  void restore(typename P::space const& space, Memory const& memory) {
    watch_.restore(space, memory);
    std::vector<Places<P>> kept(of_.size());
    for (std::size_t body = 0; body < kept.size(); ++body) kept[body] = {watch_.kept(body), memory.owned[body]};
    if (memory.builds > 0) find_frames(kept);
    for (auto& each : of_) each.cells.built = each.own.built = -1;
    for (auto& each : others_) each.built = -1;
  }

 private:
  using Cells = typename detail::cells_of<P, Search>::type;
  static constexpr bool framed = std::is_same_v<Cells, CellList<P, ByPosition>>;
  template <class T>
  struct Built {
    std::unique_ptr<T> what;
    long built = -1;  // number of the build that it belongs to
  };
  struct OfBody {
    Built<Cells> cells;
    Built<Search> own;
  };
  void find_frames([[maybe_unused]] Now now) {
    if constexpr (framed)
      for (std::size_t body = 0; body < frames_.size(); ++body) frames_[body] = frame_of<P>(now[body].targets());
  }
  template <class List>
  List const& up_to_date(Built<List>& list, Now now, std::size_t target, std::size_t source) {
    if (!list.what) list.what = std::make_unique<List>(radius_);
    if (list.built != watch_.builds()) {
      // A list that is first requested after the others were built uses the same positions as the others.
      Places<P> const targets{watch_.kept(target), now[target].owned};
      list.what->build(targets.targets(), watch_.kept(source), cells_of(source));
      list.built = watch_.builds();
    }
    return *list.what;
  }
  auto cells_of(std::size_t source) {
    auto& cells = of_[source].cells;
    if (!cells.what) cells.what = std::make_unique<Cells>(Search::reach(radius_));
    if (cells.built != watch_.builds()) {
      if constexpr (framed)
        cells.what->update_in(frames_[source], watch_.kept(source));
      else
        cells.what->update(watch_.kept(source), watch_.kept(source));
      cells.built = watch_.builds();
    }
    return cells.what->view();
  }

  double radius_;
  Watch watch_;
  std::vector<Frame<P::dim>> frames_;  // frame of the owned particles of each body
  std::vector<OfBody> of_;
  std::vector<Built<OfOthers>> others_;  // for each pair of target and source
};

}  // namespace scree
