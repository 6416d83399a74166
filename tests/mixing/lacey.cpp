// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "bed.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

namespace scree::test::lacey_tests {
using namespace fields;
using namespace mixing;
namespace {
bool near(double a, double b, double by) { return std::abs(a - b) <= by; }
/// C = 1 with the probability p in each particle: particles as grains.
template <class S>
void draw(S& bed, double p, std::uint64_t seed) {
  std::uint64_t k = 0;
  bed.set(concentration, [&](auto const&) { return chance(1000003 * seed + k++) < p ? 1.0 : 0.0; });
}
}  // namespace

TEST_CASE("samples are the cells with particles and what is in them") {
  auto bed = unit_bed<2>(8);
  bed.set(position, [](auto const& x) { return Vec<2, double>(x[0] - 0.5, x[1] < 0.875 ? x[1] : x[1] + 1e9); });
  bed.set(concentration, [](auto const& x) { return x[0] < 0 ? 0.25 : 1.0; });
  auto const samples = samples_of(bed, 0.25, TwoSizes{});
  REQUIRE(samples.size() == 20);  // the last eight particles are far away, where cells end
  double volume = 0;
  for (auto const& each : samples) {
    if (each.centre[1] > 1) continue;
    double const rows = each.centre[1] > 0.75 ? 1 : 2;
    CHECK(near(each.volume, 2 * rows / 64, 1e-15));
    CHECK(near(each.shares[0], each.centre[0] < 0 ? 0.25 : 1, 1e-14));
    CHECK(near(each.shares[0] + each.shares[1], 1, 1e-14));
    CHECK(near(std::abs(std::fmod(each.centre[0], 0.25)), 0.125, 1e-14));
    volume += each.volume;
  }
  CHECK(near(volume, 56.0 / 64, 1e-14));
  CHECK(samples.front().centre == Vec<2, double>(-0.375, 0.125));
}

TEST_CASE("a grid as fine as the particles has a sample for each of them") {
  auto bed = unit_bed<3>(16);
  std::uint64_t k = 0;
  bed.set(concentration, [&](auto const&) { return chance(k++); });
  auto const samples = samples_of(bed, 0.0625, TwoSizes{});
  CHECK(samples.size() == 4096);
  // The variance of the samples is then that of the particles.
  auto const lacey = lacey_index(bed, {.cell = 0.0625});
  auto const intensity = segregation_intensity(bed);
  CHECK(lacey.samples == 4096);
  CHECK(near(lacey.index, 1 - intensity.value, 1e-12));
}

TEMPLATE_TEST_CASE("Lacey's index of kinds that are apart is 0, that of mixed ones 1", "", float, double) {
  auto plane = unit_bed<2, TestType>(20);
  auto space = unit_bed<3, TestType>(12);
  plane.set(concentration, [](auto const& x) { return TestType(x[1] < 0.6f ? 1 : 0); });
  space.set(concentration, [](auto const& x) { return TestType(x[2] < 0.25f ? 1 : 0); });
  CHECK(near(lacey_index(plane, {.cell = 0.2}).index, 0, 1e-12));
  CHECK(near(lacey_index(space, {.cell = 0.25}).index, 0, 1e-12));
  CHECK(lacey_index(plane, {.cell = 0.2}).samples == 25);
  CHECK(lacey_index(space, {.cell = 0.25}).samples == 64);
  plane.set(concentration, [](auto const&) { return TestType(0.3f); });
  CHECK(near(lacey_index(plane, {.cell = 0.2}).index, 1, 1e-12));
}

TEST_CASE("kinds that are mixed within each cell are mixed for Lacey and apart for Danckwerts") {
  auto bed = unit_bed<2>(20);
  bed.set(concentration, [](auto const& x) { return std::fmod(x[1], 0.1) < 0.05 ? 1.0 : 0.0; });
  CHECK(near(lacey_index(bed).index, 1, 1e-12));  // cells of four spacings
  CHECK(near(segregation_intensity(bed).value, 1, 1e-12));
}

TEST_CASE("Lacey's index of a linear profile is 2/3 in thin cells and rises with their size") {
  auto bed = unit_bed<2>(32);
  bed.set(concentration, [](auto const& x) { return x[1]; });
  // The means of n cells of height 1/n: a variance of 1/12 (1 - 1/n^2) over 1/4.
  for (int const cells : {2, 4, 8, 16, 32})
    CHECK(near(lacey_index(bed, {.cell = 1.0 / cells}).index, 1 - (1 - 1.0 / sq(cells)) / 3, 1e-12));
}

TEST_CASE("particles drawn as grains have the index 1 of their size, on average") {
  // 400 samples of 16 grains: the variance of one draw scatters by (2/400)^1/2 of a sixteenth of s_0^2.
  auto bed = unit_bed<2>(80);
  double const grain = 1.0 / 6400;
  for (double const p : {0.5, 0.2}) {
    double with_grains = 0, without = 0;
    int const draws = 20;
    for (int k = 0; k < draws; ++k) {
      draw(bed, p, std::uint64_t(k));
      auto const found = lacey_index(bed, {.grains = {grain}});
      CHECK(near(found.random, found.separated / 16, 1e-12));
      with_grains += found.index / draws, without += lacey_index(bed).index / draws;
    }
    INFO(p);
    double const scatter = std::sqrt(2.0 / 400 / draws) / 16;
    CHECK(near(with_grains, 1, 4 * scatter));
    CHECK(near(without, 1 - 1.0 / 16, 4 * scatter));
  }
}

TEST_CASE("a random mixture of grains of two volumes has the index 1 for these volumes and not for their mean") {
  // A tenth of the grains is 27 times as large: three quarters of the volume.
  auto bed = unit_bed<2>(160);
  double const small = 1.0 / 25600, large = 27 * small;
  double right = 0, mean = 0;
  int const draws = 10;
  for (int k = 0; k < draws; ++k) {
    draw(bed, 0.9, 77 + std::uint64_t(k));
    auto const C = bed.material().to_host(concentration);
    std::size_t i = 0;
    bed.set(volume, [&](auto const&) { return C[i++] == 1 ? small : large; });
    right += lacey_index(bed, {.cell = 0.1, .grains = {small, large}}).index / draws;
    mean += lacey_index(bed, {.cell = 0.1, .grains = {3.6 * small}}).index / draws;
  }
  // 100 samples with 256 grains, of 922 small volumes: s_r^2/s_0^2 = (0.25 * 27 + 0.75 * 1)/922 = 0.0081, not 3.6/922.
  double const scatter = 0.0081 * std::sqrt(2.0 / 100 / draws);
  INFO(right - 1 << " and " << mean - 1 << ", scatter " << scatter);
  CHECK(near(right, 1, 4 * scatter + 1e-3));  // the share is no linear function of the numbers
  CHECK(!near(mean, 1, 4 * scatter + 1e-3));
}

TEST_CASE("N species have the index of two where two of them are alike") {
  auto two = unit_bed<2>(20);
  auto three = unit_bed<2, double, Fields<Concentrations<3>>>(20);
  auto const C = [](auto const& x) { return 0.1 + 0.8 * x[0] * x[1]; };
  two.set(concentration, C);
  three.set(concentrations<3>, [&](auto const& x) { return Vec<3, double>(C(x), 1 - C(x), 0); });
  auto const of_two = lacey_index(two, {.grains = {1e-4, 5e-4}});
  auto const of_three = lacey_index(three, {.grains = {1e-4, 5e-4, 7}});
  CHECK(near(of_three.index, of_two.index, 1e-14));
  CHECK(near(of_three.random, of_two.random, 1e-14));
  CHECK(of_two.random > 1e-3);
}

TEST_CASE("cells that are not filled are no samples, and without samples there is no index") {
  auto bed = unit_bed<2>(20);
  bed.set(concentration, [](auto const& x) { return x[0]; });
  CHECK(lacey_index(bed, {.cell = 0.3}).samples == 9);                // of 16; those along the sides are a third full
  CHECK(lacey_index(bed, {.cell = 0.3, .fill = 0.3}).samples == 15);  // a ninth in the corner
  CHECK(lacey_index(bed, {.cell = 3}).samples == 0);
  CHECK(std::isnan(lacey_index(bed, {.cell = 3}).index));
}

TEST_CASE("settings of Lacey's index that are out of range are refused with their names") {
  auto bed = unit_bed<2>(10);
  bed.set(concentration, [](auto const& x) { return x[0]; });
  auto const message = [&](LaceySettings const& settings) {
    try {
      lacey_index(bed, settings);
    } catch (std::invalid_argument const& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(message({.cell = 0.05}) ==
        "scree: the edge of the cells of samples (m) must be the spacing of the particles, 0.1, or more, not 0.05");
  for (double const bad : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(message({.cell = bad}).find("cell (m) of Lacey's index") != std::string::npos);
    CHECK(message({.fill = bad}).find("fill of Lacey's index") != std::string::npos);
    CHECK(message({.grains = {bad}}).find("grains of Lacey's index") != std::string::npos);
  }
  CHECK(message({.cell = std::numeric_limits<double>::infinity()}) != "");
  CHECK(message({.fill = 1.1}) != "");
  CHECK(message({.grains = {1, 2, 3}}) ==
        "scree: grains of Lacey's index has 3 volumes; it needs one for all kinds, or one for each of the 2");
}

}  // namespace scree::test::lacey_tests
