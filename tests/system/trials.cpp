// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Steps that may have to be repeated, of a system that only counts: with random failures, errors and readers.
#include <scree/system/trials.hpp>

#include <catch2/catch_test_macros.hpp>

#include <random>
#include <stdexcept>

namespace scree::test::trial_steps_tests {
namespace {

/// A state whose value after step n is n exactly, unless a step of a trial used outdated lists.
struct Counting {
  struct Case {
    bool has_others = false;
    bool is_shared() const { return has_others; }
  };
  struct Clock {
    long steps = 0;
  };
  struct System {
    std::mt19937& random;
    Case of_case;
    double value = 0, value_before = 0;
    bool under_way = false, outrun = false;
    int until_next = 0;  // steps before lists allow a trial
    long failures = 0, trials = 0;

    bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(random) == 1; }
    Case const& whole_case() const { return of_case; }
    bool in_trial() const { return under_way; }
    bool begin_trial() {
      if (under_way || until_next-- > 0 || !one_in(3)) return false;
      value_before = value, under_way = true, outrun = false;
      return ++trials, true;
    }
    bool trial_failed() const { return under_way && outrun; }
    void end_trial() {
      REQUIRE_FALSE(trial_failed());
      under_way = false;
    }
    void undo_trial() {
      REQUIRE(under_way);
      value = value_before, under_way = outrun = false, until_next = 8;
      ++failures;
    }
    void advance() {
      if (under_way && one_in(6)) outrun = true, value += 1000;  // this step used outdated lists, unnoticed
      value += 1;
      if (trial_failed() && one_in(3)) throw detail::ListsOutrun();
      if (trial_failed() && one_in(4)) throw std::runtime_error("an effect of outdated lists");
      if (under_way && !outrun && one_in(5)) under_way = false;  // lists were built
    }
  };
  System system;
  Clock clock;
};

struct RealError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Makes `steps` steps with readers at random times; returns the state.
Counting run(std::mt19937& random, long steps, bool several, long throws_at, long asks_throw_at) {
  Counting state{{random, {several}}, {}};
  detail::Trials trials(state);
  auto const is_right = [&] { return state.system.value == double(state.clock.steps); };
  auto const take = [&] {
    state.system.advance();
    if (++state.clock.steps == throws_at && !state.system.trial_failed()) throw RealError("at this step");
  };
  while (state.clock.steps < steps) {
    try {
      if (!trials.step(take, true)) {
        REQUIRE(is_right());
        continue;
      }
    } catch (RealError const&) {
      REQUIRE(state.clock.steps == throws_at);
      REQUIRE(is_right());
      return state;
    }
    bool asked = false;
    try {
      trials.ask([&]() -> bool {
        asked = true;
        if (state.clock.steps == asks_throw_at) throw RealError("of the caller");
        return false;
      });
    } catch (RealError const&) {
      REQUIRE(is_right());
      REQUIRE_FALSE((several && state.system.trial_failed()));
      return state;
    }
    REQUIRE(asked);
    if (state.system.one_in(4) || state.clock.steps >= steps) {
      bool const certain = trials.become_certain();
      REQUIRE(is_right());
      REQUIRE_FALSE(state.system.in_trial());
      if (!certain) REQUIRE(state.system.failures > 0);
    }
  }
  REQUIRE(state.clock.steps == steps);
  REQUIRE(is_right());
  return state;
}

}  // namespace

TEST_CASE("a run of trials ends where single steps end, and shows no state that is taken back") {
  long failures = 0, trials = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    auto const end = run(random, 100, false, -1, -1);
    failures += end.system.failures, trials += end.system.trials;
  }
  CHECK(failures > 1000);
  CHECK(trials > failures);
}

TEST_CASE("an error in a trial is thrown if it is real, and with the state that it belongs to") {
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    auto const end = run(random, 100, false, 20 + long(seed % 60), -1);
    CHECK(end.clock.steps == 20 + long(seed % 60));
  }
}

TEST_CASE("an error of a caller leaves a state that is certain") {
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    auto const end = run(random, 100, false, -1, 10 + long(seed % 80));
    CHECK(end.clock.steps <= 10 + long(seed % 80));
  }
}

}  // namespace scree::test::trial_steps_tests
