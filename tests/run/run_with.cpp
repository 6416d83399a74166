// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/run/run_with.hpp>

#include <catch2/catch_test_macros.hpp>

#include <functional>
#include <string>
#include <vector>

namespace scree::test::run_with_tests {
namespace {

/// Runs with steps of one second, as Solver::run() does: observers, then `stop` if `asks`.
struct Clock {
  using Observers = std::vector<std::function<void(Clock&)>>;
  double now = 0;
  double time() const { return now; }
  void run(double until, Observers const& observers, std::function<bool(Clock const&)> const& stop,
           std::function<bool()> const& asks) {
    while (now < until) {
      ++now;
      for (auto const& act : observers) act(*this);
      if (asks() && stop(*this)) return;
    }
  }
};
struct Part {
  char name;
  std::string& log;
  double begins = 0, stops = 1e9;
  bool due(double time) const { return time >= begins; }
  bool after_step(Clock const& clock) {
    log += name;
    return clock.time() >= stops;
  }
};

}  // namespace

TEST_CASE("parts follow each step after the observers, once one of them is due") {
  std::string log;
  Clock clock;
  Part a{'a', log, 3}, b{'b', log, 2};
  scree::run_with(clock, 3, {[&](Clock&) { log += '.'; }}, a, b);
  CHECK(log == "..ab.ab");
  CHECK(clock.now == 3);
}

TEST_CASE("each part acts before the run stops") {
  std::string log;
  Clock clock;
  Part a{'a', log, 0, 2}, b{'b', log};
  scree::run_with(clock, 10, {}, a, b);
  CHECK(log == "abab");
  CHECK(clock.now == 2);
}

TEST_CASE("a part that has begin() sees the solver before the first step") {
  struct Begins {
    double at = -1;
    void begin(Clock const& clock) { at = clock.time(); }
    bool due(double) const { return false; }
    bool after_step(Clock const&) { return false; }
  } part;
  Clock clock{.now = 2};
  scree::run_with(clock, 4, {}, part);
  CHECK(part.at == 2);
  CHECK(clock.now == 4);
}

}  // namespace scree::test::run_with_tests
