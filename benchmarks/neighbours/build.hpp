// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "points.hpp"

#include <scree/neighbours/verlet_list.hpp>

// Rows for the searches after particles moved: cells rebuilt, a list rebuilt, a list that is still valid.
namespace scree::bench {

template <class P, class Search>
struct Searched {
  TwoTimes<P> points;
  Search search;
  bool at_first = false;
  explicit Searched(int about) : points(about), search(points.support) { update(); }
  void update() {
    at_first = !at_first;
    update_again();
  }
  void update_again() {
    auto const& x = at_first ? points.now : points.then;
    search.update(x, x);
  }
};

/// moving: the points cross the skin between calls.
template <class P, class Search>
void add_update_row(std::string const& what, int particles, bool moving) {
  auto const name = row_name<P>(what, "library", particles);
  add_row(name, [=](benchmark::State& state) {
    auto& searched = kept(name, [&] { return Searched<P, Search>(particles); });
    // An update that measures displacements waits for the result, so nothing overlaps.
    time(state, alone, [&] { moving ? searched.update() : searched.update_again(); });
    count_particles(state, searched.points.now.size());
  });
}

/// The sorting of the particles, written by hand.
template <class P>
struct SortedByHand {
  using Real = typename P::real;
  by_hand::Array<by_hand::Quad<Real>*> x;
  by_hand::Cells<P::dim, Real> cells;
  by_hand::CsrList list;
  Real radius;  ///< of the list

  SortedByHand(int about, double reach) : SortedByHand(cloud_of<P::dim>(about, smoothing), reach) {}
  void sort_cells() { by_hand::sort(cells, x); }
  void build_list() {
    sort_cells();
    by_hand::build(list, cells, radius);
  }

 private:
  SortedByHand(Cloud<P::dim> const& cloud, double reach)
      : x("by_hand::x", cloud.points.size()),
        cells(static_cast<int>(cloud.points.size()),
              Real(cloud.spacing * std::round(std::pow(double(cloud.points.size()), 1.0 / P::dim))),
              Real(reach * cloud.support)),
        radius(Real(reach * cloud.support)) {
    auto const host = Kokkos::create_mirror_view(x);
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      for (int axis = 0; axis < P::dim; ++axis) host(i).v[axis] = Real(cloud.points[i][axis]);
    Kokkos::deep_copy(x, host);
  }
};

template <class P>
int add_build_rows() {
  for (int const particles : sizes<P>()) {
    add_update_row<P, CellList<P>>("cells", particles, true);
    add_row(row_name<P>("cells", "by_hand", particles), [=](benchmark::State& state) {
      auto& sorted = kept(row_name<P>("cells", "by_hand", particles), [&] { return SortedByHand<P>(particles, 1); });
      time(state, alone, [&] { sorted.sort_cells(); });
      count_particles(state, double(sorted.x.extent(0)));
    });
    add_update_row<P, VerletList<P>>("list", particles, true);
    add_row(row_name<P>("list", "by_hand", particles), [=](benchmark::State& state) {
      auto& sorted =
          kept(row_name<P>("list", "by_hand", particles), [&] { return SortedByHand<P>(particles, 1 + skin); });
      time(state, alone, [&] { sorted.build_list(); });
      count_particles(state, double(sorted.x.extent(0)));
      state.counters["candidates/particle"] = double(sorted.list.pairs) / double(sorted.x.extent(0));
    });
    add_update_row<P, VerletList<P>>("list_serves", particles, false);
  }
  return 0;
}

}  // namespace scree::bench
