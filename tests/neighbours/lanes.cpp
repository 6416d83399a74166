// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "all.hpp"

#include <support/bodies.hpp>
#include <support/candidates.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::lanes_tests {

/// Sums the candidates of each target, all at once and lane by lane, with weights that distinguish them.
template <class P, class View>
struct AddByLanes {
  View view;
  PositionSpan<P> x;
  Span<long> whole, by_lanes, largest;
  int lanes;
  SCREE_FN void operator()(int i) const {
    long all = 0, parts = 0, most = 0;
    view.for_each(i, x(i), [&](int j) { all += sq(j + 1L); });
    for (int lane = 0; lane < lanes; ++lane) {
      long part = 0;
      view.for_each(
          i, x(i), [&](int j) { part += sq(j + 1L); }, LaneRange{lane, lanes});
      parts += part;
      if (part > most) most = part;
    }
    whole(i) = all, by_lanes(i) = parts, largest(i) = most;
  }
};

namespace {
template <class P>
struct CompareLanes {
  template <class Search>
  void operator()() const {
    constexpr int n = 300;
    auto const x = positions_of<P>(random_points<P::dim>(n, 0, 0.5, 1));
    Search search(0.2);
    search.update(x, x);
    using Longs = Array<P, long>;
    Longs const whole(x.space(), "whole", n), by_lanes(x.space(), "by lanes", n), largest(x.space(), "largest", n);
    for (int const lanes : {1, 2, 8}) {
      using View = decltype(search.view());
      for_each_index(x.space(), "scree::test::lanes", 0, n,
                     AddByLanes<P, View>{search.view(), x, whole, by_lanes, largest, lanes});
      CHECK(values_of(whole) == values_of(by_lanes));
      CHECK((values_of(largest) == values_of(whole)) == (lanes == 1));
    }
  }
};
}  // namespace

TEMPLATE_LIST_TEST_CASE("the lanes of a target together visit each neighbour once", "", Policies) {
  for_each_search(static_cast<Searches<TestType>*>(nullptr), CompareLanes<TestType>{});
}

TEMPLATE_LIST_TEST_CASE("few targets have several lanes on a GPU, many have one, in three dimensions four", "",
                        Policies) {
  using P = TestType;
  CHECK(lanes_for<P>(5000) == (runs_on_host<P> ? 1 : 8));
  CHECK(lanes_for<P>(50000) == (runs_on_host<P> ? 1 : 4));
  CHECK(lanes_for<P>(1000000) == (runs_on_host<P> || P::dim == 2 ? 1 : 4));
  CHECK(lanes_for<P>(0) == (runs_on_host<P> ? 1 : 8));
}

}  // namespace scree::test::lanes_tests
