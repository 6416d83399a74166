// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cell_list.hpp"
#include "skin_watch.hpp"

namespace scree {
namespace detail {

/// rows(i, k): the k-th candidate of target i.
template <class P>
using Rows = Kokkos::View<int**, Kokkos::LayoutStride, memory_of<P>>;

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

/// Stores the candidates within radius (1 + skin) of each target and keeps them until particles may have crossed the
/// skin, see SkinWatch.
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

  explicit VerletList(double radius) : radius_(radius), watch_(skin * radius), cells_(reach(radius)) {}

  void update(Positions<P> const& targets, Positions<P> const& sources) {
    bool const same = targets.data() == sources.data() && targets.extent(0) == sources.extent(0);
    Places<P> const first = all_owned(targets), second = same ? Places<P>() : all_owned(sources);
    if (watch_.serves(first, second)) return;
    watch_.keep(first, second);
    cells_.update(targets, sources);
    build(targets, sources, cells_.view());
  }
  /// To be called before an update if particles may have changed places in the arrays or jumped since the last.
  void look_at_displacements() { watch_.look(); }
  View view() const { return view_; }
  long builds() const { return builds_; }

  /// For lists of several bodies that are built together: the radius of the cells, m,
  static double reach(double radius) { return (1 + skin) * radius; }
  /// and a build that leaves it to the caller to know how long it serves.
  void build(Positions<P> const& targets, Positions<P> const& sources, typename CellList<P>::View const& cells) {
    int const n = static_cast<int>(targets.extent(0));
    if (static_cast<int>(view_.lengths.extent(0)) < n) {
      view_.lengths = decltype(view_.lengths)("scree::verlet_lengths", n);
      allocate_rows();
    }
    for (int longest = 0;; allocate_rows()) {
      Kokkos::parallel_reduce(
          "scree::verlet_rows", Kokkos::RangePolicy<typename P::space>(0, n),
          detail::FillRows<P>{targets, sources, cells, view_.lengths, view_.rows, typename P::real(reach(radius_))},
          Kokkos::Max<int>(longest));
      if (longest <= room_) break;
      room_ = longest + longest / 8;
    }
    ++builds_;
  }

 private:
  static Places<P> all_owned(Positions<P> const& x) { return {x, static_cast<int>(x.extent(0))}; }
  void allocate_rows() {
    auto const n = view_.lengths.extent(0), room = static_cast<std::size_t>(room_);
    // Neighbouring threads work on neighbouring targets, or on one row.
    bool const by_rows = runs_on_host<P> || lanes_for<P>(static_cast<int>(n)) > 1;
    Kokkos::LayoutStride const layout(n, by_rows ? room : 1, room, by_rows ? 1 : n);
    view_.rows = detail::Rows<P>();
    view_.rows = detail::Rows<P>(Kokkos::view_alloc("scree::verlet_rows", Kokkos::WithoutInitializing), layout);
  }

  double radius_;
  SkinWatch<P> watch_;
  CellList<P> cells_;
  int room_ = 0;  // candidates per target; the first build finds out how many there are
  long builds_ = 0;
  View view_;
};

}  // namespace scree
