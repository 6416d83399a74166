// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <example_paths.hpp>

#include <inclined_flow/case.hpp>
#include <scree/app/case_file.hpp>

#include <catch2/catch_test_macros.hpp>

#include <filesystem>

namespace scree::test::inclined_flow_options_tests {
using namespace inclined_flow;

namespace {

std::string errors(std::vector<std::string> const& overrides) {
  try {
    scree::app::read_case(schema(), std::filesystem::path(SCREE_EXAMPLES "/inclined_flow/inclined_flow.toml"),
                          overrides);
  } catch (scree::app::CaseError const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the surface of Bagnold's flow is as fast as the profile says") {
  // 2/3 I/d sqrt(phi g cos(theta)) H^(3/2), I = 0.2347 and 9.7073.
  Options o;
  CHECK(std::abs(surface_speed(o) - 0.2566) < 1e-4);
  o.slope.angle = 28;
  CHECK(std::abs(surface_speed(o) - 10.432) < 1e-2);
}

TEST_CASE("a slope on which the law is ill-posed is noted with the slopes on which it is well-posed") {
  Options o;
  for (double const angle : {20.0, 22.0, 24.0, 26.0}) {
    o.slope.angle = angle;
    CHECK(note_on_law(o).empty());
  }
  for (double const angle : {19.8, 26.5, 28.0}) {
    o.slope.angle = angle;
    CHECK(note_on_law(o).find("from 0.0166 to 0.842, on slopes from 19.9 to 26.4 degrees") != std::string::npos);
  }
  CHECK(note_on_law(o).starts_with("at 28 degrees the inertial number of the exact flow is 9.71, where mu(I) is ill"));
  o.slope.angle = 20, o.model.mu_d = o.model.mu_s + 0.01;
  CHECK(note_on_law(o).empty());
}

TEST_CASE("a flow that would start faster than sound in the softened material is refused") {
  std::string const message =
      "--set: slope.start: the surface would start at more than 0.3 numerics.sound_speed: start slower or in a stiffer "
      "material";
  CHECK(errors({"slope.angle=28", "slope.start=0.7"}) == message);
  CHECK(errors({"slope.angle=28", "slope.start=0.11"}).empty());
  CHECK(errors({"slope.angle=28", "slope.start=0.12"}) == message);
  CHECK(errors({"slope.angle=28", "slope.start=0"}).empty());
  CHECK(errors({"slope.angle=28", "slope.start=0.7", "numerics.sound_speed=30"}).empty());
  for (char const* const angle : {"20", "22", "24", "26"})
    CHECK(errors({std::string("slope.angle=") + angle, "slope.start=1.2"}).empty());
  CHECK(errors({"slope.angle=30"}).find("no steady flow") != std::string::npos);
}

}  // namespace scree::test::inclined_flow_options_tests
