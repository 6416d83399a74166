// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/solver/solver.hpp>

#include <support/bodies.hpp>
#include <support/formulations.hpp>
#include <support/weightless_sand.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <atomic>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

// Uses of a solver that its state does not allow.
namespace scree::test::misuse_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;

struct Steps : NothingEvolves {
  auto limits(Resolution const&) const { return std::tuple(limit("step", 0.01)); }
};
using S = Solver<Formulated<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, Steps>>;

S box() {
  auto const [material, wall] = open_bed<2>({0.4, 0.4}, 0.1);
  return S({.spacing = 0.1}, material, wall);
}
/// Sand, whose neighbours are looked for.
struct Sand : Formulation<2> {
  using physics = Granular<>;
};
Solver<Sand> sand() {
  auto const [material, wall] = open_bed<2>({0.8, 0.4}, 0.1);
  return Solver<Sand>({.spacing = 0.1, .physics = weightless()}, material, wall);
}
double const nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("a solver that advances is not run or stepped by its observers, and goes on after such an error") {
  auto solver = box();
  auto const by = [](auto const& use) { return std::vector{every<S>(0.1, use)}; };
  CHECK_THROWS_WITH(solver.run(0.3, by([](S& now) { now.run(now.time() + 0.05); })),
                    ContainsSubstring("scree: this solver is advancing already"));
  CHECK_THROWS_AS(solver.run(0.3, by([](S& now) { now.step(0.01); })), std::logic_error);
  CHECK_NOTHROW(solver.run(0.3, by([](S& now) { now.set(position, [](auto const& x) { return x; }); })));
  CHECK(solver.time() == 0.3);
  CHECK_NOTHROW(solver.step(0.01));
}

TEST_CASE("of two threads that run a solver one is refused") {
  auto solver = box();
  std::atomic<bool> runs = false, tried = false;
  std::string said;
  std::thread other([&] {
    while (!runs) std::this_thread::yield();
    try {
      solver.run(1);
    } catch (std::logic_error const& error) {
      said = error.what();
    }
    tried = true;
  });
  solver.run(0.02, {every<S>(0.01, [&](S&) {
               runs = true;
               while (!tried) std::this_thread::yield();
             })});
  other.join();
  CHECK_THAT(said, ContainsSubstring("another thread"));
  CHECK(solver.time() == 0.02);
}

TEST_CASE("a solver that was moved from says so, and one that is moved to itself keeps its state") {
  auto solver = box();
  solver.run(0.05);
  S moved = std::move(solver);
  for (auto const& use : std::vector<std::function<void()>>{
           [&] { solver.run(1); }, [&] { solver.step(1); }, [&] { solver.snapshot(); },
           [&] { solver.restore(moved.snapshot()); },
           [&] {
             solver.add({{9, 9}});
           },
           [&] { solver.set(position, std::vector<int>(), [](int) { return Vec<2, double>(0, 0); }); }})
    CHECK_THROWS_WITH(use(), ContainsSubstring("scree: this solver was moved to another one"));
  S& itself = moved;
  moved = std::move(itself);
  CHECK(moved.time() == 0.05);
  CHECK_NOTHROW(moved.run(0.1));
  auto const x = moved.material().to_host(position);
  solver = std::move(moved);
  CHECK(solver.material().to_host(position) == x);
  CHECK_NOTHROW(solver.run(0.2));
}

TEST_CASE("an observer without a function is refused before the run") {
  CHECK_THROWS_WITH(every<S>(0.1, nullptr), ContainsSubstring("an observer needs functions"));
  CHECK_THROWS_WITH(at<S>({0.1}, {}), ContainsSubstring("an observer needs functions"));
  auto solver = box();
  CHECK_THROWS_WITH(solver.run(1, {Observer<S>{}}), ContainsSubstring("an observer needs functions"));
  CHECK_THROWS_WITH(solver.run(1, {Observer<S>{[](double) { return 1.0; }, {}}}), ContainsSubstring("an observer"));
  CHECK(solver.time() == 0);
}

TEST_CASE("identities that are set are different numbers from zero") {
  auto solver = box();
  int next = 0;
  auto const numbered = [&](int first, int by) {
    next = first - by;
    return [&next, by](auto const&) { return next += by; };
  };
  CHECK_THROWS_WITH(solver.set(identity, numbered(-5, 1)),
                    ContainsSubstring("the identity of a particle of the material must be 0 or more, not -5"));
  CHECK_THROWS_WITH(solver.set(identity, numbered(7, 0)),
                    ContainsSubstring("scree: two particles of the material have the identity 7"));
  CHECK_THROWS_WITH(solver.set<Wall>(identity, numbered(7, 0)), ContainsSubstring("of the wall"));
  CHECK_NOTHROW(solver.set(identity, numbered(100, 3)));
  CHECK(solver.material().to_host(identity)[1] == 103);
}

TEST_CASE("a snapshot with identities that are negative or given twice is not restored") {
  auto solver = sand();
  solver.run(0.01);
  auto const good = solver.snapshot();
  for (int const bad : {-77, 1}) {
    auto snapshot = good;
    for (auto& array : snapshot.arrays)
      if (array.name == "material/identity") std::memcpy(array.bytes.data(), &bad, sizeof bad);
    CHECK_THROWS_WITH(sand().restore(snapshot), ContainsSubstring("'material/identity' has " + std::to_string(bad)));
  }
  auto snapshot = good;
  bool found = false;
  for (auto& array : snapshot.arrays)
    if (array.name == "neighbours/material" && !array.bytes.empty())
      std::memcpy(array.bytes.data(), &nan, sizeof nan), found = true;
  REQUIRE(found);
  CHECK_THROWS_WITH(sand().restore(snapshot),
                    ContainsSubstring("'neighbours/material' has a position that is not finite"));
  CHECK_NOTHROW(sand().restore(good));
}

TEST_CASE("positions that are not finite are named with their particle and value") {
  auto solver = sand();
  int number = 0;
  solver.set(position, [&](auto const& x) { return number++ == 3 ? Vec<2, double>(nan, 0.25) : Vec<2, double>(x); });
  CHECK_THROWS_WITH(solver.run(1), ContainsSubstring("number 3 in memory, at (nan, 0.25) m") ||
                                       ContainsSubstring("particle 3 is not finite"));
  auto walls = sand();
  number = 0;
  walls.set<Wall>(rest_position,
                  [&](auto const& x) { return number++ == 5 ? Vec<2, double>(0.5, nan) : Vec<2, double>(x); });
  CHECK_THROWS_WITH(walls.run(1),
                    ContainsSubstring("number 5 in memory, at (0.5, nan) m") || ContainsSubstring("particle 5"));
}

}  // namespace scree::test::misuse_tests
