// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "known_bed.hpp"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::drum_surface_tests {
using Catch::Approx;

namespace {
drum::Surface surface_of(bed::Known const& k, drum::State const& state) {
  return drum::fit_surface(drum::seen_clockwise(state, bed::drum_of(k)), bed::drum_of(k));
}
}  // namespace

TEST_CASE("the drum's surface is found to 0.1 degrees and a tenth of a spacing") {
  for (double angle : {0.0, 22.0, 30.0}) {
    for (double depth : {0.0294, 0.04137}) {  // EV and EN
      bed::Known const k{.angle = angle * bed::degree, .depth = depth};
      auto const surface = surface_of(k, bed::state_of(k));
      INFO("angle " << angle << ", depth " << depth << ", " << surface.columns << " columns");
      CHECK(surface.columns > 40);
      CHECK(surface.angle / bed::degree == Approx(angle).margin(0.1));
      CHECK(surface.bed_depth(k.radius) == Approx(depth).margin(0.1 * k.spacing));
      CHECK(surface.scatter < 0.15 * k.spacing);
    }
  }
}

TEST_CASE("the drum's surface descends with the rotation, whichever way the drum turns") {
  bed::Known const k{.mirrored = true};
  auto const state = bed::state_of(k);
  CHECK(surface_of(k, state).angle / bed::degree == Approx(22).margin(0.1));
  auto drum = bed::drum_of(k);
  drum.mirrored = false;
  CHECK(drum::fit_surface(state, drum).angle / bed::degree == Approx(-22).margin(0.1));
}

TEST_CASE("particles that fly or climb the wall do not move the drum's surface") {
  bed::Known const k;
  auto state = bed::state_of(k);
  bed::add(state, k, 0.001, 0.01);
  state.number_density.back() = 0.3;
  bed::add(state, k, -0.0345 * std::cos(0.1), 0.0345 * std::sin(0.1));
  CHECK(surface_of(k, state).angle / bed::degree == Approx(22).margin(0.1));
}

TEST_CASE("a drum with too few particles for a surface says so") {
  bed::Known const k;
  drum::State state;
  CHECK(std::isnan(surface_of(k, state).angle));
  bed::add(state, k, 0, -0.01);
  CHECK(std::isnan(surface_of(k, state).angle));
}

TEST_CASE("in 3D the drum's surface is that of the middle third of its length") {
  bed::Known const k{.spacing = 1e-3};
  auto drum = bed::drum_of(k);
  drum.dimension = 3, drum.length = 0.012;
  drum::State state;
  for (int slice = 0; slice < 12; ++slice) {
    bool const inside = std::abs(slice - 5.5) < 2;
    auto const plane = bed::state_of({.spacing = k.spacing, .angle = (inside ? 22 : 30) * bed::degree});
    auto const join = [](std::vector<double>& to, std::vector<double> const& more) {
      to.insert(to.end(), more.begin(), more.end());
    };
    join(state.x, plane.x), join(state.z, plane.z), join(state.number_density, plane.number_density);
    state.y.insert(state.y.end(), plane.size(), (slice - 5.5) * k.spacing);
  }
  auto const surface = drum::fit_surface(state, drum);
  CHECK(surface.angle / bed::degree == Approx(22).margin(0.1));
  CHECK(surface.columns > 2 * 20);
}

TEST_CASE("in 3D no column of the drum's surface is so narrow that its topmost particle lies deep") {
  bed::Known const k{.spacing = 1e-3};
  auto drum = bed::drum_of(k);
  drum.dimension = 3;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0, 1);
  for (double const length : {0.0095, 0.010, 0.0113, 0.012}) {
    drum.length = length;
    drum::State state;
    for (int slice = 0; slice * k.spacing < length; ++slice) {
      auto const plane = bed::state_of(k);
      state.x.insert(state.x.end(), plane.x.begin(), plane.x.end());
      state.z.insert(state.z.end(), plane.z.begin(), plane.z.end());
      state.number_density.insert(state.number_density.end(), plane.size(), 1);
      for (std::size_t i = 0; i < plane.size(); ++i) state.y.push_back((anywhere(random) - 0.5) * length);
    }
    auto const surface = drum::fit_surface(state, drum);
    INFO("length " << length << " m: scatter " << surface.scatter << " m");
    CHECK(surface.scatter < 0.6 * k.spacing);
    CHECK(surface.angle / bed::degree == Approx(22).margin(1));
    CHECK(surface.bed_depth(drum.radius) == Approx(k.depth).margin(0.3e-3));
  }
}

}  // namespace scree::test::drum_surface_tests
