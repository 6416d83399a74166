// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "column_at_rest.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

// A bed at rest stays at rest under the stress of its own weight. `faults` has the bars; the long forms ([.long]) take
// 50 000 steps, the others fewer. Figures: docs/theory/verification.md.
namespace scree::test::column::column_at_rest_tests {
namespace {

struct Unfiltered : GranularModels {
  using filter = NoFilter;
};
struct WithShepard : GranularModels {
  using filter = ShepardFilter;
};
struct Printed : Unfiltered {
  using walls = PrintedWalls;
};
struct Holding : Unfiltered {
  using walls = HoldingWalls;
};
using Plain = Granular<Unfiltered>;
using Filtered = Granular<>;

template <class Physics>
std::string faults_of(Start const& start, long steps, bool filtered) {
  auto solver = at_rest<Physics>(start);
  auto const samples = watch(solver, steps);
  Sample const& last = samples.back();
  UNSCOPED_INFO("floor " << last.floor << ", rms " << last.rms << ", largest speed " << last.largest_speed
                         << " m/s, creep " << 1e3 * creep(samples) << " mm/s");
  return faults(samples, show_packing(solver), filtered);
}

}  // namespace

TEST_CASE("a column rests without a filter") { CHECK(faults_of<Plain>({}, 5'000, false) == ""); }
TEST_CASE("a column rests under the linear filter") { CHECK(faults_of<Filtered>({}, 5'000, false) == ""); }
TEST_CASE("a column rests for 50 000 steps without a filter", "[.long]") {
  CHECK(faults_of<Plain>({}, 50'000, false) == "");
}
TEST_CASE("a column rests for 50 000 steps under the linear filter", "[.long]") {
  CHECK(faults_of<Filtered>({}, 50'000, false) == "");
}

// States that must not count as a bed at rest, and the bars that detect them.
TEST_CASE("under the Shepard filter a column creeps") {
  using Physics = Granular<WithShepard>;
  CHECK(faults_of<Physics>({}, 2000, true).find("creep") != std::string::npos);
}
TEST_CASE("with the printed sign of (4.3) the floor of a column carries too much") {
  using Physics = Granular<Printed>;
  CHECK(faults_of<Physics>({}, 2000, false).find("floor rms") != std::string::npos);
}
TEST_CASE("a column does not rest on a start outside the yield surface") {
  Start const elastic{.K0 = poisson / (1 - poisson)};  // sqrt(J2) = 0.53 p, where k = 0.35
  CHECK(geostatic_stress_ratio(elastic.K0) > friction_ratio(MuOfI<>{}.mu_s));
  CHECK(faults_of<Plain>(elastic, 2000, false).find("speed") != std::string::npos);
}
TEST_CASE("without viscosity and filter a column does not come to rest") {
  CHECK(faults_of<Plain>({.viscosity_speed = 0}, 5000, false).find("speed") != std::string::npos);
}
TEST_CASE("negative controls of the column for 50 000 steps", "[.long]") {
  using Held = Granular<Holding>;
  CHECK(faults_of<Held>({}, 50'000, false).find("speed growth") != std::string::npos);
  using Shepard = Granular<WithShepard>;
  CHECK(faults_of<Shepard>({}, 50'000, true).find("creep") != std::string::npos);
  CHECK(faults_of<Plain>({.K0 = poisson / (1 - poisson)}, 50'000, false) != "");
  CHECK(faults_of<Plain>({.viscosity_speed = 0}, 50'000, false).find("speed growth") != std::string::npos);
}

}  // namespace scree::test::column::column_at_rest_tests
