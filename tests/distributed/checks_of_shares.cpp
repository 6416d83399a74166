// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "on_ranks.hpp"

#include <support/formulations.hpp>

#include <scree/granular/granular.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <string>
#include <vector>

// Faults that are refused at the start of a case whose ranks begin with shares. The checks see the whole case: the
// ranks refuse what one rank refuses. Of several particles with a fault they may name another one.
namespace scree::test::checks_of_shares_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;

struct Bed : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
};
double const dr = 0.1;
using S = Solver<OnRanks<Bed>>;
using PointList = std::vector<Vec<2, double>>;

/// A bed on a floor.
struct Case {
  PointList sand = fill_lattice(Box<2>{{0, 0}, {2, 1}}, dr), wall = fill_lattice(Box<2>{{-1, -0.4}, {3, 0}}, dr);
  double spacing = dr, young = 1e5;
  std::vector<Period> periods = {};
};
/// The message that ends the first step on some ranks, or "". The ranks begin with shares, or whole.
std::string complaint(Case const& given, int ranks, bool from_shares) {
  try {
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      SolverSettings<OnRanks<Bed>> settings;
      settings.spacing = given.spacing;
      settings.ranks.team = team;
      settings.periods = given.periods;
      settings.physics.law = {.elastic = {given.young, 0.3, 1500}, .grains = {1e-3}};
      auto solver = from_shares
                        ? S(space, settings, share_of(given.sand, team.share()), share_of(given.wall, team.share()))
                        : S(space, settings, given.sand, given.wall);
      solver.step(1e-6);
    });
  } catch (std::exception const& error) {
    return error.what();
  }
  return "";
}
void check_refused(Case const& given, std::string const& words) {
  CHECK_THAT(complaint(given, 1, false), ContainsSubstring(words));
  for (int ranks : {1, 2, 3, 4}) {
    INFO(ranks << " ranks");
    CHECK_THAT(complaint(given, ranks, true), ContainsSubstring(words));
  }
}
/// The message when a solver of Bed is made from the sand and the wall that make(team) returns.
template <class Make>
std::string refusal(int ranks, Make const& make) {
  try {
    run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
      SolverSettings<OnRanks<Bed>> settings{.spacing = dr};
      settings.ranks.team = team;
      auto const [sand, wall] = make(team);
      S const solver(space, settings, sand, wall);
    });
  } catch (std::exception const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a good start from shares is accepted", "") {
  for (int ranks : {1, 2, 3, 4}) CHECK(complaint({}, ranks, true) == "");
  for (int ranks : {1, 4}) CHECK(complaint({.periods = {{0, -1, 3}}}, ranks, true) == "");
}

TEST_CASE("particles of two shares in one place are refused", "") {
  for (std::size_t const number : {3u, 77u, 199u}) {
    Case twice;
    twice.sand[number] = twice.sand[100] + Vec<2, double>(0.004, 0);  // far away in the order
    check_refused(twice, " m is 0.004 m from particle ");
  }
}

TEST_CASE("particles of all ranks crowd each other", "") {
  // A column of sand along the cut between two ranks that is twice as dense.
  Case dense;
  for (int k = 0; k < 20; ++k) dense.sand.push_back({1.0, 0.05 + 0.05 * k});
  check_refused(dense, "stands in a material and walls");
}

TEST_CASE("sand in the wall of another rank is refused", "") {
  Case sunk;
  sunk.sand[10] = sunk.wall[60] + Vec<2, double>(0, 0.005);
  check_refused(sunk, "is 0.005 m from particle 60 of the wall");
}

TEST_CASE("particles that are near over a period are refused", "") {
  Case over;
  over.periods = {{0, -1, 3}};
  over.sand[0] = {-0.998, 0.8}, over.sand[199] = {2.999, 0.8};
  check_refused(over, "is 0.003 m from particle 199");
}

