// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/ranks_text.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cstdio>
#include <cstring>

namespace scree::test::ranks_text_tests {
using namespace scree;
using namespace scree::app;

namespace {

Place on(char const* host, char const* device, int number, int threads) {
  Place place{.number = number, .threads = threads};
  std::snprintf(place.host, sizeof place.host, "%s", host);
  std::snprintf(place.device, sizeof place.device, "%s", device);
  return place;
}

}  // namespace

TEST_CASE("ranks in the same place share a line") {
  Link const link{.latency = 2.5e-6, .bandwidth = 3.21e9};
  CHECK(ranks_text("threads of one process", link, {on("a", "", 0, 1), on("a", "", 0, 1), on("b", "", 0, 4)}) ==
        "3 ranks, threads of one process; between neighbours at least 3.21 GB/s, 8 bytes in 2.5 us\n"
        "  ranks 0 to 1: 1 thread on a\n"
        "  rank 2: 4 threads on b\n");
  CHECK(ranks_text("processes", link, {on("a", "NVIDIA H200", 0, 0), on("a", "NVIDIA H200", 1, 0)}) ==
        "2 ranks, processes; between neighbours at least 3.21 GB/s, 8 bytes in 2.5 us\n"
        "  rank 0: NVIDIA H200 0 on a\n"
        "  rank 1: NVIDIA H200 1 on a\n");
}

TEST_CASE("the table of a profile has a row for each rank, per step") {
  RankProfile rank{.particles = 100, .ghosts = 20, .steps = 10, .builds = 2, .migrated = 3, .seconds = 0.5};
  rank.traffic = {
      .exchanges = 60, .gathers = 10, .messages = 120, .bytes = 40'000, .exchanging = 0.05, .gathering = 0.1};
  RankProfile other = rank;
  other.particles = 300;
  CHECK(profile_text({rank}) == "profile of 10 steps: 50 ms per step, lists built every 5 steps, 100 particles\n");
  CHECK(profile_text({rank, other}) ==
        "profile of 10 steps: 50 ms per step, lists built every 5 steps, 400 particles\n"
        "2 ranks, the largest has 1.500 times the mean; 6 particles went to another rank\n"
        "each step    |      sent      | time in exchanges | in reductions\n"
        "rank  ghosts | messages    kB |     ms    share   |    ms   share\n"
        "   0  20.0 % |     12.0     4 |    5.000  10.0 %  |  10.000  20.0 %\n"
        "   1   6.7 % |     12.0     4 |    5.000  10.0 %  |  10.000  20.0 %\n"
        "Times include waiting for other ranks. Ghosts: share of the rank's own particles.\n");
  CHECK(profile_text({RankProfile{}}) == "profile: no steps\n");
}

}  // namespace scree::test::ranks_text_tests
