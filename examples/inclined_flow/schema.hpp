// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "options.hpp"

#include "../support/schema.hpp"

#include <cmath>
#include <numbers>

// Names, units, ranges and meanings of the options.
namespace inclined_flow {

/// Whether the slope lies between the angle at which flow starts and the one up to which it is steady.
inline bool flows_steadily(Options const& o) {
  auto const k = [](double mu) { return 3 * mu / std::sqrt(9 + 12 * mu * mu); };
  double const slope = std::tan(o.slope.angle * std::numbers::pi / 180);
  return slope > k(o.model.mu_s) && slope < k(o.model.mu_d);
}

inline support::Schema<Options> schema() {
  using support::above;
  support::Schema<Options> schema;
  schema.section("slope", &Options::slope, "The layer and its start")
      .add("angle", &Slope::angle, {.unit = "degrees", .range = {1, 60}, .meaning = "inclination of the slope"})
      .add("diameter", &Slope::diameter, {.unit = "m", .range = above(0, 1), .meaning = "of the grains"})
      .add("depth", &Slope::depth, {.unit = "diameters", .range = {1, 1000}, .meaning = "depth H of the layer"})
      .add("start", &Slope::start, {.range = {0, 10}, .meaning = "initial velocity, in that of the exact profile"});
  schema.section("model", &Options::model, "Friction mu(I)")
      .add("mu_s", &Model::mu_s, {.range = above(0, 3), .meaning = "at rest"})
      .add("mu_d", &Model::mu_d, {.range = above(0, 3), .meaning = "at large I"})
      .add("I0", &Model::I0, {.range = above(0, 10), .meaning = "I at which mu is half way"})
      .add("viscosity_speed", &Model::viscosity_speed,
           {.unit = "m/s", .range = {0, 100}, .meaning = "alpha c_s of the artificial viscosity"});
  schema.section("numerics", &Options::numerics, "Particles (Wendland C2 kernel, h = 1.5 spacings)")
      .add("rows", &Numerics::rows, {.range = {8, 1000}, .meaning = "rows of particles over the depth"})
      .add("sound_speed", &Numerics::sound_speed,
           {.unit = "m/s", .range = above(0, 1000), .meaning = "of compression waves; sets the stiffness"})
      .add("cfl", &Numerics::cfl, {.range = above(0, 0.5), .meaning = "step in h/c_s and in sqrt(h/|acceleration|)"});
  schema.section("output", &Options::output, "Results")
      .add("duration", &Output::duration,
           {.unit = "settling times", .range = above(0, 1e3), .meaning = "length of the run"})
      .add("interval", &Output::interval,
           {.unit = "settling times",
            .range = above(0, 1e3),
            .meaning = "between stored states and rows of history.csv"});
  schema.require(
      {"slope.angle", flows_steadily,
       "no steady flow: its tangent is not between k_mu(mu_s) and k_mu(mu_d), k_mu = 3 mu/sqrt(9 + 12 mu^2)"});
  return schema;
}

}  // namespace inclined_flow
