// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/app/parts_text.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cstdio>
#include <cstring>

namespace scree::test::parts_text_tests {
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

TEST_CASE("parts in the same place share a line") {
  Link const link{.latency = 2.5e-6, .bandwidth = 3.21e9};
  CHECK(parts_text("threads of one process", link, {on("a", "", 0, 1), on("a", "", 0, 1), on("b", "", 0, 4)}) ==
        "3 parts, threads of one process; between neighbours at least 3.21 GB/s, 8 bytes in 2.5 us\n"
        "  parts 0 to 1: 1 thread on a\n"
        "  part 2: 4 threads on b\n");
  CHECK(parts_text("ranks", link, {on("a", "NVIDIA H200", 0, 0), on("a", "NVIDIA H200", 1, 0)}) ==
        "2 parts, ranks; between neighbours at least 3.21 GB/s, 8 bytes in 2.5 us\n"
        "  part 0: NVIDIA H200 0 on a\n"
        "  part 1: NVIDIA H200 1 on a\n");
}

TEST_CASE("the table of a profile has a row for each part, per step") {
  PartProfile part{.particles = 100, .ghosts = 20, .steps = 10, .builds = 2, .migrated = 3, .seconds = 0.5};
  part.traffic = {
      .exchanges = 60, .gathers = 10, .messages = 120, .bytes = 40'000, .exchanging = 0.05, .gathering = 0.1};
  PartProfile other = part;
  other.particles = 300;
  CHECK(profile_text({part}) == "profile of 10 steps: 50 ms per step, lists built every 5 steps, 100 particles\n");
  CHECK(profile_text({part, other}) ==
        "profile of 10 steps: 50 ms per step, lists built every 5 steps, 400 particles\n"
        "2 parts, the largest has 1.500 times the mean; 6 particles went to another part\n"
        "each step    |      sent      | time in exchanges | in reductions\n"
        "part  ghosts | messages    kB |     ms    share   |    ms   share\n"
        "   0  20.0 % |     12.0     4 |    5.000  10.0 %  |  10.000  20.0 %\n"
        "   1   6.7 % |     12.0     4 |    5.000  10.0 %  |  10.000  20.0 %\n"
        "Times include waiting for other parts. Ghosts: share of the part's own particles.\n");
  CHECK(profile_text({PartProfile{}}) == "profile: no steps\n");
}

}  // namespace scree::test::parts_text_tests
