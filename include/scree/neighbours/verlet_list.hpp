// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "cell_list.hpp"
#include "skin_watch.hpp"

namespace scree {
namespace detail {

/// Candidates of targets, one row for each.
template <class P>
struct CandidateRows {
  Kokkos::View<int*, memory_of<P>> lengths;  // of each target
  Kokkos::View<int**, Kokkos::LayoutStride, memory_of<P>> rows;

  SCREE_LOOP_FN int row_of(int target) const { return target; }
};
/// The same with rows only for targets that have candidates; apart, for a number more per thread costs occupancy.
template <class P>
struct NumberedRows {
  Kokkos::View<int*, memory_of<P>> lengths;
  Kokkos::View<int**, Kokkos::LayoutStride, memory_of<P>> rows;
  Kokkos::View<int*, memory_of<P>> numbers;
  bool numbered = false;  // few targets have a row each

  SCREE_LOOP_FN int row_of(int target) const { return numbered ? numbers(target) : target; }
};

/// Fills rows as far as there is room in them, and finds how many candidates each target has, and at most.
template <class P, class Rows>
struct FillRows {
  Positions<P> targets, sources;
  typename CellList<P>::View cells;
  Rows to;
  int room;
  typename P::real radius;
  SCREE_FN void operator()(int i, int& longest) const {
    auto const xi = targets(i);
    int const row = room > 0 ? to.row_of(i) : 0;
    int length = 0;
    cells.for_each(i, xi, [&](int j) {
      if ((xi - sources(j)).squaredNorm() >= sq(radius)) return;
      if (length < room) to.rows(row, length) = j;
      ++length;
    });
    to.lengths(i) = length;
    longest = Kokkos::max(longest, length);
  }
};

/// Numbers the targets that have candidates.
template <class P>
struct NumberRows {
  NumberedRows<P> of;
  SCREE_FN void operator()(int i, int& number, bool last) const {
    if (last) of.numbers(i) = number;
    if (of.lengths(i) > 0) ++number;
  }
};

/// What lists of a body's own particles and lists of others have in common.
template <class P, class Rows>
class ListInRows {
 public:
  static constexpr double skin = 0.1;   // fraction of the radius
  static constexpr int many = 1 << 14;  // targets

  struct View : Rows {
    template <class F>
    SCREE_LOOP_FN void for_each(int i, Vec<P::dim, typename P::real> const&, F const& f, Share share = {}) const {
      int const length = this->lengths(i), row = this->row_of(i);
      // The next entry is fetched before it is needed.
      for (int k = share.lane, j = k < length ? this->rows(row, k) : 0; k < length;) {
        int const now = j;
        k += share.lanes;
        if (k < length) j = this->rows(row, k);
        f(now);
      }
    }
  };

  explicit ListInRows(double radius) : radius_(radius), watch_(skin * radius), cells_(reach(radius)) {}

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
    reserve(view_.lengths, n);
    FillRows<P, Rows> fill{targets, sources, cells, view_, 0, typename P::real(reach(radius_))};
    auto const longest_of = [&](int room) {
      fill.to = view_;
      fill.room = room;
      int longest = 0;
      Kokkos::parallel_reduce("scree::verlet_rows", Kokkos::RangePolicy<typename P::space>(0, n), fill,
                              Kokkos::Max<int>(longest));
      return longest;
    };
    int rows = n, longest = room_;
    if constexpr (of_others) {
      view_.numbered = n >= many;
      if (view_.numbered) {
        longest = longest_of(0);
        rows = number_rows(n);
      }
    }
    do reserve_rows(n, rows, longest);
    while ((longest = longest_of(room_)) > room_);
    ++builds_;
  }

 private:
  using Indices = Kokkos::View<int*, memory_of<P>>;
  static constexpr bool of_others = std::is_same_v<Rows, NumberedRows<P>>;

  static Places<P> all_owned(Positions<P> const& x) { return {x, static_cast<int>(x.extent(0))}; }
  static void reserve(Indices& indices, int size) {
    if (static_cast<int>(indices.extent(0)) < size)
      indices = Indices(Kokkos::view_alloc("scree::verlet_list", Kokkos::WithoutInitializing), size);
  }
  int number_rows(int targets) {
    reserve(view_.numbers, targets);
    int rows = 0;
    Kokkos::parallel_scan("scree::verlet_numbers", Kokkos::RangePolicy<typename P::space>(0, targets),
                          NumberRows<P>{view_}, rows);
    return rows;
  }
  /// Room for that many rows of that length, and a little more than there was not enough of.
  void reserve_rows(int targets, int rows, int length) {
    int const before = static_cast<int>(view_.rows.extent(0));
    if (rows <= before && length <= room_) return;
    if (length > room_) room_ = length + length / 32;
    auto const number =
        static_cast<std::size_t>(rows > before && of_others ? rows + rows / 16 : std::max(rows, before));
    auto const room = static_cast<std::size_t>(room_);
    // Neighbouring threads work on neighbouring targets, or on one row.
    bool const by_rows = runs_on_host<P> || lanes_for<P>(targets) > 1;
    Kokkos::LayoutStride const layout(number, by_rows ? room : 1, room, by_rows ? 1 : number);
    view_.rows = {};
    view_.rows = decltype(view_.rows)(Kokkos::view_alloc("scree::verlet_rows", Kokkos::WithoutInitializing), layout);
  }

  double radius_;
  SkinWatch<P> watch_;
  CellList<P> cells_;
  int room_ = 0;  // candidates per target; the first build finds out how many there are
  long builds_ = 0;
  View view_;
};

}  // namespace detail

/// Stores the candidates within radius (1 + skin) of each target and keeps them until particles may have crossed the
/// skin, see SkinWatch. For sources that are others than the targets, as walls are for the material, there is a type
/// that gives rows to those targets only that have candidates, unless there are so few targets that numbering them
/// costs more than the memory.
template <class P>
struct VerletList : detail::ListInRows<P, detail::CandidateRows<P>> {
  using detail::ListInRows<P, detail::CandidateRows<P>>::ListInRows;
  using OfOthers = detail::ListInRows<P, detail::NumberedRows<P>>;
};

}  // namespace scree
