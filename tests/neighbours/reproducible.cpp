// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/neighbours/cell_list.hpp>

#include <support/candidates.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <numeric>
#include <random>

namespace scree::test::reproducible_tests {
namespace {

/// The candidates of each target by their numbers before the sources were mixed.
template <class P, class Search>
std::vector<std::vector<int>> original(Search const& search, Positions<P> const& targets,
                                       std::vector<int> const& numbers) {
  auto found = candidates<P>(search, targets);
  for (auto& row : found)
    for (int& j : row) j = numbers[std::size_t(j)];
  return found;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("cells ordered by position give neighbours in the same order however sources are stored", "",
                        Policies) {
  using P = TestType;
  auto const points = random_points<P::dim>(400, 0, 1, 1);
  auto const targets = positions_of<P>(points);
  std::vector<int> numbers(points.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  CellList<P, ByPosition> ordered(0.2);
  CellList<P> plain(0.2);
  ordered.update(targets, targets), plain.update(targets, targets);
  auto const expected = original<P>(ordered, targets, numbers), by_index = original<P>(plain, targets, numbers);
  std::mt19937 random(1);
  std::shuffle(numbers.begin(), numbers.end(), random);
  Points<P::dim> mixed;
  for (int const j : numbers) mixed.push_back(points[std::size_t(j)]);
  auto const sources = positions_of<P>(mixed);
  ordered.update(targets, sources), plain.update(targets, sources);
  CHECK(original<P>(ordered, targets, numbers) == expected);
  CHECK(original<P>(plain, targets, numbers) != by_index);
}

TEMPLATE_LIST_TEST_CASE("a part of the sources has the cells of the frame of all", "", Policies) {
  using P = TestType;
  auto const points = random_points<P::dim>(2000, -1, 1, 1);
  auto const all = positions_of<P>(points);
  auto const frame = frame_of<P>(all);
  double const radius = 0.1;
  CellList<P, ByPosition> of_all(radius);
  of_all.update_in(frame, all);
  // Targets to the right, and all that they can have as neighbours.
  std::vector<int> numbers;
  Points<P::dim> near, right;
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (points[j][0] > 0.3) right.push_back(points[j]);
    if (points[j][0] > 0.3 - 1.01 * radius) near.push_back(points[j]), numbers.push_back(int(j));
  }
  CellList<P, ByPosition> of_rank(radius);
  of_rank.update_in(frame, positions_of<P>(near));
  std::vector<int> same(points.size());
  std::iota(same.begin(), same.end(), 0);
  auto const targets = positions_of<P>(right);
  CHECK(original<P>(of_rank, targets, numbers) == original<P>(of_all, targets, same));
  CHECK(of_rank.view().grid.size() < 0.6 * of_all.view().grid.size());
}

}  // namespace scree::test::reproducible_tests
