// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/run/observer.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::observer_tests {

namespace {

/// A minimal solver for observers: every step reaches its target.
struct Clock {
  double now = 0;
  double time() const { return now; }
};
using Times = std::vector<double>;

/// Runs a clock; returns the targets it reached.
Times run(Clock& clock, double until, std::vector<Observer<Clock>> const& observers) {
  Times targets;
  Schedule<Clock> schedule(observers, clock);
  while (clock.now < until) {
    targets.push_back(clock.now = schedule.next(until));
    schedule.act(clock);
  }
  return targets;
}
Observer<Clock> noted(Times& times, double interval) {
  return every<Clock>(interval, [&times](Clock& clock) { times.push_back(clock.now); });
}

}  // namespace

TEST_CASE("the last time of a run is met, whatever rounding does to it") {
  for (double const interval : {0.05, 0.1}) {
    double const decimals = 1 / interval;  // exact
    long beyond = 0;
    for (int n = 1; n <= 40 / interval + 0.5; ++n) {
      double const duration = n / decimals;  // as one writes it: 0.05, 0.1, 0.15, ...
      INFO("duration " << duration << ", interval " << interval);
      beyond += n * interval > duration;
      Clock clock;
      Times seen;
      auto const targets = run(clock, duration, {noted(seen, interval)});
      CHECK(seen.size() == std::size_t(n) + 1);
      CHECK(targets.size() == std::size_t(n));  // no step of the size of rounding
      CHECK(clock.now == duration);
    }
    CHECK(beyond > 100);  // where the product exceeds the duration
  }
}

TEST_CASE("times are multiples of the interval, not sums") {
  Clock clock;
  Times seen;
  run(clock, 40, {noted(seen, 0.05)});
  REQUIRE(seen.size() == 801);
  for (std::size_t k = 0; k < 800; ++k) CHECK(seen[k] == double(k) * 0.05);
}

TEST_CASE("a run in pieces meets each time once") {
  for (double const interval : {0.05, 0.1, 0.3, 1.0 / 3}) {
    Times whole, pieces;
    Clock one, other;
    run(one, 30, {noted(whole, interval)});
    for (int k = 1; k <= 300; ++k) run(other, k / 10.0, {noted(pieces, interval)});
    CHECK(pieces.size() == whole.size());
    for (std::size_t k = 0; k < std::min(pieces.size(), whole.size()); ++k)
      CHECK(std::abs(pieces[k] - whole[k]) < 1e-13);
  }
}

TEST_CASE("observers whose times differ by rounding act at one step") {
  Times rows, frames, profiles;
  auto const noted_at = [](Times& times, Times const& at_times) {
    return at<Clock>(at_times, [&times](Clock& clock) { times.push_back(clock.now); });
  };
  Clock clock;
  auto const targets = run(clock, 0.6, {noted(rows, 0.1), noted(frames, 0.3), noted_at(profiles, {0, 0.3, 0.6})});
  CHECK(targets.size() == 6);
  CHECK(rows.size() == 7);
  CHECK(frames == Times{0, rows[3], rows[6]});
  CHECK(profiles == frames);
  run(clock, 0.7, {noted_at(profiles, {0.3, 0.6, 0.65, 0.7})});  // those of the past are over
  CHECK(profiles == Times{0, rows[3], rows[6], 0.65, 0.7});
}

}  // namespace scree::test::observer_tests
