// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/app/checkpoints.hpp>
#include <scree/app/memory.hpp>
#include <scree/app/ranks.hpp>
#include <scree/app/start.hpp>
#include <scree/granular/granular.hpp>
#include <scree/laws/drucker_prager.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

// The options of a rigid strip or wheel on a bed of soil. `footing_and_wheel --options` prints the table.
namespace footing_and_wheel {

namespace app = scree::app;

enum class Tool { strip, wheel };
constexpr auto names_of(Tool) { return app::Names<Tool, 2>{{{Tool::strip, "strip"}, {Tool::wheel, "wheel"}}}; }

struct Body {
  Tool tool = Tool::wheel;
  double centre = 0.2;  // m
};
struct Strip {
  double width = 1, speed = 0.02;  // m, m/s
};
struct Wheel {
  double radius = 0.1;                                                     // m
  double load = 100;                                                       // N/m
  double turning = 2;                                                      // rad/s
  std::optional<double> slip = {};                                         // if given, sets the travelling speed
  double speed() const { return turning * radius; }                        // speed of the rim, m/s
  double given_speed() const { return speed() * (1 - slip.value_or(0)); }  // speed of the axle, m/s
  double fastest() const { return speed() * (1 - std::min(0.0, slip.value_or(0))); }
};
struct Bed {
  double length = 0.85, depth = 0.1;  // m
};
struct Soil {
  double young = 2e5;  // Pa
  double poisson = 0.3;
  double density = 1500;       // kg/m^3
  double friction_angle = 35;  // degrees
  double cohesion = 0;         // Pa
  double gravity = 9.81;       // m/s^2
};
struct Numerics {
  double spacing = 5e-3;  // m
  double cfl = 0.4;
  double viscosity_speed = 0.5;  // m/s
  int ranks = 1;
};
struct Output {
  double duration = 2;        // s
  double interval = 5e-3;     // s
  double frames = 0.05;       // s
  double checkpoints = 1800;  // s of wall-clock time
  std::string restart_from = {};
};
struct Options {
  Body body;
  Strip strip;
  Wheel wheel;
  Bed bed;
  Soil soil;
  Numerics numerics;
  Output output;
};

inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Returns the bearing capacity (Pa) of frictionless soil under a strip (Prandtl 1920).
inline double bearing_capacity(Options const& o) { return (2 + std::numbers::pi) * o.soil.cohesion; }

inline app::Schema<Options> schema() {
  using scree::parameter_of;
  app::Schema<Options> schema;
  schema.section("body", &Options::body, "The rigid body on the bed")
      .add("tool", &Body::tool, {.meaning = "a strip that is pushed down, or a wheel that is turned"})
      .add("centre", &Body::centre, {.unit = "m", .range = {0, 1e3}, .meaning = "from the left end of the bed"});
  schema.section("strip", &Options::strip, "A footing in plane strain, with a rough base")
      .add("width", &Strip::width, {.unit = "m", .range = {1e-3, 100}, .meaning = "of the base"})
      .add("speed", &Strip::speed, {.unit = "m/s", .range = app::above(0, 10), .meaning = "downwards"});
  schema.section("wheel", &Options::wheel, "A rough wheel in plane strain, a slice of 1 m")
      .add("radius", &Wheel::radius, {.unit = "m", .range = {1e-3, 10}, .meaning = "of the wheel"})
      .add("load", &Wheel::load,
           {.unit = "N/m", .range = app::above(0, 1e7), .meaning = "weight of the wheel and what it carries"})
      .add("turning", &Wheel::turning, {.unit = "rad/s", .range = app::above(0, 100), .meaning = "towards the right"})
      .add("slip", &Wheel::slip,
           {.range = {-2, 1},
            .meaning = "1 - v/(turning radius) of a given travelling speed v",
            .unset = "the wheel travels as fast as the soil lets it, without a drawbar"});
  schema.section("bed", &Options::bed, "A bed between smooth sides on a rough floor")
      .add("length", &Bed::length, {.unit = "m", .range = {1e-2, 1e3}, .meaning = "horizontally"})
      .add("depth", &Bed::depth, {.unit = "m", .range = {1e-3, 100}, .meaning = "of the bed"});
  schema.section("soil", &Options::soil, "Elastic, perfectly plastic, Mohr-Coulomb in plane strain")
      .add("young", &Soil::young, parameter_of<&scree::Elastic::young>.within(1, 1e12))
      .add("poisson", &Soil::poisson, parameter_of<&scree::Elastic::poisson>.within(0, 0.49))
      .add("density", &Soil::density, parameter_of<&scree::Elastic::rest_density>.within(1, 1e5))
      .add("friction_angle", &Soil::friction_angle,
           {.unit = "degrees", .range = {0, 60}, .meaning = "angle of internal friction"})
      .add("cohesion", &Soil::cohesion, parameter_of<&scree::MohrCoulomb::cohesion>.within(0, 1e9))
      .add("gravity", &Soil::gravity, {.unit = "m/s^2", .range = {0, 1e3}, .meaning = "0: weightless soil"});
  schema.section("numerics", &Options::numerics, "Particles (Wendland C2 kernel, h = 1.5 spacings)")
      .add("spacing", &Numerics::spacing, {.unit = "m", .range = {1e-5, 1}, .meaning = "particle spacing dr"})
      .add("cfl", &Numerics::cfl, parameter_of<&scree::Granular<>::cfl>.within(1e-3, 0.5))
      .add("viscosity_speed", &Numerics::viscosity_speed,
           parameter_of<&scree::Granular<>::viscosity_speed>.within(0, 100))
      .add("ranks", &Numerics::ranks, app::about_ranks());
  schema.section("output", &Options::output, "Results")
      .add("duration", &Output::duration, {.unit = "s", .range = {1e-3, 1e5}, .meaning = "length of the run"})
      .add("interval", &Output::interval, {.unit = "s", .range = {1e-5, 1e4}, .meaning = "between rows of history.csv"})
      .add("frames", &Output::frames, {.unit = "s", .range = {1e-5, 1e4}, .meaning = "between stored states"})
      .add("checkpoints", &Output::checkpoints, app::about_checkpoints())
      .add("restart_from", &Output::restart_from, app::about_restart());
  schema.require({"bed.depth", [](Options const& o) { return o.bed.depth >= o.numerics.spacing; },
                  "less than numerics.spacing: no soil"});
  schema.require({"soil.gravity", [](Options const& o) { return o.body.tool == Tool::strip || o.soil.gravity > 0; },
                  "0: a wheel needs its weight"});
  schema.require({"soil.cohesion", [](Options const& o) { return o.soil.cohesion > 0 || o.soil.friction_angle > 0; },
                  "0 without a friction_angle: a soil needs a strength"});
  schema.require({"strip.width",
                  [](Options const& o) {
                    double const w = o.strip.width / 2 + 3 * o.numerics.spacing;
                    return o.body.tool == Tool::wheel || (o.body.centre - w > 0 && o.body.centre + w < o.bed.length);
                  },
                  "so large that the strip touches a side of the bed"});
  schema.require({"output.duration",
                  [](Options const& o) {
                    return o.body.tool == Tool::wheel || o.strip.speed * o.output.duration < o.bed.depth / 2;
                  },
                  "so long that the strip sinks by half the depth of the bed"});
  schema.require({"wheel.radius",
                  [](Options const& o) {
                    return o.body.tool == Tool::strip || (o.wheel.radius > 5 * o.numerics.spacing &&
                                                          o.wheel.radius < o.body.centre - 3 * o.numerics.spacing);
                  },
                  "less than 5 spacings, or so large that the wheel touches the left side"});
  schema.require({"output.duration",
                  [](Options const& o) {
                    return o.body.tool == Tool::strip ||
                           o.body.centre + o.wheel.fastest() * o.output.duration + o.wheel.radius <
                               o.bed.length - 3 * o.numerics.spacing;
                  },
                  "so long that the wheel comes to the right side of the bed"});
  auto const is_strip = [](Options const& o) { return o.body.tool == Tool::strip; };
  auto const is_wheel = [](Options const& o) { return o.body.tool == Tool::wheel; };
  for (auto const* key : {"strip.width", "strip.speed"})
    schema.only_when({key, is_strip, "has no effect unless body.tool = \"strip\""});
  for (auto const* key : {"wheel.radius", "wheel.load", "wheel.turning", "wheel.slip"})
    schema.only_when({key, is_wheel, "has no effect unless body.tool = \"wheel\""});
  app::require_memory<Options>(schema, "numerics.spacing", [](Options const& o) {
    double const dr = o.numerics.spacing;
    return (o.bed.length / dr + 8) * (2 * o.bed.depth / dr + 8);
  });
  app::require_ranks<Options>(schema, "numerics.ranks", [](Options const& o) { return o.numerics.ranks; });
  return schema;
}

}  // namespace footing_and_wheel
