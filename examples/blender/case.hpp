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

#include <numbers>
#include <string>

// The options of a tumbling blender whose vessel comes from an STL file. `blender --options` prints the table.
namespace blender {

namespace app = scree::app;

enum class Start { mixed, layers, halves };
constexpr auto names_of(Start) {
  return app::Names<Start, 3>{{{Start::mixed, "mixed"}, {Start::layers, "layers"}, {Start::halves, "halves"}}};
}
enum class Precision { double_precision, single_precision };
constexpr auto names_of(Precision) {
  return app::Names<Precision, 2>{{{Precision::double_precision, "double"}, {Precision::single_precision, "float"}}};
}

struct Vessel {
  std::string file = "v_blender.stl";
  double scale = 1e-3;   // m
  double fill = 0.45;    // of the volume of the vessel
  double speed = 15;     // rpm, about the x axis
  double own_speed = 0;  // rpm, about the vessel's own z axis
};
struct Material {
  double young = 3e5;  // Pa
  double poisson = 0.3;
  double density = 1500;        // kg/m^3
  double grain_density = 2500;  // kg/m^3
  double mu_s = 0.382, mu_d = 0.682, I0 = 0.279;
  double d_small = 1e-3, d_large = 2e-3;  // m
};
struct Segregation {
  Start start = Start::layers;
  double share = 0.5;  // of small grains, by volume
  double chi_V = 0.11, chi_D = 0.0307;
  double interval = 1e-3;  // s
};
struct Numerics {
  double spacing = 5e-3;  // m
  double cfl = 0.4;
  double viscosity_speed = 0.5;  // m/s
  Precision precision = Precision::double_precision;
  int ranks = 1;
};
struct Output {
  double turns = 10;
  double history = 0.05;      // turns
  double frames = 0.25;       // turns
  double sample = 4;          // dr
  double checkpoints = 1800;  // s of wall-clock time
  std::string restart_from = {};
};
struct Options {
  Vessel vessel;
  Material material;
  Segregation segregation;
  app::SpeciesList species;  // if empty, d_small, d_large and share are used
  Numerics numerics;
  Output output;
};

inline double rate(Options const& o) { return o.vessel.speed * 2 * std::numbers::pi / 60; }  // rad/s
inline double turn(Options const& o) { return 60 / o.vessel.speed; }                         // s
/// Returns the number of time steps between evaluations of the segregation.
inline int segregation_period(Options const& o) {
  scree::Elastic const bed{o.material.young, o.material.poisson, o.material.density};
  double const step = o.numerics.cfl * 1.5 * o.numerics.spacing / bed.sound_speed();
  return std::max(1, static_cast<int>(o.segregation.interval / step));
}

inline app::Schema<Options> schema() {
  using scree::parameter_of;
  using Grains = scree::BidisperseGrains;
  using Closure = scree::ShearRateClosure;
  app::Schema<Options> schema;
  schema.section("vessel", &Options::vessel, "The inside of the vessel, and how it turns")
      .add("file", &Vessel::file, {.meaning = "STL or OBJ file, its path from the working directory"})
      .add("scale", &Vessel::scale, {.unit = "m", .range = {1e-6, 1e3}, .meaning = "one unit of the file"})
      .add("fill", &Vessel::fill, {.range = {0.05, 0.9}, .meaning = "volume of the bed over that of the vessel"})
      .add("speed", &Vessel::speed,
           {.unit = "rpm", .range = app::above(0, 200), .meaning = "about the x axis, through the origin of the file"})
      .add("own_speed", &Vessel::own_speed,
           {.unit = "rpm",
            .range = {-200, 200},
            .meaning = "about the z axis of the vessel, through the same point, which goes around with it"});
  schema.section("material", &Options::material, "Elasticity, the mu(I) law and the grains")
      .add("young", &Material::young, parameter_of<&scree::Elastic::young>.within(1, 1e12))
      .add("poisson", &Material::poisson, parameter_of<&scree::Elastic::poisson>.within(0, 0.49))
      .add("density", &Material::density, parameter_of<&scree::Elastic::rest_density>.within(1, 1e5))
      .add("grain_density", &Material::grain_density, parameter_of<&scree::MuOfI<>::grain_density>.within(1, 1e5))
      .add("mu_s", &Material::mu_s, parameter_of<&scree::MuOfI<>::mu_s>.within(1e-3, 2))
      .add("mu_d", &Material::mu_d, parameter_of<&scree::MuOfI<>::mu_d>.within(1e-3, 2))
      .add("I0", &Material::I0, parameter_of<&scree::MuOfI<>::I0>.within(1e-4, 10))
      .add("d_small", &Material::d_small, parameter_of<&Grains::d_small>.within(1e-6, 0.1))
      .add("d_large", &Material::d_large, parameter_of<&Grains::d_large>.within(1e-6, 0.1));
  schema.section("segregation", &Options::segregation, "Two sizes of grains: V = chi_V, D = chi_D d times shear rate d")
      .add("start", &Segregation::start,
           {.meaning = "grains mixed, small ones below large ones, or small ones on one side (x < 0)"})
      .add("share", &Segregation::share,
           {.range = {0.01, 0.99}, .meaning = "volume of the small grains over that of all"})
      .add("chi_V", &Segregation::chi_V, parameter_of<&Closure::chi_V>.within(0, 10))
      .add("chi_D", &Segregation::chi_D, parameter_of<&Closure::chi_D>.within(0, 10))
      .add("interval", &Segregation::interval,
           {.unit = "s", .range = {0, 1}, .meaning = "about the time between evaluations of the segregation"});
  app::describe_species(
      schema, &Options::species,
      "In their order as layers from below or slices along x, with speeds by ratios of sizes",
      {"material.d_small", "material.d_large", "segregation.share", "segregation.chi_V", "segregation.chi_D"});
  schema.section("numerics", &Options::numerics, "Particles (Wendland C2 kernel, h = 1.5 spacings)")
      .add("spacing", &Numerics::spacing, {.unit = "m", .range = {1e-5, 1}, .meaning = "particle spacing dr"})
      .add("cfl", &Numerics::cfl, parameter_of<&scree::Granular<>::cfl>.within(1e-3, 0.5))
      .add("viscosity_speed", &Numerics::viscosity_speed,
           parameter_of<&scree::Granular<>::viscosity_speed>.within(0, 100))
      .add("precision", &Numerics::precision, {.meaning = "of all numbers of the particles"})
      .add("ranks", &Numerics::ranks, app::about_ranks());
  schema.section("output", &Options::output, "Results")
      .add("turns", &Output::turns, {.range = {1e-4, 1e4}, .meaning = "length of the run in turns about the x axis"})
      .add("history", &Output::history, {.range = {1e-5, 100}, .meaning = "turns between rows of history.csv"})
      .add("frames", &Output::frames, {.range = {1e-5, 1e4}, .meaning = "turns between stored states"})
      .add("sample", &Output::sample,
           {.unit = "dr", .range = {2, 100}, .meaning = "edge of the cubes in which the mixture is sampled"})
      .add("checkpoints", &Output::checkpoints, app::about_checkpoints())
      .add("restart_from", &Output::restart_from, app::about_restart());
  schema.require({"material.d_large", [](Options const& o) { return o.material.d_large >= o.material.d_small; },
                  "smaller than material.d_small"});
  schema.require({"material.mu_d", [](Options const& o) { return o.material.mu_d >= o.material.mu_s; },
                  "less than material.mu_s: friction would fall with the shear rate"});
  schema.require({"material.grain_density",
                  [](Options const& o) { return o.material.grain_density >= o.material.density; },
                  "less than material.density, that of the bed with its pores"});
  app::require_ranks<Options>(schema, "numerics.ranks", [](Options const& o) { return o.numerics.ranks; });
  return schema;
}

}  // namespace blender
