// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/app/checkpoints.hpp>
#include <scree/app/memory.hpp>
#include <scree/app/ranks.hpp>
#include <scree/app/start.hpp>
#include <scree/granular/granular.hpp>

#include <fmt/format.h>

#include <string>

// The options of a granular flow that is released on terrain. `terrain --options` prints the table.
namespace terrain {

namespace app = scree::app;

enum class Precision { double_precision, single_precision };
constexpr auto names_of(Precision) {
  return app::Names<Precision, 2>{{{Precision::double_precision, "double"}, {Precision::single_precision, "float"}}};
}

struct Ground {
  std::string heights = "ground.asc", release = "release.asc";
};
struct Material {
  double young = 1.5e7;  // Pa
  double poisson = 0.3;
  double density = 1800;  // kg/m^3
  double mu_s = 0.382, mu_d = 0.6, I0 = 0.279;
  double diameter = 0.05;  // m
};
struct Numerics {
  double spacing = 2;  // m
  double cfl = 0.4;
  double viscosity_speed = 5;  // m/s
  Precision precision = Precision::double_precision;
  int ranks = 1;
};
struct Output {
  double duration = 40;       // s
  double maps = 5;            // s
  double history = 0.5;       // s
  double cell = 4;            // m
  double least = 0.1;         // m
  double checkpoints = 1800;  // s of wall-clock time
  std::string restart_from = {};
};
struct Options {
  Ground ground;
  Material material;
  Numerics numerics;
  Output output;
};

inline constexpr int most_maps = 100;
inline std::string name_of_map(int number) { return fmt::format("depth_{:02}.asc", number); }

inline app::Schema<Options> schema() {
  using scree::parameter_of;
  app::Schema<Options> schema;
  schema
      .section("ground", &Options::ground,
               "Rasters (ESRI ASCII grids; with GDAL also GeoTIFF), their paths from the working directory")
      .add("heights", &Ground::heights, {.meaning = "heights of the ground (m), without gaps"})
      .add("release", &Ground::release,
           {.meaning = "vertical depth (m) of the grains at the start; gaps mean none; it may be smaller and finer"});
  schema.section("material", &Options::material, "Elasticity and the mu(I) law")
      .add("young", &Material::young, parameter_of<&scree::Elastic::young>.within(1, 1e12))
      .add("poisson", &Material::poisson, parameter_of<&scree::Elastic::poisson>.within(0, 0.49))
      .add("density", &Material::density, parameter_of<&scree::Elastic::rest_density>.within(1, 1e5))
      .add("mu_s", &Material::mu_s, parameter_of<&scree::MuOfI<>::mu_s>.within(1e-3, 2))
      .add("mu_d", &Material::mu_d, parameter_of<&scree::MuOfI<>::mu_d>.within(1e-3, 2))
      .add("I0", &Material::I0, parameter_of<&scree::MuOfI<>::I0>.within(1e-4, 10))
      .add("diameter", &Material::diameter, parameter_of<&scree::UniformGrains::diameter>.within(1e-6, 10));
  schema.section("numerics", &Options::numerics, "Particles (Wendland C2 kernel, h = 1.5 spacings)")
      .add("spacing", &Numerics::spacing, {.unit = "m", .range = {1e-3, 100}, .meaning = "particle spacing dr"})
      .add("cfl", &Numerics::cfl, parameter_of<&scree::Granular<>::cfl>.within(1e-3, 0.5))
      .add("viscosity_speed", &Numerics::viscosity_speed,
           parameter_of<&scree::Granular<>::viscosity_speed>.within(0, 1e3))
      .add("precision", &Numerics::precision, {.meaning = "of all numbers of the particles"})
      .add("ranks", &Numerics::ranks, app::about_ranks());
  schema.section("output", &Options::output, "Results")
      .add("duration", &Output::duration, {.unit = "s", .range = {1e-4, 1e5}, .meaning = "length of the run"})
      .add("maps", &Output::maps,
           {.unit = "s", .range = {1e-4, 1e5}, .meaning = "between depth maps and stored states"})
      .add("history", &Output::history,
           {.unit = "s", .range = {1e-4, 1e5}, .meaning = "between rows of history.csv, and looks for arrivals"})
      .add("cell", &Output::cell, {.unit = "m", .range = {1e-3, 1e3}, .meaning = "of the maps; at least dr"})
      .add("least", &Output::least, {.unit = "m", .range = {1e-4, 100}, .meaning = "depth that counts as arrival"})
      .add("checkpoints", &Output::checkpoints, app::about_checkpoints())
      .add("restart_from", &Output::restart_from, app::about_restart());
  schema.require({"material.mu_d", [](Options const& o) { return o.material.mu_d >= o.material.mu_s; },
                  "less than material.mu_s: friction would fall with the shear rate"});
  schema.require({"output.cell", [](Options const& o) { return o.output.cell >= o.numerics.spacing; },
                  "less than numerics.spacing: the maps would show single particles"});
  schema.require({"output.maps", [](Options const& o) { return o.output.duration / o.output.maps < most_maps - 1; },
                  "too short: there would be more than 100 maps"});
  app::require_ranks<Options>(schema, "numerics.ranks", [](Options const& o) { return o.numerics.ranks; });
  return schema;
}

}  // namespace terrain