TEST_CASE("a spacing that is too small is refused by the particles of all ranks", "") {
  check_refused({.spacing = 0.05}, "has no neighbour within 1.5 spacings (0.075 m), as 200 of 200 particles");
  // Fewer than thirty on each rank.
  Case few{.sand = fill_lattice(Box<2>{{0, 0}, {1, 0.4}}, dr), .wall = {}, .spacing = 0.05};
  check_refused(few, "as 40 of 40 particles");
}

TEST_CASE("a bed that its weight would crush is refused by its depth on all ranks", "") {
  Case deep{.young = 100};
  deep.sand = fill_lattice(Box<2>{{0, 0}, {0.4, 6}}, dr);
  auto const whole = complaint(deep, 1, false);
  CHECK(!whole.empty());
  for (int ranks : {1, 2, 4}) CHECK(complaint(deep, ranks, true) == whole);
}

TEST_CASE("walls that are too thin are found where they are cut", "") {
  Case row;
  row.wall = fill_lattice(Box<2>{{-1, -dr}, {3, 0}}, dr);
  check_refused(row, "it has one row of particles");
  // Sand on both sides of a wall between the ranks.
  Case between;
  between.wall = fill_lattice(Box<2>{{1, 0}, {1.2, 1}}, dr);
  std::erase_if(between.sand, [](auto const& x) { return x[0] > 1 && x[0] < 1.2; });
  check_refused(between, "it has material on both sides");
}

TEST_CASE("shares that do not fit each other are refused", "") {
  Case const given;
  auto const at = [](int rank, int ranks) { return ShareOfRank{rank, ranks}; };
  CHECK_THAT(refusal(3,
                     [&](auto const& team) {
                       return std::pair(share_of(given.sand, at(team.rank() == 2 ? 1 : team.rank(), 3)),
                                        share_of(given.wall, team.share()));
                     }),
             ContainsSubstring("the shares of the material do not fit: particle 66 of 200 is given on more than one"));
  CHECK_THAT(refusal(2,
                     [&](auto const& team) {
                       return std::pair(share_of(given.sand, team.share()), share_of(given.wall, at(team.rank(), 3)));
                     }),
             ContainsSubstring("the shares of the wall do not fit: particle 106 of 160 is given on no rank"));
  CHECK_THAT(refusal(2,
                     [&](auto const& team) {
                       auto sand = given.sand;
                       if (team.rank() == 1) sand.pop_back();
                       return std::pair(share_of(sand, team.share()), share_of(given.wall, team.share()));
                     }),
             ContainsSubstring("shares of different points of the material: of 200 on rank 0, of 199 on rank 1"));
  CHECK_THAT(refusal(2, [&](auto const& team) { return std::pair(share_of(given.sand, team.share()), given.wall); }),
             ContainsSubstring("the wall is given whole, and other bodies in shares"));
  CHECK(refusal(2, [&](auto const& team) { return std::pair(share_of(given.sand, team.share()), PointList{}); }) == "");
}

TEST_CASE("groups that differ between ranks are refused", "") {
  Case const given;
  auto const refused = [&](auto const& walls_of) {
    return refusal(2, [&](auto const& team) {
      return std::pair(share_of(given.sand, team.share()), walls_of(team.rank(), team.share()));
    });
  };
  PointList const left(given.wall.begin(), given.wall.begin() + 80), right(given.wall.begin() + 80, given.wall.end());
  std::string const words = "the ranks have other groups of the wall: each rank adds all groups in the same order";
  CHECK(refused([&](int, auto const& share) {
          return Groups<2>().add("left", share_of(left, share)).add("right", share_of(right, share));
        }) == "");
  CHECK_THAT(refused([&](int rank, auto const& share) {
               auto const one = share_of(left, share), other = share_of(right, share);
               return rank == 0 ? Groups<2>().add("left", one).add("right", other)
                                : Groups<2>().add("right", other).add("left", one);
             }),
             ContainsSubstring(words));
  CHECK_THAT(refused([&](int rank, auto const&) {
               auto walls = Groups<2>().add("left", share_of(left, ShareOfRank{rank, 2}));
               if (rank == 0) walls.add("right", SharedPoints<2>{right, 0, 80});
               return walls;
             }),
             ContainsSubstring(words));
  CHECK_THAT(refused([&](int rank, auto const&) {  // nothing on the other rank
               return rank == 0 ? Groups<2>().add("all", SharedPoints<2>{given.wall, 0, 160}) : Groups<2>();
             }),
             ContainsSubstring(words));
}

