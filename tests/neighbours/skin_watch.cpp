// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/neighbours/skin_watch.hpp>

#include <support/candidates.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <functional>
#include <limits>
#include <vector>

namespace scree::test::skin_watch_tests {
namespace {

constexpr double skin = 0.01;  // m

/// `count` points that have all moved by the same distance (m).
template <class P>
Positions<P> points_at(double distance, int count = 50) {
  auto points = random_points<P::dim>(count, 0, 0.3, 1);
  auto const directions = random_points<P::dim>(count, -1, 1, 2);
  for (std::size_t k = 0; k < points.size(); ++k) points[k] += distance * directions[k].normalized();
  return positions_of<P>(points);
}

template <class P>
Places<P> all_of(Positions<P> const& x) {
  return {x, x.size()};
}
/// Checks, and stores positions if the lists are invalid.
template <class P>
bool serves(SkinWatch<P>& watch, Positions<P> const& first, Positions<P> const& second = {}) {
  bool const yes = watch.serves(watch.crossed({all_of<P>(first), all_of<P>(second)}));
  if (!yes) watch.keep({all_of<P>(first), all_of<P>(second)});
  return yes;
}

/// Which of 400 updates build lists, for the displacements of each update (m).
template <class P>
std::vector<int> builds(SkinWatch<P>& watch, std::function<double(int)> const& distance, int from = 0) {
  std::vector<int> found;
  for (int k = from; k < 400; ++k)
    if (!serves<P>(watch, points_at<P>(distance(k)))) found.push_back(k);
  return found;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("lists are built before the skin is crossed, though not every update is looked at", "",
                        Policies) {
  using P = TestType;
  double const half = skin / 2;
  std::function<double(int)> const motions[] = {
      [&](int k) { return half * k / 90; },                                    // at constant speed
      [&](int k) { return 2e-4 * half * sq(k); },                              // under a constant acceleration
      [&](int k) { return k < 7 ? 0 : 2e-4 * half * sq(k - 7); },              // after a rest
      [&](int k) { return k < 120 ? half * k / 200 : half * (k - 48) / 120; }  // faster from one update to the next
  };
  for (int which = 0; which < 4; ++which) {
    auto const& distance = motions[which];
    SkinWatch<P> watch(skin, 2);
    auto const at = builds<P>(watch, distance);
    REQUIRE(at.size() > 3);
    CHECK(watch.builds() == static_cast<long>(at.size()));
    for (std::size_t k = 1; k < at.size(); ++k) {
      INFO("motion " << which << ", built at " << at[k - 1] << " and " << at[k]);
      CHECK(distance(at[k] - 1) - distance(at[k - 1]) <= half * (1 + 1e-3));
      CHECK(distance(at[k]) - distance(at[k - 1]) > 0.75 * half);
    }
  }
}

TEMPLATE_LIST_TEST_CASE("displacements within the first body and between both count", "", Policies) {
  using P = TestType;
  auto const serve_after = [](double first, double second) {
    SkinWatch<P> watch(skin, 2);
    serves<P>(watch, points_at<P>(0), points_at<P>(0, 30));
    return serves<P>(watch, points_at<P>(first * skin), points_at<P>(second * skin, 30));
  };
  CHECK(serve_after(0.49, 0.49));
  CHECK_FALSE(serve_after(0.51, 0));
  CHECK(serve_after(0, 0.49));
  CHECK_FALSE(serve_after(0, 0.51));
}

TEMPLATE_LIST_TEST_CASE("displacements within any of nine bodies count", "", Policies) {
  using P = TestType;
  for (std::size_t moved = 0; moved < 9; ++moved) {
    SkinWatch<P> watch(skin, 9);
    std::vector<Places<P>> bodies;
    for (std::size_t k = 0; k < 9; ++k) bodies.push_back(all_of<P>(points_at<P>(0, 10 + int(k))));
    watch.keep(bodies);
    bodies[moved] = all_of<P>(points_at<P>(0.49 * skin, 10 + int(moved)));
    INFO("body " << moved);
    CHECK(watch.serves(watch.crossed(bodies)));
    bodies[moved] = all_of<P>(points_at<P>(0.51 * skin, 10 + int(moved)));
    CHECK_FALSE(watch.serves(watch.crossed(bodies)));
  }
}

TEMPLATE_LIST_TEST_CASE("other numbers of particles, and what is no number, need other lists", "", Policies) {
  using P = TestType;
  SkinWatch<P> watch(skin, 2);
  CHECK_FALSE(serves<P>(watch, points_at<P>(0)));
  CHECK(serves<P>(watch, points_at<P>(0)));
  CHECK_FALSE(serves<P>(watch, points_at<P>(0, 51)));
  CHECK_FALSE(serves<P>(watch, points_at<P>(0, 51), points_at<P>(0, 3)));
  double const none = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(serves<P>(watch, points_at<P>(none, 51), points_at<P>(0, 3)));
}

TEMPLATE_LIST_TEST_CASE("ghosts are kept and not watched", "", Policies) {
  using P = TestType;
  SkinWatch<P> watch(skin, 2);
  watch.keep({Places<P>{points_at<P>(0, 50), 40}, {}});
  CHECK(watch.kept(0).size() == 50);
  CHECK(watch.serves(watch.crossed({Places<P>{points_at<P>(0, 40), 40}, {}})));
  CHECK_FALSE(watch.serves(watch.crossed({Places<P>{points_at<P>(0, 50), 50}, {}})));
}

TEMPLATE_LIST_TEST_CASE("the positions of the last build are kept", "", Policies) {
  using P = TestType;
  SkinWatch<P> watch(skin, 2);
  serves<P>(watch, points_at<P>(0), points_at<P>(0, 3));
  serves<P>(watch, points_at<P>(0.1 * skin), points_at<P>(0.1 * skin, 3));
  CHECK(values_of(Positions<P>(watch.kept(0))) == values_of(points_at<P>(0)));
  CHECK(values_of(Positions<P>(watch.kept(1))) == values_of(points_at<P>(0, 3)));
}

TEMPLATE_LIST_TEST_CASE("a watch that goes on from another builds when that one would have", "", Policies) {
  using P = TestType;
  auto const distance = [](int k) { return skin / 2 * (k + 20 * std::sin(0.05 * k)) / 60; };
  SkinWatch<P> through(skin, 2);
  auto const all = builds<P>(through, distance);
  for (int const stop : {0, 1, 30, 77, 200}) {
    SkinWatch<P> before(skin, 2), after(skin, 2);
    for (int k = 0; k < stop; ++k) serves<P>(before, points_at<P>(distance(k)));
    after.restore(typename P::space(), before.memory());
    std::vector<int> expected;
    for (int const k : all)
      if (k >= stop) expected.push_back(k);
    INFO("stopped after " << stop);
    CHECK(builds<P>(after, distance, stop) == expected);
    CHECK(after.builds() == through.builds());
  }
}

}  // namespace scree::test::skin_watch_tests
