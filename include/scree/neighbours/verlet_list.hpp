// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cell_list.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree {
namespace detail {

/// rows(i, k): the k-th candidate of target i.
template <class P>
using Rows = Kokkos::View<int**, Kokkos::LayoutStride, memory_of<P>>;

template <class P>
struct LargestDisplacement {
  Positions<P> now, then;
  SCREE_FN void operator()(int i, typename P::real& largest) const {
    auto const squared = (now(i) - then(i)).squaredNorm();
    // A maximum passes over a NaN.
    constexpr auto infinity = Kokkos::Experimental::infinity_v<typename P::real>;
    largest = Kokkos::max(largest, squared >= 0 ? squared : +infinity);
  }
};

template <class P>
struct FillRows {
  Positions<P> targets, sources;
  typename CellList<P>::View cells;
  Kokkos::View<int*, memory_of<P>> lengths;
  Rows<P> rows;
  typename P::real radius;
  SCREE_FN void operator()(int i, int& longest) const {
    auto const xi = targets(i);
    int const room = static_cast<int>(rows.extent(1));
    int length = 0;
    cells.for_each(i, xi, [&](int j) {
      if ((xi - sources(j)).squaredNorm() >= sq(radius)) return;
      if (length < room) rows(i, length) = j;
      ++length;
    });
    lengths(i) = length;
    longest = Kokkos::max(longest, length);
  }
};

}  // namespace detail

/// Stores the candidates within radius (1 + skin) of each target and keeps them until the particles may have crossed
/// the skin: twice the largest displacement since the list was built. Displacements are looked at as often as needed to
/// see that in time, as long as particles speed up no faster than from rest under a constant acceleration since the
/// look before the last; particles at rest are looked at after 64 updates.
template <class P>
class VerletList {
 public:
  static constexpr double skin = 0.1;  // fraction of the radius

  struct View {
    Kokkos::View<int*, memory_of<P>> lengths;
    detail::Rows<P> rows;
    template <class F>
    SCREE_LOOP_FN void for_each(int i, Vec<P::dim, typename P::real> const&, F const& f, Share share = {}) const {
      int const length = lengths(i);
      // The next entry is fetched before it is needed.
      for (int k = share.lane, j = k < length ? rows(i, k) : 0; k < length;) {
        int const now = j;
        k += share.lanes;
        if (k < length) j = rows(i, k);
        f(now);
      }
    }
  };

  explicit VerletList(double radius) : radius_(radius), cells_((1 + skin) * radius) {}

  void update(Positions<P> const& targets, Positions<P> const& sources) {
    ++updates_;
    if (!serves(targets, sources)) build(targets, sources);
  }
  /// To be called before an update if particles may have changed places in the arrays or jumped since the last.
  void look_at_displacements() { next_look_ = 0; }
  View view() const { return view_; }
  long builds() const { return builds_; }

  /// What the list and its lifetime follow from: the positions of its last build. A list built anew from the present
  /// ones has another order of neighbours, so a run that goes on from a snapshot needs these.
  struct BuiltFrom {
    std::vector<Vec<P::dim, typename P::real>> targets, sources;
    long builds = 0;
  };
  BuiltFrom built_from() const { return {on_host(targets_), on_host(sources_), builds_}; }
  /// Brings the list to the state of the one whose built_from() this is. Throws if a position is not finite.
  void rebuild_from(BuiltFrom const& memory) {
    Kept const targets = on_device(memory.targets), sources = on_device(memory.sources);
    if (memory.builds > 0) {
      build(targets, sources);
      next_look_ = 1;
    } else {
      targets_ = targets;
      sources_ = sources;
    }
    builds_ = memory.builds;
  }

 private:
  using Kept = Kokkos::View<Vec<P::dim, typename P::real>*, memory_of<P>>;

  template <class X>
  using OnHost = Kokkos::View<X*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  static auto on_host(Kept const& kept) {
    std::vector<Vec<P::dim, typename P::real>> values(kept.extent(0));
    Kokkos::deep_copy(OnHost<Vec<P::dim, typename P::real>>(values.data(), values.size()), kept);
    return values;
  }
  static Kept on_device(std::vector<Vec<P::dim, typename P::real>> const& values) {
    Kept const kept(Kokkos::view_alloc("scree::verlet_positions", Kokkos::WithoutInitializing), values.size());
    Kokkos::deep_copy(kept, OnHost<Vec<P::dim, typename P::real> const>(values.data(), values.size()));
    return kept;
  }

