// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "known_bed.hpp"

#include <drum/summary.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::drum_bed_tests {
using Catch::Approx;

namespace {
drum::Moment moment_of(bed::Known const& k, drum::State const& given) {
  auto const drum = bed::drum_of(k);
  auto const state = drum::seen_clockwise(given, drum);
  auto const surface = drum::fit_surface(state, drum);
  drum::MidChord chord;
  chord.add(state, surface, drum);
  return drum::moment(state, surface, chord.mean(state.time, drum), drum);
}
}  // namespace

TEST_CASE("one row of the drum's history says what the bed is") {
  for (bool mirrored : {false, true}) {
    bed::Known const k{.mirrored = mirrored};
    auto const state = bed::state_of(k);
    auto const m = moment_of(k, state);
    CHECK(m.angle == Approx(22).margin(0.1));
    CHECK(m.bed_depth == Approx(k.depth).margin(5e-5));
    CHECK(m.number_density == 1);
    CHECK(m.number_density_min == 1);
    CHECK(m.density_descending == 1);
    CHECK(m.lost == 0);
    CHECK(m.above_surface == 0);
    CHECK(m.largest_radius < k.radius);
    CHECK(m.zero_stress_fraction == 0);
    // The segment's centroid is on the mid-chord, 4 R sin^3(a/2)/(3 (a - sin a)) from the axis.
    double const a = 2 * std::acos(-k.height() / k.radius);
    double const distance = 4 * k.radius * std::pow(std::sin(a / 2), 3) / (3 * (a - std::sin(a)));
    CHECK(m.centroid_x == Approx((mirrored ? 1 : -1) * distance * std::sin(k.angle)).margin(1e-4));
    CHECK(m.centroid_z == Approx(-distance * std::cos(k.angle)).margin(1e-4));
    CHECK(m.C_mean == Approx(k.C(k.height() + distance)).margin(2e-3));  // it ends half a spacing from the wall
    CHECK(m.C_core == Approx(k.C(m.zero_velocity_depth)).margin(3e-3));
    CHECK(m.C_surface == Approx(k.C(0.5e-3)).margin(1e-3));
    CHECK(m.C_periphery > m.C_core);
    CHECK(m.C_min == *std::ranges::min_element(state.C));
    CHECK(m.C_max == *std::ranges::max_element(state.C));
  }
}

TEST_CASE("the drum's history counts what is lost, flies, has no stress or is too far apart") {
  bed::Known const k;
  auto state = bed::state_of(k);
  bed::add(state, k, 0.0351 * std::sin(k.angle + 3.1), 0.0351 * std::cos(k.angle + 3.1));  // leans into the wall
  CHECK(moment_of(k, state).lost == 0);
  bed::add(state, k, 0.0356 * std::sin(k.angle + 3), 0.0356 * std::cos(k.angle + 3));  // beyond its first row
  bed::add(state, k, 0.02, 0.02);
  state.number_density.back() = 0.1;
  state.u.back() = 3, state.w.back() = 4;
  for (std::size_t i = 0; i < state.size(); i += 2)
    for (std::size_t c = 0; c < 6; ++c) state.stress[6 * i + c] = 0;
  double const s = 0.031;  // on the descending side, deep
  double const x = s * std::sin(1.9 + k.angle), z = s * std::cos(1.9 + k.angle);
  bed::add(state, k, x, z);
  state.number_density.back() = 0.75;
  auto const m = moment_of(k, state);
  CHECK(m.lost == 1);
  CHECK(m.above_surface == 1);
  CHECK(m.largest_radius == Approx(0.0356));
  CHECK(m.largest_speed == Approx(5));
  CHECK(m.zero_stress_fraction == Approx(0.5).margin(0.02));
  CHECK(m.number_density_min == 0.75);
  CHECK(m.density_descending < 1);
  CHECK(m.density_ascending == 1);
}

TEST_CASE("mean C of the drum is weighted by volume") {
  drum::State state;
  state.x = state.z = state.u = state.w = {0, 0};
  state.C = {0, 1}, state.volume = {3, 1};
  CHECK(drum::grains(state, {}).C.value() == 0.25);
  CHECK(drum::grains(state, {}).deviation == Approx(std::sqrt(3.0) / 4));
}

TEST_CASE("the drum's rings tell C over the distance from the axis") {
  bed::Known const k;
  auto state = bed::state_of(k);
  for (std::size_t i = 0; i < state.size(); ++i) state.C[i] = std::hypot(state.x[i], state.z[i]) / k.radius;
  drum::Rings rings, twice;
  rings.add(state, bed::drum_of(k));
  twice.add(rings), twice.add(rings);
  CHECK(rings.mean().size() >= 16);
  for (auto const& ring : twice.mean()) CHECK(ring.C == Approx(ring.radius / k.radius));
  CHECK(twice.mean().back().particles == 2 * rings.mean().back().particles);
}

TEST_CASE("steadiness of a drum: mean, spread of one-second means and slope") {
  std::vector<drum::Moment> history;
  for (int k = 0; k <= 400; ++k) {
    drum::Moment m;
    m.time = 0.05 * k;
    double const noise = k % 2 == 0 ? 1e-3 : -1e-3;
    m.bed_depth = m.time < 6 ? 1 : 0.03 + 1e-4 * (m.time - 6) + noise;
    history.push_back(m);
  }
  auto const depth = drum::spread(history, &drum::Moment::bed_depth, 6);
  CHECK(depth.slope == Approx(1e-4).epsilon(1e-6));
  CHECK(depth.mean == Approx(0.0307).margin(5e-6));
  CHECK(depth.largest - depth.least == Approx(1.3e-3).epsilon(1e-6));
  CHECK(std::isnan(drum::spread(history, &drum::Moment::bed_depth, 19.5).mean));
  CHECK(std::isnan(drum::spread({}, &drum::Moment::bed_depth, 0).mean));
}

}  // namespace scree::test::drum_bed_tests
