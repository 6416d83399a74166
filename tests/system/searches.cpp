// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/neighbours/brute_force.hpp>
#include <scree/neighbours/verlet_list.hpp>
#include <scree/system/searches.hpp>

#include <support/candidates.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <vector>

namespace scree::test::searches_tests {
namespace {

constexpr double radius = 0.12;  // m
constexpr int owned = 300, ghosts = 20;

/// Material with some ghosts, and a wall, that drift towards each other.
template <class P>
std::vector<Places<P>> places_at(double displacement) {
  auto material = random_points<P::dim>(owned + ghosts, 0, 0.8, 1), wall = random_points<P::dim>(90, 0, 0.8, 2);
  for (auto& x : material) x[0] += displacement;
  for (auto& x : wall) x[0] -= displacement;
  return {{positions_of<P>(material), owned}, {positions_of<P>(wall), 90}};
}

constexpr std::size_t material = 0, wall = 1;
template <class P, std::size_t Target, std::size_t Source, class All>
std::string fault(All& searches, std::vector<Places<P>> const& now) {
  auto const targets = now[Target].targets(), sources = now[Source].all;
  auto const found = [&] {
    if constexpr (Target == Source)
      return candidates<P>(searches.within(Target, now), targets);
    else
      return candidates<P>(searches.among(Target, Source, now), targets);
  }();
  return fault_of_candidates<P>(found, values_of(targets), values_of(sources), radius);
}

template <class All, class Now>
void bring_up_to_date(All& searches, Now const& now) {
  auto&& watch = searches.watch();
  if (!watch.serves(watch.crossed(now))) searches.renew(now);
}

template <class P, class Search>
long find_all(int updates) {
  Searches<P, Search> searches(radius, 2);
  for (int k = 0; k < updates; ++k) {
    auto const now = places_at<P>(1e-4 * k);
    bring_up_to_date(searches, now);
    INFO("update " << k);
    CHECK(fault<P, material, material>(searches, now) == "");
    CHECK(fault<P, material, wall>(searches, now) == "");
    // A search that is not always requested must be correct all the same.
    if (k % 7 == 5) CHECK(fault<P, wall, material>(searches, now) == "");
  }
  return searches.builds();
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("searches of all pairs of bodies find what is there while particles move", "", Policies) {
  using P = TestType;
  int const updates = 150;
  CHECK(find_all<P, CellList<P>>(updates) == updates);
  CHECK(find_all<P, BruteForce<P>>(updates) == 0);
  // The skin of 12 mm is crossed by two particles that move 6 mm each, in 60 updates.
  long const lists = find_all<P, VerletList<P>>(updates);
  CHECK(lists >= 3);
  CHECK(lists <= 4);
}

TEMPLATE_LIST_TEST_CASE("searches by lists go on from those of another system", "", Policies) {
  using P = TestType;
  using All = Searches<P, VerletList<P>>;
  All before(radius, 2), after(radius, 2);
  for (int k = 0; k < 40; ++k) {
    auto const now = places_at<P>(1e-4 * k);
    bring_up_to_date(before, now);
    before.within(material, now);
  }
  after.restore(typename P::space(), before.memory());
  CHECK(after.builds() == before.builds());
  for (int k = 40; k < 150; ++k) {
    auto const now = places_at<P>(1e-4 * k);
    auto const targets = now[wall].targets();
    for (auto* searches : {&before, &after}) bring_up_to_date(*searches, now);
    auto const found = candidates<P>(after.among(wall, material, now), targets);
    INFO("update " << k);
    CHECK(found == candidates<P>(before.among(wall, material, now), targets));
    CHECK(after.builds() == before.builds());
  }
}

}  // namespace scree::test::searches_tests
