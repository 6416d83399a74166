// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "build.hpp"

#include <scree/neighbours/brute_force.hpp>

// Rows of a walk over all candidates that counts those within the support, by each search and by hand.
namespace scree::bench {

template <class P, class View>
struct CountWithin {
  PositionSpan<P> x;
  View search;
  typename P::real squared_radius;
  Span<int> counts;
  SCREE_FN void operator()(int i) const {
    auto const xi = x(i);
    int count = 0;
    search.for_each(i, xi, [&](int j) { count += (xi - x(j)).squaredNorm() < squared_radius; });
    counts(i) = count - 1;  // not the particle itself
  }
};

inline double sum_of(by_hand::Array<int*> const& counts) {
  double sum = 0;
  Kokkos::parallel_reduce(
      "scree::bench::sum", Kokkos::RangePolicy<Space>(0, static_cast<int>(counts.extent(0))),
      KOKKOS_LAMBDA(int i, double& part) { part += counts(i); }, sum);
  return sum;
}

template <class P, class Search>
void add_walk_row(std::string const& what, int particles) {
  auto const name = row_name<P>(what, "library", particles);
  add_row(name, [=](benchmark::State& state) {
    auto& searched = kept(name, [&] { return Searched<P, Search>(particles); });
    auto const& points = searched.points;
    int const n = points.now.size();
    by_hand::Array<int*> const counts("scree::bench::counts", n);
    CountWithin<P, decltype(searched.search.view())> const walk{
        points.now, searched.search.view(), typename P::real(sq(points.support)), {counts.data(), n}};
    time(state, together, [&] { for_each_index(typename P::space(), "scree::bench::walk", 0, n, walk); });
    count_pairs(state, n, sum_of(counts));
  });
}

/// Over ranges of sorted positions; ready for use, without the time of sorting.
template <class P>
void add_walk_by_hand_row(int particles) {
  auto const name = row_name<P>("walk_cells", "by_hand", particles);
  add_row(name, [=](benchmark::State& state) {
    auto& sorted = kept(name, [&] {
      SortedByHand<P> made(particles, 1);
      made.sort_cells();
      return made;
    });
    int const n = static_cast<int>(sorted.x.extent(0));
    by_hand::Array<int*> const counts("scree::bench::counts", n);
    time(state, together, [&] { by_hand::count(sorted.cells, sorted.radius, counts); });
    count_pairs(state, n, sum_of(counts));
  });
}

template <class P>
int add_walk_rows() {
  for (int const particles : sizes<P>()) {
    add_walk_row<P, CellList<P>>("walk_cells", particles);
    add_walk_by_hand_row<P>(particles);
    add_walk_row<P, VerletList<P>>("walk_list", particles);
  }
  add_walk_row<P, BruteForce<P>>("walk_all", small_sizes().front());
  return 0;
}

}  // namespace scree::bench
