// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/neighbours/verlet_list.hpp>

#include <support/candidates.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::verlet_list_tests {
namespace {

constexpr double radius = 0.1;

// Every point moved by the same distance, in random directions.
template <int Dim>
Points<Dim> moved(Points<Dim> points, double distance, unsigned seed) {
  auto directions = random_points<Dim>(static_cast<int>(points.size()), -1, 1, seed);
  for (std::size_t k = 0; k < points.size(); ++k) points[k] += distance * directions[k].normalized();
  return points;
}

template <class P, class Search>
std::string fault(Search const& search, Positions<P> const& targets, Positions<P> const& sources) {
  return fault_of_candidates<P>(candidates<P>(search, targets), values_of(targets), values_of(sources), radius);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("a Verlet list is kept until particles may have crossed the skin", "", Policies) {
  using P = TestType;
  auto const points = random_points<P::dim>(400, 0, 0.8, 1);
  auto const x = positions_of<P>(points);
  VerletList<P> list(radius);
  CHECK(list.builds() == 0);
  list.update(x, x);
  list.update(x, x);
  CHECK(list.builds() == 1);
  // Two particles may approach each other by twice the largest displacement, so half the skin is the limit.
  double const half_skin = VerletList<P>::skin * radius / 2;
  auto const below = positions_of<P>(moved(points, 0.98 * half_skin, 2));
  list.update(below, below);
  CHECK(list.builds() == 1);
  CHECK(fault<P>(list, below, below) == "");
  auto const above = positions_of<P>(moved(points, 1.02 * half_skin, 3));
  list.update(above, above);
  CHECK(list.builds() == 2);
  CHECK(fault<P>(list, above, above) == "");
  // Displacements count from the last build, not from the last update.
  list.update(below, below);
  CHECK(list.builds() == 3);
}

TEMPLATE_LIST_TEST_CASE("large lists have the candidates of others, in the same order", "", Policies) {
  using P = TestType;
  auto const x = positions_of<P>(random_points<P::dim>(400, 0, 0.8, 1));
  auto const found = [&](auto list) {
    list.update(x, x);
    return candidates<P>(list, x);
  };
  CHECK(found(LargeVerletList<P>(radius)) == found(VerletList<P>(radius)));
  CHECK(found(LargeReproducibleList<P>(radius)) == found(ReproducibleList<P>(radius)));
}

TEMPLATE_LIST_TEST_CASE("places in a large table go beyond 32 bits", "", Policies) {
  scree::detail::Table<TestType, std::uint64_t> table;
  table.rows = 75'000'000, table.capacity = 152, table.lanes = runs_on_host<TestType> ? 1 : 4;
  auto const last = table.place(table.rows - 1, table.capacity - 1);
  CHECK(last == std::size_t(table.rows) * 152 - 1);
  CHECK(table.place(table.rows - 1, table.capacity - 2) < last);
}

TEMPLATE_LIST_TEST_CASE("a Verlet list notices a jump after a long rest", "", Policies) {
  using P = TestType;
  auto const points = random_points<P::dim>(50, 0, 0.3, 1);
  auto const x = positions_of<P>(points), jumped = positions_of<P>(moved(points, 0.2, 2));
  VerletList<P> list(radius);
  for (int k = 0; k < 100; ++k) list.update(x, x);
  CHECK(list.builds() == 1);
  list.update(jumped, jumped);
  CHECK(list.builds() == 2);
  CHECK(fault<P>(list, jumped, jumped) == "");
}

TEMPLATE_LIST_TEST_CASE("a Verlet list counts displacements of targets and sources", "", Policies) {
  using P = TestType;
  auto const points = random_points<P::dim>(200, 0, 0.6, 1), others = random_points<P::dim>(300, 0, 0.6, 2);
  auto const targets = positions_of<P>(points), sources = positions_of<P>(others);
  double const skin = VerletList<P>::skin * radius;
  VerletList<P> list(radius);
  list.update(targets, sources);
  auto const moved_sources = positions_of<P>(moved(others, 0.45 * skin, 3));
  list.update(targets, moved_sources);
  CHECK(list.builds() == 1);
  CHECK(fault<P>(list, targets, moved_sources) == "");
  list.update(positions_of<P>(moved(points, 0.55 * skin, 4)), moved_sources);
  CHECK(list.builds() == 2);
}

TEMPLATE_LIST_TEST_CASE("a Verlet list does not trust an array whose particles moved in place", "", Policies) {
  using P = TestType;
  auto const points = random_points<P::dim>(200, 0, 0.6, 1);
  auto const x = array_of<P>(cast<typename P::real>(points));
  VerletList<P> list(radius);
  list.update(x, x);
  copy_array(x, array_of<P>(cast<typename P::real>(moved(points, 0.3, 5))));
  list.update(x, x);
  CHECK(list.builds() == 2);
  CHECK(fault<P>(list, x, x) == "");
}

TEMPLATE_LIST_TEST_CASE("a Verlet list of others has rows for those targets that see one", "", Policies) {
  using P = TestType;
  using List = typename VerletList<P>::OfOthers;
  int const many = List::many;
  auto const targets = random_points<P::dim>(many, 0, 0.8, 1);
  List list(radius);
  // Sources come nearer: rows are added as needed.
  for (double const near : {0.95, 0.7, 0.3, 0.7}) {
    auto sources = random_points<P::dim>(60, 0, 0.2, 2);
    for (auto& x : sources) x[0] += near;
    auto const x = positions_of<P>(targets), from = positions_of<P>(sources);
    list.update(x, from);
    INFO("sources from " << near << " on");
    CHECK(fault<P>(list, x, from) == "");
    int seeing = 0;
    for (auto const& found : candidates<P>(list, x)) seeing += !found.empty();
    CHECK(seeing < many * 3 / 4);
    if (near > 0.5) CHECK(list.view().table.rows < many / 2);
    CHECK(list.view().table.rows >= seeing);
  }
}

TEMPLATE_LIST_TEST_CASE("a Verlet list offers nothing beyond its skin", "", Policies) {
  using P = TestType;
  auto const x = positions_of<P>(random_points<P::dim>(300, 0, 0.6, 1));
  VerletList<P> list(radius);
  list.update(x, x);
  auto const points = values_of(x);
  auto const found = candidates<P>(list, x);
  double furthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int const j : found[i])
      furthest = std::max(furthest, double((points[i] - points[static_cast<std::size_t>(j)]).norm()));
  CHECK(furthest < radius * (1 + VerletList<P>::skin));
}

}  // namespace scree::test::verlet_list_tests
