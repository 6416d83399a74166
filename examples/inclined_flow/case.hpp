// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/app/checkpoints.hpp>
#include <scree/app/figures.hpp>
#include <scree/app/ranks.hpp>
#include <scree/app/start.hpp>
#include <scree/granular/granular.hpp>
#include <scree/laws/well_posedness.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

// The options of a granular flow down a rough slope. `inclined_flow --options` prints the table.
namespace inclined_flow {

namespace app = scree::app;

struct Slope {
  double angle = 24;       // degrees
  double diameter = 5e-4;  // diameter of the grains, m
  double depth = 10;       // depth of the layer, in grain diameters
  double start = 0.7;      // initial velocity over the exact velocity
};

struct Model {
  double mu_s = scree::MuOfI<>{}.mu_s;
  double mu_d = scree::MuOfI<>{}.mu_d;
  double I0 = scree::MuOfI<>{}.I0;
  double viscosity_speed = 0.5;  // m/s, alpha c_s of the artificial viscosity
};

struct Numerics {
  int rows = 20;           // rows of particles over the depth
  double sound_speed = 4;  // m/s
  double cfl = 0.4;
  int ranks = 1;
};

struct Output {
  double duration = 4;        // settling times of the exact flow
  double interval = 0.25;     // settling times
  double checkpoints = 1800;  // s of wall-clock time
  std::string restart_from = {};
};

struct Options {
  Slope slope;
  Model model;
  Numerics numerics;
  Output output;
};

/// Whether the slope is between the angle above which the layer flows and the angle up to which flow is steady.
inline bool flows_steadily(Options const& o) {
  auto const k = [](double mu) { return 3 * mu / std::sqrt(9 + 12 * mu * mu); };
  double const slope = std::tan(o.slope.angle * std::numbers::pi / 180);
  return slope > k(o.model.mu_s) && slope < k(o.model.mu_d);
}

/// Whether the weight of the layer compresses its lowest grains by at most 5 %. K = rho c^2 (1 + nu)/(3 (1 - nu)) with
/// the Poisson ratio of beads(), 0.3.
inline bool is_stiff_enough(Options const& o) {
  double const depth = o.slope.depth * o.slope.diameter, angle = o.slope.angle * std::numbers::pi / 180;
  double const bulk_modulus_over_density = 1.3 / 2.1 * o.numerics.sound_speed * o.numerics.sound_speed;
  return 9.81 * std::cos(angle) * depth <= 0.05 * bulk_modulus_over_density;
}
/// Returns the inertial number of the steady flow, which equals Bagnold::inertial_number() in layer.hpp.
inline double inertial_number(Options const& o) {
  double const k = std::tan(o.slope.angle * std::numbers::pi / 180), mu = 3 * k / std::sqrt(9 - 12 * k * k);
  return o.model.I0 * (mu - o.model.mu_s) / (o.model.mu_d - mu);
}
/// Returns the surface speed in Bagnold's profile (m/s), which equals Bagnold::velocity() at the surface in layer.hpp.
inline double surface_speed(Options const& o) {
  double const angle = o.slope.angle * std::numbers::pi / 180, depth = o.slope.depth * o.slope.diameter;
  double const gravity = 9.81, fraction = 0.6;  // m/s^2, and the volume fraction of the grains
  return 2.0 / 3 * inertial_number(o) / o.slope.diameter * std::sqrt(fraction * gravity * std::cos(angle)) *
         std::pow(depth, 1.5);
}
/// Whether the initial speed of the grains is at most 0.3 times the wave speed in the softened material. Above that,
/// the pressure differs from the pressure in a flow of constant density.
inline bool starts_subsonic(Options const& o) {
  return o.slope.start == 0 || !flows_steadily(o) || o.slope.start * surface_speed(o) <= 0.3 * o.numerics.sound_speed;
}

/// Returns a warning if the law is ill-posed at the inertial number of the steady flow but well-posed at some other
/// one, or an empty string otherwise. The solver itself warns of a law that is ill-posed everywhere.
inline std::string note_on_law(Options const& o) {
  scree::MuOfI<> const law{.mu_s = o.model.mu_s, .mu_d = o.model.mu_d, .I0 = o.model.I0};
  double const I = inertial_number(o);
  auto const bands = scree::well_posed_inertial_numbers(law);
  if (bands.empty() || scree::ill_posedness(law, I) < 0) return "";
  auto const angle = [&](double at) { return std::atan(scree::friction_ratio_at(law, at)) * 180 / std::numbers::pi; };
  auto const [from, to] = bands.front();
  return fmt::format(
      "at {:.4g} degrees the inertial number of the exact flow is {:.3g}, where mu(I) is ill-posed, and the result may "
      "depend on the spacing; it is well-posed from {:.3g} to {:.3g}, on slopes from {:.1f} to {:.1f} degrees "
      "(docs/theory/laws.md, well-posedness)",
      o.slope.angle, I, from, to, angle(from), angle(to));
}

inline app::Schema<Options> schema() {
  app::Schema<Options> schema;
  schema.section("slope", &Options::slope, "The layer and its start")
      .add("angle", &Slope::angle, {.unit = "degrees", .range = {1, 60}, .meaning = "inclination of the slope"})
      .add("diameter", &Slope::diameter, scree::parameter_of<&scree::UniformGrains::diameter>.within(1e-5, 1))
      .add("depth", &Slope::depth, {.unit = "diameters", .range = {1, 1000}, .meaning = "depth H of the layer"})
      .add("start", &Slope::start, {.range = {0, 10}, .meaning = "initial velocity, in that of the exact profile"});
  schema.section("model", &Options::model, "Friction mu(I)")
      .add("mu_s", &Model::mu_s, scree::parameter_of<&scree::MuOfI<>::mu_s>.within(0.01, 3))
      .add("mu_d", &Model::mu_d, scree::parameter_of<&scree::MuOfI<>::mu_d>.within(0.01, 3))
      .add("I0", &Model::I0, scree::parameter_of<&scree::MuOfI<>::I0>.within(1e-4, 10))
      .add("viscosity_speed", &Model::viscosity_speed,
           scree::parameter_of<&scree::Granular<>::viscosity_speed>.within(0, 100));
  schema.section("numerics", &Options::numerics, "Particles (Wendland C2 kernel, h = 1.5 spacings)")
      .add("rows", &Numerics::rows, {.range = {8, 1000}, .meaning = "rows of particles over the depth"})
      .add("sound_speed", &Numerics::sound_speed,
           {.unit = "m/s", .range = {0.01, 1000}, .meaning = "of compression waves; sets the stiffness"})
      .add("cfl", &Numerics::cfl, scree::parameter_of<&scree::Granular<>::cfl>.within(1e-3, 0.5))
      .add("ranks", &Numerics::ranks, app::about_ranks());
  schema.section("output", &Options::output, "Results")
      .add("duration", &Output::duration,
           {.unit = "settling times", .range = {1e-4, 1e3}, .meaning = "length of the run"})
      .add("interval", &Output::interval,
           {.unit = "settling times", .range = {1e-4, 1e3}, .meaning = "between stored states and rows of history.csv"})
      .add("checkpoints", &Output::checkpoints, app::about_checkpoints())
      .add("restart_from", &Output::restart_from, app::about_restart());
  schema.require(
      {"numerics.sound_speed", is_stiff_enough,
       "so low that the layer, slope.depth slope.diameter deep, is strained by more than 5 % by its own weight"});
  schema.require(
      {"slope.angle", flows_steadily,
       "no steady flow: its tangent is not between k_mu(mu_s) and k_mu(mu_d), k_mu = 3 mu/sqrt(9 + 12 mu^2)"});
  schema.require(
      {"slope.start", starts_subsonic,
       "the surface would start at more than 0.3 numerics.sound_speed: start slower or in a stiffer material"});
  app::require_ranks<Options>(schema, "numerics.ranks", [](Options const& o) { return o.numerics.ranks; });
  return schema;
}

/// The results at the end of a run.
struct Outcome {
  double deviation = 0;                              ///< largest relative one from the exact velocity, 0.2 H to 0.8 H
  double ratio = 0;                                  ///< mean velocity over the mean exact velocity
  double settling_time = 0, granular_viscosity = 0;  ///< s, m^2/s
  app::Figures figures = {};
  double wall_seconds = 0;
};
/// Writes summary.json and prints the main results. Defined in main.cpp.
void report(app::Run<Options> const& run, Outcome const& outcome);

}  // namespace inclined_flow
