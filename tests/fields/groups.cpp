// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/fields/groups.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace scree::test::groups_tests {
namespace {
using Catch::Matchers::ContainsSubstring;
using Points = std::vector<Vec<2, double>>;

Points const floor_points{{0, 0}, {1, 0}, {2, 0}}, gate_points{{2, 1}, {2, 2}};

Groups<2> walls() {
  Groups<2> groups;
  groups.add("floor", floor_points).add("lid", {}).add("gate", gate_points);
  return groups;
}
}  // namespace

TEST_CASE("groups hold their points one after the other") {
  auto const groups = walls();
  CHECK(groups.points() == Points{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}});
  CHECK(groups.names() == std::vector<std::string>{"floor", "lid", "gate"});
}

TEST_CASE("groups are ranges of numbers that find the points again") {
  auto const groups = walls();
  auto const floor = groups.range("floor"), lid = groups.range("lid"), gate = groups.range("gate");
  CHECK((floor.first == 0 && floor.last == 3));
  CHECK((lid.first == 3 && lid.last == 3));
  CHECK((gate.first == 3 && gate.last == 5));
  CHECK((floor.size() == 3 && lid.size() == 0));
  CHECK((gate.contains(3) && gate.contains(4) && !gate.contains(2) && !gate.contains(5) && !lid.contains(3)));
  for (int k = gate.first; k < gate.last; ++k)
    CHECK(groups.points()[static_cast<std::size_t>(k)] == gate_points[static_cast<std::size_t>(k - gate.first)]);
  CHECK(groups.name_of(2) == "floor");
  CHECK(groups.name_of(3) == "gate");
}

TEST_CASE("groups are numbered in the order in which they were added, and so are their particles") {
  auto const groups = walls();
  CHECK(groups.count() == 3);
  CHECK((groups.number("floor") == 0 && groups.number("lid") == 1 && groups.number("gate") == 2));
  CHECK(groups.numbers() == std::vector<int>{0, 0, 0, 2, 2});
  CHECK(Groups<3>().numbers().empty());
  CHECK_THROWS_WITH(groups.number("roof"), ContainsSubstring("'roof'") && ContainsSubstring("'floor', 'lid', 'gate'"));
}

TEST_CASE("unknown, repeated and nameless groups are refused, with the known ones") {
  auto groups = walls();
  CHECK_THROWS_AS(groups.range("roof"), std::invalid_argument);
  CHECK_THROWS_WITH(groups.range("roof"), ContainsSubstring("'roof'") && ContainsSubstring("'floor', 'lid', 'gate'"));
  CHECK_THROWS_WITH(groups.add("gate", floor_points),
                    ContainsSubstring("exists already") && ContainsSubstring("'floor', 'lid', 'gate'"));
  CHECK_THROWS_WITH(groups.add("", floor_points), ContainsSubstring("the name of a group must not be empty"));
  CHECK(groups.points().size() == 5);
  CHECK_THROWS_WITH(Groups<2>().range("floor"), ContainsSubstring("none"));
  CHECK_THROWS_AS(groups.name_of(5), std::out_of_range);
  CHECK_THROWS_AS(groups.name_of(-1), std::out_of_range);
}

}  // namespace scree::test::groups_tests
