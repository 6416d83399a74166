// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/app/checkpoints.hpp>
#include <scree/app/memory.hpp>
#include <scree/app/ranks.hpp>
#include <scree/app/species_section.hpp>
#include <scree/app/start.hpp>
#include <scree/granular/granular.hpp>
#include <scree/segregation/shear_rate_closure.hpp>

#include <cmath>

// The options of a flat-bottomed silo whose gate opens. `silo --options` prints the table.
namespace silo {

namespace app = scree::app;

struct Geometry {
  double width = 0.12, height = 0.15, outlet = 0.03;  // m
};
struct Material {
  double young = 3e5;  // Pa
  double density = 1500;
  double mu_s = 0.382, mu_d = 0.682;
  double d_small = 0.5e-3, d_large = 1e-3;  // m
  double share = 0.5;
};
struct Numerics {
  int dimension = 2;
  double spacing = 2.5e-3;  // m
  double cfl = 0.4;
  double viscosity_speed = 0.5;  // m/s
  int ranks = 1;
};
struct Output {
  double opens = 0.1, duration = 1.2;     // s
  double interval = 0.02, frames = 0.05;  // s
  double checkpoints = 1800;              // s of wall-clock time
  std::string restart_from = {};
};
struct Options {
  Geometry geometry;
  Material material;
  app::SpeciesList species;  // if empty, d_small, d_large and share are used
  Numerics numerics;
  Output output;
};

/// Returns the coefficient C of Beverloo, Leniger & van de Velde (1961), for rate = C rho sqrt(g) (D - k d)^n with n =
/// 5/2 for a circular outlet (rate in kg/s) and 3/2 for a slot in the plane (rate in kg/(m s)). Material sticks to the
/// edges of the outlet, so the width of the outlet less half a spacing in the plane, or one spacing in space, replaces
/// D - k d.
inline double beverloo(Options const& o, double rate) {
  bool const is_slot = o.numerics.dimension == 2;
  double const n = is_slot ? 1.5 : 2.5, D = o.geometry.outlet - (is_slot ? 0.5 : 1) * o.numerics.spacing;
  return rate / (o.material.density * std::sqrt(9.81) * std::pow(D, n));
}

inline app::Schema<Options> schema() {
  using scree::parameter_of;
  app::Schema<Options> schema;
  schema.section("geometry", &Options::geometry, "The silo")
      .add("width", &Geometry::width,
           {.unit = "m", .range = {1e-3, 100}, .meaning = "of the square floor or the slice"})
      .add("height", &Geometry::height, {.unit = "m", .range = {1e-3, 100}, .meaning = "of the filling"})
      .add("outlet", &Geometry::outlet,
           {.unit = "m", .range = {1e-4, 100}, .meaning = "width of the slot, in 3D diameter of the round hole"});
  schema.section("material", &Options::material, "The mu(I) law; large grains below, small ones above")
      .add("young", &Material::young, parameter_of<&scree::Elastic::young>.within(1e3, 1e12))
      .add("density", &Material::density, parameter_of<&scree::Elastic::rest_density>.within(1, 1e5))
      .add("mu_s", &Material::mu_s, parameter_of<&scree::MuOfI<>::mu_s>.within(1e-3, 2))
      .add("mu_d", &Material::mu_d, parameter_of<&scree::MuOfI<>::mu_d>.within(1e-3, 2))
      .add("d_small", &Material::d_small, parameter_of<&scree::BidisperseGrains::d_small>.within(1e-6, 0.1))
      .add("d_large", &Material::d_large, parameter_of<&scree::BidisperseGrains::d_large>.within(1e-6, 0.1))
      .add("share", &Material::share, {.range = {0, 1}, .meaning = "height of the small grains over that of all"});
  app::describe_species(schema, &Options::species,
                        "Layers in their order from below, with speeds of segregation by ratios of sizes",
                        {"material.d_small", "material.d_large", "material.share"});
  schema.section("numerics", &Options::numerics, "Particles (Wendland C2 kernel, h = 1.5 spacings)")
      .add("dimension", &Numerics::dimension, {.range = {2, 3}, .meaning = "2: a slice with a slot; 3: a round outlet"})
      .add("spacing", &Numerics::spacing, {.unit = "m", .range = {1e-5, 1}, .meaning = "particle spacing dr"})
      .add("cfl", &Numerics::cfl, parameter_of<&scree::Granular<>::cfl>.within(1e-3, 0.5))
      .add("viscosity_speed", &Numerics::viscosity_speed,
           parameter_of<&scree::Granular<>::viscosity_speed>.within(0, 100))
      .add("ranks", &Numerics::ranks, app::about_ranks());
  schema.section("output", &Options::output, "Results")
      .add("opens", &Output::opens, {.unit = "s", .range = {0, 1e4}, .meaning = "time at which the gate drops"})
      .add("duration", &Output::duration, {.unit = "s", .range = {1e-3, 1e5}, .meaning = "length of the run"})
      .add("interval", &Output::interval, {.unit = "s", .range = {1e-4, 1e4}, .meaning = "between rows of history.csv"})
      .add("frames", &Output::frames, {.unit = "s", .range = {1e-4, 1e4}, .meaning = "between stored states"})
      .add("checkpoints", &Output::checkpoints, app::about_checkpoints())
      .add("restart_from", &Output::restart_from, app::about_restart());
  schema.require({"geometry.outlet", [](Options const& o) { return o.geometry.outlet < 0.9 * o.geometry.width; },
                  "more than 0.9 geometry.width"});
  schema.require({"numerics.spacing", [](Options const& o) { return 5 * o.numerics.spacing < o.geometry.outlet; },
                  "more than a fifth of geometry.outlet"});
  schema.require({"material.d_large", [](Options const& o) { return o.material.d_large >= o.material.d_small; },
                  "smaller than material.d_small"});
  schema.require({"material.mu_d", [](Options const& o) { return o.material.mu_d >= o.material.mu_s; },
                  "less than material.mu_s"});
  schema.require(
      {"material.young",
       [](Options const& o) { return o.material.density * 9.81 * o.geometry.height <= 0.05 * o.material.young / 1.2; },
       "so soft that the weight of the filling strains it by more than 5 %"});
  app::require_ranks<Options>(schema, "numerics.ranks", [](Options const& o) { return o.numerics.ranks; });
  app::require_memory<Options>(schema, "numerics.spacing", [](Options const& o) {
    double const dr = o.numerics.spacing, w = o.geometry.width / dr + 8, h = 1.2 * o.geometry.height / dr + 8;
    return o.numerics.dimension == 2 ? w * h : w * w * h;
  });
  return schema;
}

}  // namespace silo
