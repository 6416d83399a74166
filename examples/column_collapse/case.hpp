// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/app/checkpoints.hpp>
#include <scree/app/figures.hpp>
#include <scree/app/memory.hpp>
#include <scree/app/ranks.hpp>
#include <scree/app/start.hpp>
#include <scree/granular/granular.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

// The options of a granular column collapse, and the experiments that it is compared with. `column_collapse --options`
// prints the table.
namespace column_collapse {

namespace app = scree::app;

struct Geometry {
  double aspect = 2;    // H0/L0
  double width = 0.05;  // L0, m: half the width of the column, or its radius
};

struct Model {
  double friction_at_rest = 0.382;  // k_mu, the tangent of the friction angle in plane shear
  double friction_at_speed = 0.682;
  double viscosity_speed = 0.5;  // m/s, alpha c_s of the artificial viscosity
};

struct Numerics {
  int dimension = 2;
  int across = 20;  // particles across L0
  double cfl = 0.4;
  std::optional<double> reach = {};  // end of the floor, in L0; if not given, set by the aspect ratio
  int ranks = 1;
};

struct Output {
  double duration = 7;          // sqrt(H0/g)
  double interval = 0.5;        // sqrt(H0/g)
  double reading_depth = 0.05;  // H0
  double checkpoints = 1800;    // s of wall-clock time
  std::string restart_from = {};
};

struct Options {
  Geometry geometry;
  Model model;
  Numerics numerics;
  Output output;
};

// Experimental results for columns of dry grains with aspect ratio a = H0/L0 (height over half width, or over radius).
struct Band {
  double least = 0, greatest = 0;
  bool contains(double value) const { return value >= least && value <= greatest; }
};

/// Returns the range of the run-out (L - L0)/L0 in channels. Lower bound, Lube et al. (2005): 1.2 a up to the change of
/// regime between a = 1.8 and 2.8, then 1.9 a^(2/3). Upper bound, Lajeunesse et al. (2005): 1.8 a up to a = 3, then 2.3
/// a^(2/3).
inline Band run_out_in_channels(double a) {
  double const power = std::pow(a, 2.0 / 3);
  return {a < 2.8 ? 1.2 * a : 1.9 * power, a < 3 ? 1.8 * a : 2.3 * power};
}

/// Returns the range of the run-out (L - L0)/L0 of cylinders that spread in all directions. Lube et al. (2004): 1.24 a
/// up to a = 1.7, then 1.6 sqrt(a). The range is 20 % on either side, for scatter and for uncertainty in the position
/// of the rim.
inline Band run_out_of_cylinders(double a) {
  double const found = a < 1.7 ? 1.24 * a : 1.6 * std::sqrt(a);
  return {0.8 * found, 1.2 * found};
}

inline Band run_out_band(int dimension, double a) {
  return dimension == 2 ? run_out_in_channels(a) : run_out_of_cylinders(a);
}

/// Returns the end of the floor in L0: as given, or else 1 plus twice the largest run-out in the experiments, at least
/// 6.
inline double floor_reach(Options const& o) {
  double const a = o.geometry.aspect;
  double const farthest = run_out_band(o.numerics.dimension, a).greatest;
  return o.numerics.reach.value_or(std::max(6.0, 1 + 2 * farthest));
}

/// The results of a run, see the README in this folder.
struct Outcome {
  double reach = 0, summit = 0, largest_speed = 0;  ///< of the deposit (m, m), and of the particles (m/s)
  app::Figures figures = {};
  double wall_seconds = 0;
};
/// Writes summary.json and prints the run-out next to the experimental range. Defined in main.cpp.
void report(app::Run<Options> const& run, Outcome const& outcome);

inline app::Schema<Options> schema() {
  app::Schema<Options> schema;
  schema.section("geometry", &Options::geometry, "The column, of height H0")
      .add("aspect", &Geometry::aspect, {.range = {0.1, 30}, .meaning = "H0/L0"})
      .add("width", &Geometry::width,
           {.unit = "m", .range = {1e-3, 10}, .meaning = "L0: half its width, in 3D its radius"});
  schema.section("model", &Options::model, "Beads as in Zhu et al. (2024), Table 1; friction k_mu as in plane shear")
      .add("friction_at_rest", &Model::friction_at_rest, {.range = {0.01, 0.85}, .meaning = "k_mu at rest"})
      .add("friction_at_speed", &Model::friction_at_speed, {.range = {0.01, 0.85}, .meaning = "k_mu at large I"})
      .add("viscosity_speed", &Model::viscosity_speed,
           scree::parameter_of<&scree::Granular<>::viscosity_speed>.within(0, 100));
  schema.section("numerics", &Options::numerics, "Particles (Wendland C2 kernel, h = 1.5 spacings)")
      .add("dimension", &Numerics::dimension,
           {.range = {2, 3}, .meaning = "2: half a column; 3: a quarter of a cylinder"})
      .add("across", &Numerics::across, {.range = {6, 1000}, .meaning = "particles over L0"})
      .add("cfl", &Numerics::cfl, scree::parameter_of<&scree::Granular<>::cfl>.within(1e-3, 0.5))
      .add("reach", &Numerics::reach,
           {.unit = "L0",
            .range = {2, 100},
            .meaning = "end of the floor; a run stops when grains fall off it",
            .unset = "1 and twice the greatest run-out of experiments, at least 6"})
      .add("ranks", &Numerics::ranks, app::about_ranks());
  schema.section("output", &Options::output, "Results")
      .add("duration", &Output::duration, {.unit = "sqrt(H0/g)", .range = {1e-3, 1e3}, .meaning = "length of the run"})
      .add("interval", &Output::interval,
           {.unit = "sqrt(H0/g)", .range = {1e-3, 1e3}, .meaning = "between stored states and rows of history.csv"})
      .add("reading_depth", &Output::reading_depth,
           {.unit = "H0", .range = {0.001, 0.5}, .meaning = "depth of the deposit at which the run-out is read"})
      .add("checkpoints", &Output::checkpoints, app::about_checkpoints())
      .add("restart_from", &Output::restart_from, app::about_restart());
  schema.require({"model.friction_at_speed",
                  [](Options const& o) { return o.model.friction_at_speed >= o.model.friction_at_rest; },
                  "smaller than model.friction_at_rest"});
  app::require_ranks<Options>(schema, "numerics.ranks", [](Options const& o) { return o.numerics.ranks; });
  app::require_memory<Options>(schema, "numerics.across", [](Options const& o) {
    double const across = o.numerics.across, far = floor_reach(o) * across;
    double const floor = 3 * std::pow(far, o.numerics.dimension - 1);
    return o.geometry.aspect * std::pow(across, o.numerics.dimension) + floor;
  });
  return schema;
}

}  // namespace column_collapse