TEST_CASE("a rank without any points knows that the others begin with shares", "") {
  Case const given;
  CHECK_THAT(
      refusal(2,
              [&](auto const& team) {
                auto const all = [&](PointList const& points) {
                  return team.rank() == 0 ? Groups<2>().add("all", share_of(points, ShareOfRank{0, 1})) : Groups<2>();
                };
                return std::pair(all(given.sand), all(given.wall));
              }),
      ContainsSubstring("the ranks have other groups of the material"));
}

TEST_CASE("more particles than identities count are refused", "") {
  long const most = 2147483647;
  auto const of = [](long all) {
    return [=](Team<Space> const&) { return std::pair(SharedPoints<2>{{}, 0, all}, SharedPoints<2>{{}, 0, 0}); };
  };
  CHECK_THAT(refusal(1, of(most + 1)), ContainsSubstring("more than the 2147483647 that can be counted"));
  CHECK_THAT(refusal(1, of(5'000'000'000)), ContainsSubstring("more than the 2147483647 that can be counted"));
}

namespace {
struct Stone : RigidBody {
  static constexpr std::string_view name = "stone";
};
struct WithStone : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
  using bodies = Bodies<Material, Wall, Stone>;
};
}  // namespace

TEST_CASE("a case with rigid bodies cannot begin from shares", "") {
  run_on_threads<Space>(1, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<OnRanks<WithStone>> settings{.spacing = dr};
    settings.ranks.team = team;
    auto const sand = fill_lattice(Box<2>{{0, 0}, {1, 1}}, dr, team.share());
    auto const stone = fill_lattice(Box<2>{{0, 1}, {0.4, 1.4}}, dr);
    CHECK_THROWS_WITH(
        Solver<OnRanks<WithStone>>(space, settings, particles_of<Material>(sand), particles_of<Stone>(stone)),
        ContainsSubstring("a case with rigid bodies cannot begin from shares"));
  });
}

namespace {
/// The upper rows of a wall slide over the lower ones; one metre higher everything moves alike.
struct Sliding {
  template <class X>
  SCREE_FN X displaced(X const& x, double from, double to) const {
    return x + X(velocity(x, to) * typename X::Scalar(to - from));
  }
  template <class X>
  SCREE_FN X velocity(X const& x, double) const {
    X u = X::Zero();
    u[0] = x[1] - Kokkos::floor(x[1]) > 0.8 ? 0.01 : 0.0;
    return u;
  }
  template <class X>
  SCREE_FN X acceleration(X const&, double) const {
    return X::Zero();
  }
  double time_step() const { return 1; }
};
struct OnSlidingWall : Bed {
  using motion = Sliding;
};
}  // namespace

TEST_CASE("a wall whose shares move in different ways is refused", "") {
  Case const given;
  for (int ranks : {1, 2, 4})
    CHECK_THROWS_WITH(run_on_threads<Space>(ranks,
                                            [&](Team<Space> const& team, Space const& space) {
                                              SolverSettings<OnRanks<OnSlidingWall>> settings{.spacing = dr};
                                              settings.ranks.team = team;
                                              Solver<OnRanks<OnSlidingWall>> const solver(
                                                  space, settings, share_of(given.sand, team.share()),
                                                  share_of(given.wall, team.share()));
                                            }),
                      ContainsSubstring("not affine"));
}

}  // namespace scree::test::checks_of_shares_tests
