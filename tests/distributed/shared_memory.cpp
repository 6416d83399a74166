// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/distributed/run_on_threads.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <atomic>
#include <cstring>
#include <functional>

namespace scree::test::shared_memory_tests {
namespace {

using Host = Kokkos::DefaultHostExecutionSpace;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::Message;
static_assert(Transport<SharedMemory, Host>);

void run(int ranks, std::function<void(Team<Host> const&)> const& function) {
  run_on_threads<Host>(ranks, [&](Team<Host> const& team, Host const&) { function(team); });
}

}  // namespace

TEST_CASE("each rank gets the values of all", "") {
  for (int ranks = 1; ranks <= 4; ++ranks) {
    std::atomic<int> right = 0;
    run(ranks, [&](Team<Host> const& team) {
      for (int k = 0; k < 100; ++k) {
        auto const all = team.gather(10 * k + team.rank());
        for (int q = 0; q < ranks; ++q)
          if (all[std::size_t(q)] == 10 * k + q) ++right;
      }
    });
    CHECK(right == 100 * ranks * ranks);
  }
}

TEST_CASE("reductions have the same bits on any number of ranks", "") {
  std::vector<double> terms(1000);
  for (std::size_t k = 0; k < terms.size(); ++k) terms[k] = std::sin(double(k)) * std::pow(10.0, double(k % 30));
  std::vector<std::array<double, 4>> results;
  for (int ranks = 1; ranks <= 4; ++ranks) {
    run(ranks, [&](Team<Host> const& team) {
      ExactSum sum;
      double least = 1e300, most = -1e300;
      for (std::size_t k = std::size_t(team.rank()); k < terms.size(); k += std::size_t(ranks)) {
        sum += terms[k];
        least = std::min(least, terms[k]), most = std::max(most, terms[k]);
      }
      std::int64_t const count = std::int64_t(terms.size()) / ranks + (team.rank() < int(terms.size()) % ranks ? 1 : 0);
      std::array const all{team.sum(sum), team.smallest(least), team.largest(most), double(team.sum(count))};
      if (team.rank() == 0) results.push_back(all);
    });
  }
  for (auto const& each : results) CHECK(each == results.front());
  CHECK(results.front()[3] == 1000);
}

TEST_CASE("messages of any sizes go to all ranks, also to the sender", "") {
  for (int ranks = 1; ranks <= 4; ++ranks) {
    std::atomic<int> wrong = 0;
    run_on_threads<Host>(ranks, [&](Team<Host> const& team, Host const& space) {
      // Rank p sends q + 2 p bytes with the value 16 p + q to rank q.
      std::vector<std::byte> sent, received;
      Messages out{nullptr, {0}}, in{nullptr, {0}};
      for (int q = 0; q < ranks; ++q) {
        sent.insert(sent.end(), std::size_t(q + 2 * team.rank()), std::byte(16 * team.rank() + q));
        received.insert(received.end(), std::size_t(team.rank() + 2 * q), std::byte(255));
        out.starts.push_back(std::int64_t(sent.size()));
        in.starts.push_back(std::int64_t(received.size()));
      }
      out.bytes = sent.data(), in.bytes = received.data();
      team.exchange(space, out, in);
      for (int q = 0; q < ranks; ++q)
        for (std::int64_t k = 0; k < in.size_for(q); ++k)
          if (in.begin_for(q)[k] != std::byte(16 * q + team.rank())) ++wrong;
    });
    CHECK(wrong == 0);
  }
}

TEST_CASE("messages that are not of the expected size stop all ranks", "") {
  auto const disagree = [] {
    run_on_threads<Host>(2, [&](Team<Host> const& team, Host const& space) {
      std::array<std::byte, 8> bytes{};
      Messages const out{bytes.data(), {0, 2, 4}}, in{bytes.data() + 4, {0, 2, team.rank() == 0 ? 3 : 4}};
      team.exchange(space, out, in);
    });
  };
  CHECK_THROWS_WITH(disagree(), ContainsSubstring("rank 1 sends 2 bytes, and rank 0 expects 1"));
}

TEST_CASE("a rank that throws ends all ranks with its exception", "") {
  for (int bad = 0; bad < 3; ++bad) {
    std::atomic<int> ended = 0;
    auto const fails = [&] {
      run(3, [&](Team<Host> const& team) {
        struct Count {
          std::atomic<int>& ended;
          ~Count() { ++ended; }
        } const count{ended};
        team.gather(1);
        if (team.rank() == bad) throw std::invalid_argument("no sand on rank " + std::to_string(bad));
        for (;;) team.gather(2);
      });
    };
    CHECK_THROWS_MATCHES(fails(), std::invalid_argument, Message("no sand on rank " + std::to_string(bad)));
    CHECK(ended == 3);
  }
}

TEST_CASE("other ranks are told which rank failed, and why", "") {
  std::string told;
  CHECK_THROWS_AS(run(2,
                      [&](Team<Host> const& team) {
                        if (team.rank() == 0) throw std::domain_error("too wet");
                        try {
                          for (;;) team.gather(0);
                        } catch (OtherRankFailed const& error) {
                          told = error.what();
                          throw;
                        }
                      }),
                  std::domain_error);
  CHECK(told == "scree: rank 0 failed: too wet");
}

TEST_CASE("a rank that ends while others wait for it stops them", "") {
  auto const leaves = [](int who) {
    run(3, [&](Team<Host> const& team) {
      if (team.rank() != who) team.gather(1);
    });
  };
  for (int who = 0; who < 3; ++who)
    CHECK_THROWS_WITH(leaves(who), ContainsSubstring("rank " + std::to_string(who) + " has ended before the others"));
}

TEST_CASE("there is at least one rank", "") {
  CHECK_THROWS_AS(run(0, [](auto const&) {}), std::invalid_argument);
}

}  // namespace scree::test::shared_memory_tests
