// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "floor.hpp"

#include "../support/room.hpp"

#include <cmath>

// Names, units, ranges and meanings of the options.
namespace column_collapse {

inline support::Schema<Options> schema() {
  support::Schema<Options> schema;
  schema.section("geometry", &Options::geometry, "The column, of height H0")
      .add("aspect", &Geometry::aspect, {.range = {0.1, 30}, .meaning = "H0/L0"})
      .add("width", &Geometry::width,
           {.unit = "m", .range = {1e-3, 10}, .meaning = "L0: half its width, in 3D its radius"});
  schema.section("model", &Options::model, "Beads as in Zhu et al. (2024), Table 1; friction k_mu as in plane shear")
      .add("friction_at_rest", &Model::friction_at_rest, {.range = {0.01, 0.85}, .meaning = "k_mu at rest"})
      .add("friction_at_speed", &Model::friction_at_speed, {.range = {0.01, 0.85}, .meaning = "k_mu at large I"})
      .add("viscosity_speed", &Model::viscosity_speed,
           {.unit = "m/s", .range = {0, 100}, .meaning = "alpha c_s of the artificial viscosity"});
  schema.section("numerics", &Options::numerics, "Particles (Wendland C2 kernel, h = 1.5 spacings)")
      .add("dimension", &Numerics::dimension,
           {.range = {2, 3}, .meaning = "2: half a column; 3: a quarter of a cylinder"})
      .add("across", &Numerics::across, {.range = {6, 1000}, .meaning = "particles over L0"})
      .add("cfl", &Numerics::cfl, {.range = {1e-3, 0.5}, .meaning = "step in h/c_s and in sqrt(h/|acceleration|)"})
      .add("reach", &Numerics::reach,
           {.unit = "L0",
            .range = {2, 100},
            .meaning = "end of the floor; a run stops when grains fall off it",
            .unset = "1 and twice the greatest run-out of experiments, at least 6"});
  schema.section("output", &Options::output, "Results")
      .add("duration", &Output::duration, {.unit = "sqrt(H0/g)", .range = {1e-3, 1e3}, .meaning = "length of the run"})
      .add("interval", &Output::interval,
           {.unit = "sqrt(H0/g)", .range = {1e-3, 1e3}, .meaning = "between stored states and rows of history.csv"})
      .add("reading_depth", &Output::reading_depth,
           {.unit = "H0", .range = {0.001, 0.5}, .meaning = "depth of the deposit at which the run-out is read"});
  schema.require({"model.friction_at_speed",
                  [](Options const& o) { return o.model.friction_at_speed >= o.model.friction_at_rest; },
                  "smaller than model.friction_at_rest"});
  support::require_room<Options>(schema, "numerics.across", [](Options const& o) {
    double const across = o.numerics.across, far = floor_reach(o) * across;
    double const floor = 3 * std::pow(far, o.numerics.dimension - 1);
    return o.geometry.aspect * std::pow(across, o.numerics.dimension) + floor;
  });
  return schema;
}

}  // namespace column_collapse
