// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/run/checkpoint_policy.hpp>
#include <scree/run/run_study.hpp>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <chrono>
#include <csignal>
#include <set>
#include <string>

namespace scree::test::run_study_tests {
namespace {

using namespace scree;
using Space = Kokkos::DefaultHostExecutionSpace;
using Cases = std::vector<std::function<int(Space const&)>>;

void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

/// Cases that return ten times their number, the first of them the slowest.
Cases tens(int count) {
  Cases cases;
  for (int k = 0; k < count; ++k)
    cases.push_back([=](Space const&) {
      wait(2 * (count - k));
      return 10 * k;
    });
  return cases;
}
template <class Result>
std::string message_of(CaseEnd<Result> const& end) {
  try {
    if (end.failure) std::rethrow_exception(end.failure);
  } catch (std::exception const& error) {
    return error.what();
  }
  return end.begun() ? "" : "not begun";
}

}  // namespace

TEST_CASE("results of a study are in the order of its cases, for any number of workers") {
  for (int const workers : {0, 1, 2, 3, 20}) {
    auto const ends = run_study<Space>(tens(7), workers);
    REQUIRE(ends.size() == 7);
    for (int k = 0; k < 7; ++k) CHECK(ends[std::size_t(k)].result == 10 * k);
  }
  CHECK(run_study<Space>(Cases(), 2).empty());
}

TEST_CASE("a study runs in as many threads as it has workers, each with an instance of its own") {
  std::mutex access;
  std::set<std::thread::id> threads;
  std::vector<Space> instances;
  auto const look = [&](Space const& space) {
    wait(20);
    std::scoped_lock const lock(access);
    if (std::ranges::find(instances, space) == instances.end()) instances.push_back(space);
    threads.insert(std::this_thread::get_id());
    return 0;
  };
  run_study<Space>(Cases(6, look), 3);
  CHECK(threads.size() == 3);
  CHECK(instances.size() == 3);
  CHECK(std::ranges::find(instances, Space()) == instances.end());
}

TEST_CASE("the share of a worker is a part of the threads, one at least") {
  int const threads = Space().concurrency();
  for (int const count : {1, 2, 2 * threads + 1})
    for (Space const& instance : instances_of<Space>(count))
      CHECK(instance.concurrency() == std::max(1, threads / count));
  CHECK(workers_for<Space>(1000) == threads);
  CHECK(workers_for<Space>(1) == 1);
  CHECK(workers_for<Space>(0) == 1);
}

TEST_CASE("a case of a study that throws loses no other case") {
  auto cases = tens(5);
  cases[1] = [](Space const&) -> int { throw std::runtime_error("too steep"); };
  for (int const workers : {1, 3}) {
    auto const ends = run_study<Space>(cases, workers);
    for (std::size_t const k : {0, 2, 3, 4}) CHECK(ends[k].result == 10 * int(k));
    CHECK_FALSE(ends[1].result);
    CHECK(message_of(ends[1]) == "too steep");
  }
}

TEST_CASE("a study tells how each case ended, one at a time") {
  int inside = 0, most = 0;
  std::set<std::size_t> told;
  run_study<Space>(tens(8), 4, [&](std::size_t k, CaseEnd<int> const& end) {
    most = std::max(most, ++inside);
    wait(3);
    CHECK(end.result == 10 * int(k));
    CHECK(told.insert(k).second);
    --inside;
  });
  CHECK(told.size() == 8);
  CHECK(most == 1);
}

TEST_CASE("what a study's listener throws ends the study") {
  int told = 0;
  auto const listen = [&](std::size_t, CaseEnd<int> const&) {
    if (++told == 2) throw std::runtime_error("disk full");
  };
  CHECK_THROWS_WITH(run_study<Space>(tens(50), 1, listen), "disk full");
  CHECK(told == 2);
}

TEST_CASE("after a signal no case of a study begins, and runs under way see it") {
  CheckpointFiles const nowhere{[](auto const&, Snapshot const&) {}, [](auto const&) { return Snapshot(); }};
  for (int const workers : {1, 2}) {
    int stopped = 0;
    std::mutex access;
    Cases cases(20, [&](Space const&) {
      CheckpointPolicy const checkpoints({.file = "none"}, nowhere);  // one in each run at the same time
      {
        std::scoped_lock const lock(access);
        if (stopped == 0) std::raise(SIGTERM);
        ++stopped;
      }
      return checkpoints.exit_code();
    });
    auto const ends = run_study<Space>(cases, workers);
    CHECK(stopped <= workers);
    int not_begun = 0;
    for (auto const& end : ends) {
      not_begun += !end.begun();
      if (end.result) CHECK(end.result == 128 + SIGTERM);
    }
    CHECK(not_begun == 20 - stopped);
  }
}

TEST_CASE("a study refuses a negative number of workers") {
  CHECK_THROWS_WITH(run_study<Space>(tens(1), -1), "scree: the number of workers must be 0 or more, not -1");
  CHECK_THROWS_WITH(instances_of<Space>(0), "scree: the number of instances must be 1 or more, not 0");
}

}  // namespace scree::test::run_study_tests
