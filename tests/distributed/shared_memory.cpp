// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/distributed/run_on_parts.hpp>

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

void run(int parts, std::function<void(Team<Host> const&)> const& function) {
  run_on_parts<Host>(parts, [&](Team<Host> const& team, Host const&) { function(team); });
}

}  // namespace

TEST_CASE("each part gets the values of all", "") {
  for (int parts = 1; parts <= 4; ++parts) {
    std::atomic<int> right = 0;
    run(parts, [&](Team<Host> const& team) {
      for (int k = 0; k < 100; ++k) {
        auto const all = team.gather(10 * k + team.part());
        for (int q = 0; q < parts; ++q)
          if (all[std::size_t(q)] == 10 * k + q) ++right;
      }
    });
    CHECK(right == 100 * parts * parts);
  }
}

TEST_CASE("reductions have the same bits on any number of parts", "") {
  std::vector<double> terms(1000);
  for (std::size_t k = 0; k < terms.size(); ++k) terms[k] = std::sin(double(k)) * std::pow(10.0, double(k % 30));
  std::vector<std::array<double, 4>> results;
  for (int parts = 1; parts <= 4; ++parts) {
    run(parts, [&](Team<Host> const& team) {
      ExactSum sum;
      double least = 1e300, most = -1e300;
      for (std::size_t k = std::size_t(team.part()); k < terms.size(); k += std::size_t(parts)) {
        sum += terms[k];
        least = std::min(least, terms[k]), most = std::max(most, terms[k]);
      }
      std::int64_t const count = std::int64_t(terms.size()) / parts + (team.part() < int(terms.size()) % parts ? 1 : 0);
      std::array const all{team.sum(sum), team.smallest(least), team.largest(most), double(team.sum(count))};
      if (team.part() == 0) results.push_back(all);
    });
  }
  for (auto const& each : results) CHECK(each == results.front());
  CHECK(results.front()[3] == 1000);
}

TEST_CASE("messages of any sizes go to all parts, also to the sender", "") {
  for (int parts = 1; parts <= 4; ++parts) {
    std::atomic<int> wrong = 0;
    run_on_parts<Host>(parts, [&](Team<Host> const& team, Host const& space) {
      // Part p sends q + 2 p bytes with the value 16 p + q to part q.
      std::vector<std::byte> sent, received;
      Messages out{nullptr, {0}}, in{nullptr, {0}};
      for (int q = 0; q < parts; ++q) {
        sent.insert(sent.end(), std::size_t(q + 2 * team.part()), std::byte(16 * team.part() + q));
        received.insert(received.end(), std::size_t(team.part() + 2 * q), std::byte(255));
        out.starts.push_back(std::int64_t(sent.size()));
        in.starts.push_back(std::int64_t(received.size()));
      }
      out.bytes = sent.data(), in.bytes = received.data();
      team.exchange(space, out, in);
      for (int q = 0; q < parts; ++q)
        for (std::int64_t k = 0; k < in.size_for(q); ++k)
          if (in.begin_for(q)[k] != std::byte(16 * q + team.part())) ++wrong;
    });
    CHECK(wrong == 0);
  }
}

TEST_CASE("messages that are not of the expected size stop all parts", "") {
  auto const disagree = [] {
    run_on_parts<Host>(2, [&](Team<Host> const& team, Host const& space) {
      std::array<std::byte, 8> bytes{};
      Messages const out{bytes.data(), {0, 2, 4}}, in{bytes.data() + 4, {0, 2, team.part() == 0 ? 3 : 4}};
      team.exchange(space, out, in);
    });
  };
  CHECK_THROWS_WITH(disagree(), ContainsSubstring("part 1 sends 2 bytes, and part 0 expects 1"));
}

TEST_CASE("a part that throws ends all parts with its exception", "") {
  for (int bad = 0; bad < 3; ++bad) {
    std::atomic<int> ended = 0;
    auto const fails = [&] {
      run(3, [&](Team<Host> const& team) {
        struct Count {
          std::atomic<int>& ended;
          ~Count() { ++ended; }
        } const count{ended};
        team.gather(1);
        if (team.part() == bad) throw std::invalid_argument("no sand on part " + std::to_string(bad));
        for (;;) team.gather(2);
      });
    };
    CHECK_THROWS_MATCHES(fails(), std::invalid_argument, Message("no sand on part " + std::to_string(bad)));
    CHECK(ended == 3);
  }
}

TEST_CASE("other parts are told which part failed, and why", "") {
  std::string told;
  CHECK_THROWS_AS(run(2,
                      [&](Team<Host> const& team) {
                        if (team.part() == 0) throw std::domain_error("too wet");
                        try {
                          for (;;) team.gather(0);
                        } catch (OtherPartFailed const& error) {
                          told = error.what();
                          throw;
                        }
                      }),
                  std::domain_error);
  CHECK(told == "scree: part 0 failed: too wet");
}

TEST_CASE("a part that ends while others wait for it stops them", "") {
  auto const leaves = [](int who) {
    run(3, [&](Team<Host> const& team) {
      if (team.part() != who) team.gather(1);
    });
  };
  for (int who = 0; who < 3; ++who)
    CHECK_THROWS_WITH(leaves(who), ContainsSubstring("part " + std::to_string(who) + " has ended before the others"));
}

TEST_CASE("there is at least one part", "") {
  CHECK_THROWS_AS(run(0, [](auto const&) {}), std::invalid_argument);
}

}  // namespace scree::test::shared_memory_tests
