// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "known_bed.hpp"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::drum_profile_tests {
using Catch::Approx;

namespace {

drum::Profile chord_of(bed::Known const& k) {
  auto const drum = bed::drum_of(k);
  auto const state = drum::seen_clockwise(bed::state_of(k), drum);
  drum::MidChord chord;
  chord.add(state, drum::fit_surface(state, drum), drum);
  return chord.mean(1.5, drum);
}

/// The depth between two others at which `f` vanishes.
template <class F>
double root(double low, double high, F const& f) {
  for (int k = 0; k < 60; ++k) {
    double const middle = (low + high) / 2;
    (f(low) * f(middle) > 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace

TEST_CASE("the drum's mid-chord profile is the bed's, within 1 % of its largest value") {
  for (bool mirrored : {false, true}) {
    bed::Known const k{.mirrored = mirrored};
    auto const profile = chord_of(k);
    CHECK(profile.time == 1.5);
    CHECK(profile.samples == 1);
    CHECK(profile.bed_depth == Approx(k.depth).margin(0.1 * k.spacing));
    CHECK(profile.rows.size() > 55);
    for (auto const& row : profile.rows) {
      INFO("depth " << row.depth);
      CHECK(row.particles > 5);
      CHECK(row.velocity == Approx(k.velocity(row.depth)).margin(6e-4));
      CHECK(row.speed == Approx(std::abs(k.velocity(row.depth))).margin(1.5e-3));  // the normal part is not zero
      CHECK(row.shear_rate == Approx(k.shear(row.depth)).margin(20));              // of 1000
      CHECK(row.C == Approx(k.C(row.depth)).margin(1e-3));
      CHECK(row.gradient_V_rate == Approx(k.gradient_V_rate(row.depth)).margin(3e-5));  // of 2.5e-3
      CHECK(row.gradient_C_rate == Approx(2 * row.depth).margin(1e-4));
      CHECK(row.diffusion_rate == Approx(3 * row.depth).margin(1e-4));
      CHECK(row.pressure == Approx(k.pressure(row.depth)).margin(4));
      CHECK(row.shear_stress == Approx(0.3 * row.pressure).margin(1e-6));
    }
  }
}

TEST_CASE("depths read off the drum's profile are the bed's, within a fifth of a spacing") {
  for (double spacing : {0.5e-3, 1e-3}) {
    bed::Known const k{.spacing = spacing};
    auto const profile = chord_of(k);
    double const limit = 0.05 * drum::excess(profile, profile.rows.front(), k.omega);
    double const active = root(0, k.active, [&](double d) { return k.excess(d) - limit; });
    CHECK(drum::active_depth(profile, k.omega) == Approx(active).margin(0.2 * spacing));
    double const still = root(0, k.active, [&](double d) { return k.velocity(d); });
    CHECK(drum::zero_velocity_depth(profile) == Approx(still).margin(0.2 * spacing));
    CHECK(drum::most_sheared(profile).depth == Approx(k.active / 2).margin(spacing));
    CHECK(drum::most_sheared(profile).shear_rate == Approx(1000).epsilon(0.03));
    CHECK(drum::passive_shear_rate(profile) == 0);
    CHECK(drum::rate_vanishes_at(profile) == Approx(k.active).margin(1.5 * spacing));
    CHECK(drum::granular_viscosity(profile) == Approx(0.3 * k.pressure(k.active / 2) / 1000).epsilon(0.2));
    // The first millimetre: the mean over its particles is the value at half a millimetre.
    CHECK(profile.surface_speed == Approx(k.velocity(0.5e-3)).epsilon(0.01));
  }
}

TEST_CASE("a drum that turns as a whole has no active layer, and nothing stands still below its axis") {
  auto const profile = chord_of({.surface_excess = 0});
  CHECK(std::isnan(drum::zero_velocity_depth(profile)));
  for (auto const& row : profile.rows) CHECK(drum::excess(profile, row, bed::Known{}.omega) == Approx(0).margin(1e-4));
}

TEST_CASE("the drum's profiles of several times are averaged by particles, and compared at equal depths") {
  bed::Known const slow{.surface_excess = 0.05}, fast{.surface_excess = 0.07}, middle{.surface_excess = 0.06};
  auto const drum = bed::drum_of(slow);
  drum::MidChord sum;
  for (auto const& k : {slow, fast}) {
    drum::MidChord one;
    auto const state = bed::state_of(k);
    one.add(state, drum::fit_surface(state, drum), drum);
    sum.add(one);
  }
  auto const mean = sum.mean(2, drum), exact = chord_of(middle);
  CHECK(mean.samples == 2);
  CHECK(mean.surface_speed == Approx(exact.surface_speed));
  CHECK(mean.rows.front().particles == exact.rows.front().particles);
  CHECK(drum::difference(mean, exact) < 1e-12);
  CHECK(drum::difference(chord_of(fast), exact) == Approx(0.01 * 0.95 / exact.surface_speed).epsilon(0.03));
  CHECK(drum::velocity_at(exact, 1) == exact.rows.back().velocity);
}

}  // namespace scree::test::drum_profile_tests
