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

#include <atomic>
#include <mutex>
#include <string>

// Warnings of ranks that do not all have a function `warn`.
namespace scree::test::warnings_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;

std::atomic<int> looks = 0;
/// Sand whose model is never valid.
struct Doubtful : Granular<> {
  template <class Whole>
  std::string warning_of_state(Whole const& body) const {
    ++looks;
    return body.size() > 0 ? "a doubtful state" : "";
  }
};
template <class Model>
struct Bed : Formulation<2> {
  using space = Space;
  using physics = Model;
};
double const dr = 0.05;
/// A bed under pressure, without gravity, whose particles have moved apart by a factor.
template <class F>
Solver<F> bed(Space const& space, SolverSettings<F> settings, double apart) {
  settings.spacing = dr;
  settings.lost_share = 1;
  settings.physics.gravity = {0};
  settings.physics.law = {.elastic = {1e6, 0.3, 1500}, .grains = {1e-3}};
  Solver<F> made(space, settings, fill_lattice(Box<2>{{0, 0}, {1, 0.6}}, dr));
  made.set(stress, [](auto const&) { return Vec<4, double>(-100, -100, -100, 0); });
  made.set(position, [=](auto const& x) { return Vec<2, double>(apart * x); });
  return made;
}
/// The warnings of the first step after each of two restores, on two ranks of which those with a bit in `heard` have a
/// function `warn`. Both ranks must look for warnings, or one waits for the other without end.
template <class Model>
std::string warnings(unsigned heard, double apart) {
  using F = OnRanks<Bed<Model>>;
  Snapshot snapshot;
  run_on_threads<Space>(1, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<F> settings;
    settings.ranks.team = team;
    snapshot = bed(space, settings, apart).snapshot();
  });
  snapshot.steps = 16'384;  // solvers on a GPU do not check the packing before this step
  std::string all;
  std::mutex writes;
  run_on_threads<Space>(2, [&](Team<Space> const& team, Space const& space) {
    SolverSettings<F> settings;
    settings.ranks.team = team;
    settings.warn = nullptr;
    if (heard >> team.rank() & 1)
      settings.warn = [&](std::string const& text) {
        std::scoped_lock const lock(writes);
        all += text + "\n";
      };
    auto solver = bed(space, settings, 1);
    for (int k = 0; k < 2; ++k) {
      auto later = snapshot;
      later.steps *= k + 1;
      solver.restore(later);
      solver.step(1);
    }
  });
  return all;
}

}  // namespace

TEST_CASE("all ranks look at the packing, whether or not they have a function for warnings") {
  for (unsigned const heard : {0u, 1u, 2u, 3u}) {
    INFO(heard);
    auto const found = warnings<Granular<>>(heard, 1.2);
    if (heard & 1)
      CHECK_THAT(found, ContainsSubstring("grains under pressure are packed 0."));
    else
      CHECK(found.empty());
    CHECK(warnings<Granular<>>(heard, 1).empty());
  }
}

TEST_CASE("all ranks look at the state for their models, whether or not they have a function for warnings") {
  for (unsigned const heard : {0u, 1u, 2u, 3u}) {
    INFO(heard);
    looks = 0;
    auto const found = warnings<Doubtful>(heard, 1);
    CHECK(looks == (heard == 0 ? 0 : 4));
    if (heard & 1)
      CHECK_THAT(found, ContainsSubstring("a doubtful state; found at "));
    else
      CHECK(found.empty());
  }
}

}  // namespace scree::test::warnings_tests
