// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/run/checkpoint_policy.hpp>

#include <catch2/catch_test_macros.hpp>

#include <limits>
#include <stdexcept>

namespace scree::test::checkpoint_policy_tests {
using namespace scree;

namespace {

/// A solver of given time, and the times of the checkpoints that a policy writes.
struct Run {
  double now = 0;
  std::vector<double> written = {};
  double time() const { return now; }
  Snapshot snapshot() const {
    Snapshot result;
    result.time = now;
    return result;
  }
  CheckpointPolicy policy(double time_interval) {
    return {{.file = "unused", .interval = 1e9, .time_interval = time_interval},
            {[this](auto const&, Snapshot const& snapshot) { written.push_back(snapshot.time); }, {}}};
  }
};

}  // namespace

TEST_CASE("checkpoints come after multiples of an interval of simulated time") {
  Run run;
  auto policy = run.policy(0.1);
  for (int step = 1; step <= 13; ++step) {
    run.now = step / 40.0;
    CHECK(policy.due(run.now) == (step % 4 == 0));
    CHECK_FALSE(policy.after_step(run));
  }
  CHECK(run.written == std::vector<double>{0.1, 0.2, 0.3});
  run.now = 0.75;  // a step longer than the interval
  policy.after_step(run);
  run.now = 0.79;
  policy.after_step(run);
  CHECK(run.written.size() == 4);
}

TEST_CASE("a run that starts late keeps the multiples of the interval") {
  Run run;
  auto policy = run.policy(10);
  for (double const time : {23.0, 29.0, 31.0}) {
    run.now = time;
    policy.after_step(run);
  }
  CHECK(run.written == std::vector<double>{31});
}

TEST_CASE("without an interval of simulated time only wall time counts") {
  Run run;
  auto policy = run.policy(std::numeric_limits<double>::infinity());
  CHECK_FALSE(policy.due(1e300));
  CHECK_FALSE(policy.due());
}

TEST_CASE("names and notes that a file cannot hold are refused before the run") {
  for (char const* name : {"", "/x", ".", "a//b", "two\nlines"}) {
    CHECK_THROWS_AS(CheckpointPolicy({.file = "unused", .notes = {{name, "text"}}}, {}), std::invalid_argument);
    CHECK_THROWS_AS(Run{}.policy(1).keep(name, {}), std::invalid_argument);
  }
  CHECK_THROWS_AS(CheckpointPolicy({.file = "unused", .notes = {{"a", ""}, {"a/b", ""}}}, {}), std::invalid_argument);
  CHECK_THROWS_AS(CheckpointPolicy({.file = "unused", .notes = {{"a", std::string(1, '\0')}}}, {}),
                  std::invalid_argument);
  CHECK_NOTHROW(CheckpointPolicy({.file = "unused", .notes = {{"a/b", ""}, {"a/c", ""}}}, {}));
  Run run;
  auto policy = run.policy(1);
  CHECK_NOTHROW(policy.keep("a", {}));
  CHECK_NOTHROW(policy.keep("a", {}));
  CHECK_THROWS_AS(policy.keep("a/b", {}), std::invalid_argument);
}

TEST_CASE("intervals of checkpoints must be positive") {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  for (double const bad : {0.0, -1.0, nan}) CHECK_THROWS_AS(Run{}.policy(bad), std::invalid_argument);
  for (double const bad : {-1.0, nan})
    CHECK_THROWS_AS(CheckpointPolicy({.file = "unused", .interval = bad}, {}), std::invalid_argument);
}

}  // namespace scree::test::checkpoint_policy_tests
