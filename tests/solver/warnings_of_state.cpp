// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/granular.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <string>
#include <vector>

// When a run passes on what its models say of the state.
namespace scree::test::warnings_of_state_tests {
namespace {

std::vector<std::array<bool, 2>> doubts;  // of two models, at each look
std::size_t looks = 0;
/// Sand with two models, which doubt the state as `doubts` says.
struct TwoModels : Granular<> {
  template <class Whole>
  std::vector<std::string> warnings_of_state(Whole const&) const {
    auto const [first, second] = doubts.at(looks++);
    return {first ? "the first" : "", second ? "the second" : ""};
  }
};
struct Bed : Formulation<2> {
  using physics = TwoModels;
};
/// What a run says at each look, one after the other.
std::vector<std::string> said_at(std::vector<std::array<bool, 2>> const& given) {
  doubts = given, looks = 0;
  std::vector<std::string> all;
  SolverSettings<Bed> settings{.spacing = 0.1};
  settings.physics.gravity = {0};
  settings.physics.law = {.elastic = {1e6, 0.3, 1500}, .grains = {1e-3}};
  settings.warn = [&](std::string const& text) { all.back() += text; };
  Solver<Bed> solver(settings, fill_lattice(Box<2>{{0, 0}, {1, 1}}, 0.1));
  auto later = solver.snapshot();
  for (std::size_t k = 0; k < given.size(); ++k) {
    all.emplace_back();
    later.steps = 1024L << k;
    solver.restore(later);
    solver.step(1e-5);
  }
  return all;
}

}  // namespace

TEST_CASE("each model has its warning passed on once, where two looks in a row find a doubtful state") {
  using Catch::Matchers::StartsWith;
  auto const said = said_at({{true, false}, {false, true}, {true, true}, {true, true}, {true, true}});
  CHECK(said[0].empty());
  CHECK(said[1].empty());  // another model than at the look before
  CHECK_THAT(said[2], StartsWith("the second; found at "));
  CHECK_THAT(said[3], StartsWith("the first; found at "));
  CHECK(said[4].empty());
  CHECK(looks == 4);  // both have said what they had to say
}

TEST_CASE("a doubt that has gone at the next look is not passed on") {
  for (auto const& text : said_at({{true, false}, {false, false}, {true, false}, {false, false}})) CHECK(text.empty());
  CHECK(looks == 4);
}

}  // namespace scree::test::warnings_of_state_tests
