// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>

namespace scree::test::shares_tests {
namespace {
using Catch::Matchers::ContainsSubstring;

/// Compares the shares that fill(share) gives with all points.
template <int Dim, class Fill>
void check_shares(std::vector<Vec<Dim, double>> const& whole, Fill const& fill) {
  REQUIRE(whole.size() > 20);
  for (int ranks : {1, 2, 3, 7}) {
    std::vector<Vec<Dim, double>> joined;
    std::size_t least = whole.size(), most = 0;
    for (int rank = 0; rank < ranks; ++rank) {
      INFO("rank " << rank << " of " << ranks);
      SharedPoints<Dim> const share = fill(ShareOfRank{rank, ranks});
      CHECK(share.all == long(whole.size()));
      CHECK(share.first == long(joined.size()));
      joined.insert(joined.end(), share.points.begin(), share.points.end());
      least = std::min(least, share.points.size()), most = std::max(most, share.points.size());
    }
    CHECK(joined == whole);
    CHECK(most - least <= 1);
  }
}

}  // namespace

TEST_CASE("shares of a filling are its points, in the same order and equally many") {
  Box<2> const box{{0, 0}, {1, 0.5}};
  Box<3> const cube{{0, 0, 0}, {0.5, 0.7, 0.3}};
  Ball<3> const ball{.centre = {0, 0, 0}, .radius = 0.4};
  auto const hollow = ball - Ball<3>{.centre = {0.1, 0, 0}, .radius = 0.2};
  check_shares<2>(fill_lattice(box, 0.1), [&](ShareOfRank s) { return fill_lattice(box, 0.1, s); });
  check_shares<3>(fill_lattice(cube, 0.1), [&](ShareOfRank s) { return fill_lattice(cube, 0.1, s); });
  check_shares<3>(fill_lattice(hollow, 0.05), [&](ShareOfRank s) { return fill_lattice(hollow, 0.05, s); });
  Vec<3, double> const anchor(0.01, 0.02, 0.03);
  check_shares<3>(fill_lattice(ball, 0.1, anchor), [&](ShareOfRank s) { return fill_lattice(ball, 0.1, anchor, s); });
  check_shares<3>(fill_hexagonal(ball, 0.1), [&](ShareOfRank s) { return fill_hexagonal(ball, 0.1, s); });
  check_shares<2>(fill_hexagonal(box, 0.1), [&](ShareOfRank s) { return fill_hexagonal(box, 0.1, s); });
  check_shares<3>(wall_around(cube, 0.1, 3), [&](ShareOfRank s) { return wall_around(cube, 0.1, 3, s); });
  check_shares<3>(wall_around(ball, 0.1, 2), [&](ShareOfRank s) { return wall_around(ball, 0.1, 2, s); });
  Box<3> const within{{-1, -1, -1}, {1, 1, 0.1}};
  check_shares<3>(wall_around(ball, 0.1, 2, within),
                  [&](ShareOfRank s) { return wall_around(ball, 0.1, 2, within, s); });
  Box<3> const outer{{-0.2, -0.2, -0.2}, {0.7, 0.9, 0.5}};
  check_shares<3>(fill_between(cube, outer, 0.1), [&](ShareOfRank s) { return fill_between(cube, outer, 0.1, s); });
  auto const points = fill_lattice(box, 0.1);
  check_shares<2>(points, [&](ShareOfRank s) { return share_of(points, s); });
}

TEST_CASE("shares of one row of a filling, and more ranks than points, have all of them") {
  Box<2> const row{{0, 0}, {3, 0.1}}, few{{0, 0}, {0.3, 0.1}};
  check_shares<2>(fill_lattice(row, 0.1), [&](ShareOfRank s) { return fill_lattice(row, 0.1, s); });
  std::size_t count = 0;
  for (int rank = 0; rank < 5; ++rank) count += fill_lattice(few, 0.1, ShareOfRank{rank, 5}).points.size();
  CHECK(count == 3);
  CHECK(fill_lattice(few, 0.1, ShareOfRank{0, 5}).points.empty());
}

TEST_CASE("a share is displaced as all points are") {
  Box<3> const box{{0, 0, 0}, {0.5, 0.5, 0.5}};
  auto whole = fill_lattice(box, 0.1);
  jitter(whole, 0.02, 7);
  check_shares<3>(whole, [&](ShareOfRank s) {
    auto share = fill_lattice(box, 0.1, s);
    jitter(share, 0.02, 7);
    return share;
  });
}

TEST_CASE("groups of shares have the ranges of the whole case") {
  Box<2> const floor{{0, -0.3}, {1, 0}}, gate{{1, 0}, {1.2, 1}};
  Groups<2> whole;
  whole.add("floor", fill_lattice(floor, 0.1)).add("lid", {}).add("gate", fill_lattice(gate, 0.1));
  int points = 0;
  for (int rank = 0; rank < 3; ++rank) {
    ShareOfRank const share{rank, 3};
    Groups<2> groups;
    groups.add("floor", fill_lattice(floor, 0.1, share)).add("lid", {}).add("gate", fill_lattice(gate, 0.1, share));
    CHECK(groups.are_shares());
    CHECK(groups.size() == whole.size());
    for (auto const& name : whole.names()) {
      CHECK(groups.range(name).first == whole.range(name).first);
      CHECK(groups.range(name).last == whole.range(name).last);
    }
    CHECK(groups.numbers_of_all() == whole.numbers());
    CHECK(groups.numbers().size() == groups.points().size());
    CHECK(groups.name_of(int(whole.size()) - 1) == "gate");
    std::size_t k = 0;
    for (auto const& range : groups.ranges_here())
      for (int i = range.here.first; i < range.here.last; ++i)
        CHECK(groups.points()[k++] == whole.points()[std::size_t(i)]);
    points += int(k);
  }
  CHECK(points == int(whole.size()));
}

TEST_CASE("shares that cannot be are refused") {
  Box<2> const box{{0, 0}, {1, 1}};
  CHECK_THROWS_WITH(fill_lattice(box, 0.1, ShareOfRank{3, 3}), ContainsSubstring("the number of a share"));
  CHECK_THROWS_WITH(fill_lattice(box, 0.1, ShareOfRank{0, 0}), ContainsSubstring("the number of shares"));
  CHECK_THROWS_WITH(fill_lattice(box, 1e-5, ShareOfRank{0, 4}), ContainsSubstring("more than the 2147483647"));
  Groups<2> groups;
  groups.add("floor", fill_lattice(box, 0.1));
  CHECK_THROWS_WITH(groups.add("gate", fill_lattice(box, 0.1, ShareOfRank{0, 2})),
                    ContainsSubstring("'gate' is given in shares and others whole"));
  CHECK_THROWS_WITH(groups.add("lid", SharedPoints<2>{{}, 0, 2147483647}), ContainsSubstring("in shares"));
  CHECK_THROWS_WITH(Groups<2>().add("sea", SharedPoints<2>{{}, 0, 3'000'000'000}),
                    ContainsSubstring("more than the 2147483647"));
  for (auto const& bad : {SharedPoints<2>{{{0, 0}}, 4294967296, 4294967297}, SharedPoints<2>{{{0, 0}}, -1, 4}})
    CHECK_THROWS(Groups<2>().add("one", bad));
  for (auto const& bad : {SharedPoints<2>{{{0, 0}}}, SharedPoints<2>{{{0, 0}}, 4, 4}, SharedPoints<2>{{{0, 0}}, -1, 4}})
    CHECK_THROWS_WITH(bad.check(), ContainsSubstring("a share of 1 points from number "));
}

}  // namespace scree::test::shares_tests