  static double displacement(Positions<P> const& now, Positions<P> const& then) {
    typename P::real squared = 0;
    Kokkos::parallel_reduce("scree::displacement",
                            Kokkos::RangePolicy<typename P::space>(0, static_cast<int>(now.extent(0))),
                            detail::LargestDisplacement<P>{now, then}, Kokkos::Max<typename P::real>(squared));
    return std::sqrt(double(squared));
  }
  bool serves(Positions<P> const& targets, Positions<P> const& sources) {
    if (builds_ == 0 || targets.extent(0) != targets_.extent(0) || sources.extent(0) != sources_.extent(0))
      return false;
    if (updates_ < next_look_) return true;
    double const moved = displacement(targets, targets_);
    bool const same = targets.data() == sources.data() && targets.extent(0) == sources.extent(0);
    double const crossed = (moved + (same ? moved : displacement(sources, sources_))) / (skin * radius_);
    plan_next_look(crossed);
    // What is not finite must lead to a build, which reports it.
    return crossed < 1;
  }
  // `crossed`, which is 1 where the list ends, has grown by g over the last n updates. From rest at their beginning
  // that is (k/n)^2 g after k updates, so that it comes to 1 after k = n sqrt(1 + (1 - crossed)/g).
  void plan_next_look(double crossed) {
    double const n = double(updates_ - last_look_), growth = crossed - crossed_before_;
    double const updates = n * (std::sqrt(1 + (1 - crossed) / growth) - 1);
    last_look_ = updates_;
    crossed_before_ = crossed;
    next_look_ = updates_ + (updates >= 1 ? static_cast<long>(std::min({updates, 2 * n, 64.0})) : 1);
  }
  void build(Positions<P> const& targets, Positions<P> const& sources) {
    keep(targets_, targets);
    keep(sources_, sources);
    cells_.update(targets, sources);
    int const n = static_cast<int>(targets.extent(0));
    if (static_cast<int>(view_.lengths.extent(0)) < n) {
      view_.lengths = decltype(view_.lengths)("scree::verlet_lengths", n);
      allocate_rows();
    }
    for (int longest = 0;; allocate_rows()) {
      Kokkos::parallel_reduce("scree::verlet_rows", Kokkos::RangePolicy<typename P::space>(0, n),
                              detail::FillRows<P>{targets, sources, cells_.view(), view_.lengths, view_.rows,
                                                  typename P::real((1 + skin) * radius_)},
                              Kokkos::Max<int>(longest));
      if (longest <= room_) break;
      room_ = longest + longest / 8;
    }
    ++builds_;
    // Rarely is a list far shorter-lived than the one before.
    next_look_ = std::clamp(updates_ / 4, 1L, 64L);
    updates_ = last_look_ = 0;
    crossed_before_ = 0;
  }
  void allocate_rows() {
    auto const n = view_.lengths.extent(0), room = static_cast<std::size_t>(room_);
    // Neighbouring threads work on neighbouring targets, or on one row.
    bool const by_rows = runs_on_host<P> || lanes_for<P>(static_cast<int>(n)) > 1;
    Kokkos::LayoutStride const layout(n, by_rows ? room : 1, room, by_rows ? 1 : n);
    view_.rows = detail::Rows<P>();
    view_.rows = detail::Rows<P>(Kokkos::view_alloc("scree::verlet_rows", Kokkos::WithoutInitializing), layout);
  }
  static void keep(Kept& kept, Positions<P> const& x) {
    if (kept.extent(0) != x.extent(0))
      kept = Kept(Kokkos::view_alloc("scree::verlet_positions", Kokkos::WithoutInitializing), x.extent(0));
    Kokkos::deep_copy(kept, x);
  }

  double radius_;
  CellList<P> cells_;
  Kept targets_, sources_;
  int room_ = 0;  // candidates per target; the first build finds out how many there are
  long builds_ = 0;
  long updates_ = 0, last_look_ = 0, next_look_ = 1;  // counted from the last build
  double crossed_before_ = 0;                         // at the last look
  View view_;
};

}  // namespace scree
