// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "all.hpp"

#include <support/candidates.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>
#include <map>
#include <string>

namespace scree::test::neighbours_tests {
namespace {

constexpr double radius = 0.1;

template <int Dim>
Points<Dim> clustered() {
  Points<Dim> points;
  for (unsigned k = 0; k < 5; ++k) {
    auto const cluster = random_points<Dim>(50, 0.2 * k, 0.2 * k + 0.07, k);
    points.insert(points.end(), cluster.begin(), cluster.end());
  }
  return points;
}

// On the corners of cells: exactly one radius apart, from the origin on.
template <int Dim>
Points<Dim> on_cell_corners() {
  auto points = fill_lattice(Box<Dim>{Vec<Dim, double>::Zero(), Vec<Dim, double>::Constant(5 * radius)}, radius);
  for (auto& x : points) x -= Vec<Dim, double>::Constant(radius / 2);
  return points;
}

template <int Dim>
Points<Dim> collinear() {
  Points<Dim> points;
  for (int k = 0; k < 60; ++k) points.push_back(Vec<Dim, double>::Unit(k % 2) * (0.013 * k));
  for (int k = 0; k < 60; ++k) points.push_back(Vec<Dim, double>::Constant(0.011 * k));
  return points;
}

template <int Dim>
Points<Dim> with_outliers() {
  auto points = random_points<Dim>(150, 0, 1, 11);
  points.push_back(Vec<Dim, double>::Constant(1e6));
  points.push_back(-1e5 * Vec<Dim, double>::Unit(0));
  return points;
}

template <int Dim>
Points<Dim> shifted(Points<Dim> points, double by) {
  for (auto& x : points) x += Vec<Dim, double>::Constant(by);
  return points;
}

template <int Dim>
std::map<std::string, Points<Dim>> point_sets() {
  return {{"random", random_points<Dim>(300, 0, 1, 1)},
          {"clustered", clustered<Dim>()},
          {"empty", {}},
          {"a single particle", {Vec<Dim, double>::Constant(0.3)}},
          {"coincident", Points<Dim>(60, Vec<Dim, double>::Constant(0.3))},
          {"collinear", collinear<Dim>()},
          {"on cell corners", on_cell_corners<Dim>()},
          {"outliers", with_outliers<Dim>()},
          {"far from the origin", shifted<Dim>(random_points<Dim>(200, 0, 1, 2), -731.3)},
          {"outside",
           {Vec<Dim, double>::Constant(1e7), Vec<Dim, double>::Constant(-1e7), 1.05 * Vec<Dim, double>::Unit(1),
            -0.05 * Vec<Dim, double>::Unit(0)}},
          {"around", random_points<Dim>(150, -0.3, 1.3, 3)}};
}

template <class P>
struct CompareWithAllPairs {
  std::string name;
  Points<P::dim> const &targets, &sources;
  template <class Search>
  void operator()() const {
    STATIC_REQUIRE(NeighbourSearch<Search, P>);
    auto const at = positions_of<P>(targets), from = positions_of<P>(sources);
    Search search(radius);
    search.update(at, from);
    INFO(name << ", a search of type " << typeid(Search).name());
    CHECK(fault_of_candidates<P>(candidates<P>(search, at), values_of(at), values_of(from), radius) == "");
  }
};

}  // namespace

TEMPLATE_LIST_TEST_CASE("a search finds the neighbours that all pairs show", "", Policies) {
  using P = TestType;
  for (auto const& [name, points] : point_sets<P::dim>())
    for_each_search(static_cast<Searches<P>*>(nullptr), CompareWithAllPairs<P>{name, points, points});
}

TEMPLATE_LIST_TEST_CASE("targets of a search may be other particles than its sources", "", Policies) {
  using P = TestType;
  auto const sets = point_sets<P::dim>();
  for (auto const& [name, points] : sets)
    for (auto const* targets : {"around", "outside", "empty", "on cell corners"})
      for_each_search(static_cast<Searches<P>*>(nullptr),
                      CompareWithAllPairs<P>{std::string(targets) + " among " + name, sets.at(targets), points});
}

namespace {
template <class P>
struct CompareAfterChange {
  template <class Search>
  void operator()() const {
    Search search(radius);
    for (int const count : {50, 0, 200, 120, 1}) {
      auto const x = positions_of<P>(random_points<P::dim>(count, 0, 0.5, static_cast<unsigned>(count)));
      search.update(x, x);
      INFO(count << " particles");
      CHECK(fault_of_candidates<P>(candidates<P>(search, x), values_of(x), values_of(x), radius) == "");
    }
  }
};
}  // namespace

TEMPLATE_LIST_TEST_CASE("a search may be updated with another number of particles", "", Policies) {
  for_each_search(static_cast<Searches<TestType>*>(nullptr), CompareAfterChange<TestType>{});
}

namespace {
template <class P>
struct RefuseNotFinite {
  double bad;
  template <class Search>
  void operator()() const {
    auto points = random_points<P::dim>(30, 0, 1, 4);
    auto const good = positions_of<P>(points);
    points[17][1] = bad;
    auto const x = positions_of<P>(points);
    std::string message;
    auto const update = [&](Search& search) {
      message.clear();
      try {
        search.update(x, x);
      } catch (std::runtime_error const& error) {
        message = error.what();
      }
    };
    std::string const expected =
        "scree: 1 coordinates of 30 particles are not finite; the first is number 17 in memory, at (";
    std::string const its_value = detail::short_text(bad);
    auto const names_the_place = [&] {
      return message.compare(0, expected.size(), expected) == 0 &&
             message.find(", " + its_value, expected.size()) != std::string::npos;
    };
    Search fresh(radius), used(radius);
    update(fresh);
    CAPTURE(message);
    CHECK(names_the_place());
    used.update(good, good);
    update(used);
    CAPTURE(message);
    CHECK(names_the_place());
  }
};
}  // namespace

TEMPLATE_LIST_TEST_CASE("a position that is not finite stops a search with a message", "", Policies) {
  for (double const bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()})
    for_each_search(static_cast<BuiltSearches<TestType>*>(nullptr), RefuseNotFinite<TestType>{bad});
}

namespace {
template <class P>
struct SameOrder {
  template <class Search>
  void operator()() const {
    auto const points = clustered<P::dim>();
    auto const x = positions_of<P>(points);
    std::vector<std::vector<int>> first;
    for (int repetition = 0; repetition < 5; ++repetition) {
      Search search(radius);
      search.update(x, x);
      auto const again = candidates<P>(search, x);
      if (repetition == 0) first = again;
      CHECK(again == first);
    }
  }
};
#ifdef KOKKOS_ENABLE_SERIAL
// The order must be that of one thread, for any number of threads of the backend (ctest runs the tests with two).
template <class P, class Search>
std::vector<std::vector<int>> order() {
  auto const x = positions_of<P>(clustered<P::dim>());
  Search search(radius);
  search.update(x, x);
  return candidates<P>(search, x);
}
#endif
}  // namespace

TEMPLATE_LIST_TEST_CASE("the order of candidates depends on the positions only", "", Policies) {
  using P = TestType;
  for_each_search(static_cast<Searches<P>*>(nullptr), SameOrder<P>{});
#ifdef KOKKOS_ENABLE_SERIAL
  using OneThread = OnSpace<P, Kokkos::Serial>;
  CHECK(order<P, CellList<P>>() == order<OneThread, CellList<OneThread>>());
  CHECK(order<P, VerletList<P>>() == order<OneThread, VerletList<OneThread>>());
#endif
}

namespace {
template <class P>
struct ManyInOnePlace {
  template <class Search>
  void operator()() const {
    Points<P::dim> points(1000, Vec<P::dim, double>::Constant(0.25));
    auto const others = random_points<P::dim>(100, 0, 1, 5);
    points.insert(points.end(), others.begin(), others.end());
    auto const x = positions_of<P>(points);
    Search search(radius);
    search.update(x, x);
    auto const found = candidates<P>(search, x);
    CHECK(found[0].size() >= 1000);
    CHECK(fault_of_candidates<P>(found, values_of(x), values_of(x), radius) == "");
  }
};
}  // namespace

TEMPLATE_LIST_TEST_CASE("a thousand particles in one place are all found", "", Policies) {
  for_each_search(static_cast<Searches<TestType>*>(nullptr), ManyInOnePlace<TestType>{});
}

}  // namespace scree::test::neighbours_tests
