// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/app/checkpoints.hpp>
#include <scree/app/memory.hpp>
#include <scree/app/ranks.hpp>
#include <scree/app/start.hpp>
#include <scree/motion/oscillating_shear.hpp>
#include <scree/segregation/shear_rate_closure.hpp>
#include <scree/segregation/transport.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

// The options of the oscillating shear box of Zhu, Peng & Wu (2024), section 5. Initialisers are the defaults, which
// are the paper's values where the paper gives them. `shear_box --options` prints the table.
namespace shear_box {

namespace app = scree::app;

enum class Scheme { hcsr, conservative };

enum class Flux { symmetric, asymmetric };

/// The choice of the length B in [V] = V T/B, [D] = D T/B^2 of (5.2): the chi values in the paper imply one length, the
/// mixing times quoted there the other.
enum class Reading { chi, times };

enum class Closure { constant, shear_rate };

enum class Precision { double_precision, single_precision };

enum class DepthBoundary { periodic, walled };

struct Geometry {
  double height = 0.087;   // m, H
  double width = 0.0348;   // m, 0.4 H
  double depth = 0.051;    // m, in 3D
  double period = 13;      // s, T
  double amplitude = 30;   // degrees; gamma0 is its tangent
  double d_small = 0.004;  // m, diameter of the small grains
  double d_large = 0.008;  // m, diameter of the large grains
  bool upright = false;
};

struct Model {
  Scheme scheme = Scheme::conservative;
  Flux flux = Flux::symmetric;
  std::optional<double> A = {}, kappa = {};  // if not given, set by the flux
  Reading reading = Reading::chi;
  Closure closure = Closure::constant;
  double V_star = 3.0e-2;   // [V] of (5.2)
  double D_star = 1.01e-3;  // [D] of (5.2)
  double d_bar = 0.006;     // m, (5.5)
};

struct Numerics {
  int dimension = 2;
  double spacing = 0.02;   // dr/H
  double smoothing = 1.5;  // h/dr
  Precision precision = Precision::double_precision;
  DepthBoundary depth_boundary = DepthBoundary::periodic;
  double jitter = 0;  // largest displacement, in dr
  int seed = 1;
  int ranks = 1;
};

struct Time {
  double periods = 120;           // T
  double strain_per_step = 0.05;  // shear strain of the box
  double cfl_segregation = 0.1;   // in h/(A V)
  double cfl_diffusion = 0.1;     // in h^2/D
};

struct Output {
  std::vector<double> compared = {20, 40, 60, 80, 120};  // T
  double history_interval = 0.5;                         // T
  double frame_interval = 5;                             // T
  double reference_spacing = 0.005;                      // H
  double checkpoints = 1800;                             // s of wall-clock time
  std::string restart_from = {};
};

struct Options {
  Geometry geometry;
  Model model;
  Numerics numerics;
  Time time;
  Output output;

  /// Returns A in F = A C (1 - C)(1 - kappa C). With the paper's A for the asymmetric flux, both fluxes have about the
  /// same maximum.
  double flux_amplitude() const { return model.A.value_or(model.flux == Flux::symmetric ? 1.0 : 1.6); }
  double flux_asymmetry() const { return model.kappa.value_or(model.flux == Flux::symmetric ? 0.0 : 0.89); }
};

// Quantities computed from the options alone, in SI units.

inline double gamma0(Options const& o) { return std::tan(o.geometry.amplitude * std::numbers::pi / 180); }

/// Returns the particle spacing dr, m.
inline double spacing(Options const& o) { return o.numerics.spacing * o.geometry.height; }

/// V (m/s) and D (m^2/s) of (5.2), with B = H gamma0 ("chi") or B = H ("times").
struct Coefficients {
  double V, D;
};
inline Coefficients coefficients(Options const& o) {
  double const H = o.geometry.height, T = o.geometry.period;
  double const B = o.model.reading == Reading::chi ? H * gamma0(o) : H;
  return {.V = o.model.V_star * B / T, .D = o.model.D_star * B * B / T};
}

// Names, units, ranges and meanings of the options.

using app::Names;

constexpr auto names_of(Scheme) {
  return Names<Scheme, 2>{{{Scheme::hcsr, "hcsr"}, {Scheme::conservative, "conservative"}}};
}
constexpr auto names_of(Flux) {
  return Names<Flux, 2>{{{Flux::symmetric, "symmetric"}, {Flux::asymmetric, "asymmetric"}}};
}
constexpr auto names_of(Reading) { return Names<Reading, 2>{{{Reading::chi, "chi"}, {Reading::times, "times"}}}; }
constexpr auto names_of(Closure) {
  return Names<Closure, 2>{{{Closure::constant, "constant"}, {Closure::shear_rate, "shear-rate"}}};
}
constexpr auto names_of(Precision) {
  return Names<Precision, 2>{{{Precision::double_precision, "double"}, {Precision::single_precision, "float"}}};
}
constexpr auto names_of(DepthBoundary) {
  return Names<DepthBoundary, 2>{{{DepthBoundary::periodic, "periodic"}, {DepthBoundary::walled, "walled"}}};
}

namespace detail {

inline void describe_box(app::Schema<Options>& schema) {
  schema.section("geometry", &Options::geometry, "The box, its motion and its grains")
      .add("height", &Geometry::height, {.unit = "m", .range = {1e-3, 100}, .meaning = "filling height H"})
      .add("width", &Geometry::width, {.unit = "m", .range = {1e-4, 100}, .meaning = "inner width; 0.4 H"})
      .add("depth", &Geometry::depth, {.unit = "m", .range = {1e-4, 100}, .meaning = "inner depth, in 3D"})
      .add("period", &Geometry::period, scree::parameter_of<&scree::OscillatingShear::period>.within(1e-3, 1e6))
      .add("amplitude", &Geometry::amplitude,
           {.unit = "degrees", .range = {0, 44}, .meaning = "largest inclination of the walls; its tangent is gamma0"})
      .add("d_small", &Geometry::d_small, scree::parameter_of<&scree::ShearRateClosure::d_small>.within(1e-6, 1))
      .add("d_large", &Geometry::d_large, scree::parameter_of<&scree::ShearRateClosure::d_large>.within(1e-6, 1))
      .add("upright", &Geometry::upright, {.meaning = "the box stands still (a test of the scheme)"});
  schema.section("model", &Options::model, "Segregation: F = A C (1 - C)(1 - kappa C), velocity V, diffusivity D")
      .add("scheme", &Model::scheme, {.meaning = "treatment of the boundaries"})
      .add("flux", &Model::flux, {.meaning = "flux function F, with the paper's A and kappa"})
      .add("A", &Model::A, scree::parameter_of<&scree::SegregationFlux::amplitude>.within(0.01, 10),
           "1 (symmetric), 1.6 (asymmetric)")
      .add("kappa", &Model::kappa, scree::parameter_of<&scree::SegregationFlux::asymmetry>,
           "0 (symmetric), 0.89 (asymmetric)")
      .add("reading", &Model::reading,
           {.meaning = "length B in V_star = V T/B, D_star = D T/B^2: B = H gamma0 (chi) or B = H (times)"})
      .add("closure", &Model::closure, {.meaning = "V and D constant, or by (5.5) with shear rate and grain size"})
      .add("V_star", &Model::V_star, {.unit = "1", .range = {0, 1e3}, .meaning = "[V] of (5.2)"})
      .add("D_star", &Model::D_star, {.unit = "1", .range = {0, 1e3}, .meaning = "[D] of (5.2)"})
      .add("d_bar", &Model::d_bar, {.unit = "m", .range = {1e-6, 1}, .meaning = "reference grain size of (5.5)"});
}

inline void describe_method(app::Schema<Options>& schema) {
  schema.section("numerics", &Options::numerics, "Particles (Wendland C2 kernel)")
      .add("dimension", &Numerics::dimension, {.range = {2, 3}, .meaning = "2: a plane; 3: a slab of the given depth"})
      .add("spacing", &Numerics::spacing,
           {.unit = "H", .range = {1e-4, 0.1}, .meaning = "particle spacing dr; run time in 2D grows as dr^-3"})
      .add("smoothing", &Numerics::smoothing, {.unit = "dr", .range = {1.2, 3}, .meaning = "smoothing length h"})
      .add("precision", &Numerics::precision, {.meaning = "of all numbers of the particles"})
      .add("depth_boundary", &Numerics::depth_boundary, {.meaning = "front and back of the slab in 3D"})
      .add("jitter", &Numerics::jitter,
           {.unit = "dr", .range = {0, 0.3}, .meaning = "random displacement of each particle at the start"})
      .add("seed", &Numerics::seed, {.range = {0, 2147483647}, .meaning = "of the random displacements"})
      .add("ranks", &Numerics::ranks, app::about_ranks());
  schema.section("time", &Options::time, "Length of the run and of its steps")
      .add("periods", &Time::periods, {.unit = "T", .range = {0, 1e5}, .meaning = "length of the run"})
      .add("strain_per_step", &Time::strain_per_step,
           scree::parameter_of<&scree::OscillatingShear::strain_per_step>.within(1e-4, 0.2))
      .add("cfl_segregation", &Time::cfl_segregation,
           scree::parameter_of<&scree::TransportStep::segregation>.within(1e-4, 1))
      .add("cfl_diffusion", &Time::cfl_diffusion,
           scree::parameter_of<&scree::TransportStep::diffusion>.within(1e-4, 1));
  schema.section("output", &Options::output, "Results")
      .add("compared", &Output::compared,
           {.unit = "T", .range = {0, 1e5}, .meaning = "rising times at which profiles meet the references"})
      .add("history_interval", &Output::history_interval,
           {.unit = "T", .range = {1e-4, 1e5}, .meaning = "between rows of history.csv"})
      .add("frame_interval", &Output::frame_interval,
           {.unit = "T", .range = {1e-4, 1e5}, .meaning = "between the stored states of all particles"})
      .add("reference_spacing", &Output::reference_spacing,
           {.unit = "H", .range = {5e-4, 0.1}, .meaning = "cells of the two-dimensional reference solution"})
      .add("checkpoints", &Output::checkpoints, app::about_checkpoints())
      .add("restart_from", &Output::restart_from, app::about_restart());
}

}  // namespace detail

/// Returns the schema of the options: name, unit, range and meaning of each.
inline app::Schema<Options> schema() {
  app::Schema<Options> schema;
  detail::describe_box(schema);
  detail::describe_method(schema);

  schema.require({"geometry.d_large", [](Options const& o) { return o.geometry.d_large >= o.geometry.d_small; },
                  "smaller than geometry.d_small"});
  schema.require({"geometry.width",
                  [](Options const& o) { return o.geometry.width >= 3.99 * o.numerics.spacing * o.geometry.height; },
                  "less than four particles wide (numerics.spacing times geometry.height is a particle)"});
  schema.require({"numerics.spacing",
                  [](Options const& o) {
                    auto const whole = [&](double length) {
                      double const particles = length / (o.numerics.spacing * o.geometry.height);
                      return std::abs(particles - std::round(particles)) < 1e-6 * particles;
                    };
                    return whole(o.geometry.height) && whole(o.geometry.width);
                  },
                  "does not divide geometry.height and geometry.width into whole particles"});
  schema.require(
      {"geometry.depth",
       [](Options const& o) {
         bool const periodic = o.numerics.depth_boundary == DepthBoundary::periodic;
         double const particles = std::round(o.geometry.depth / (o.numerics.spacing * o.geometry.height));
         return o.numerics.dimension == 2 || !periodic || particles >= 3.999 * o.numerics.smoothing;
       },
       "less than 4 numerics.smoothing numerics.spacing geometry.height, in which a particle would meet itself"});
  schema.require({"geometry.amplitude",
                  [](Options const& o) {
                    return o.geometry.amplitude > 0 ||
                           (o.model.reading == Reading::times && o.model.closure == Closure::constant);
                  },
                  "0 leaves V and D without a length (model.reading = \"chi\") or a shear rate (model.closure = "
                  "\"shear-rate\")"});
  schema.require({"output.compared",
                  [](Options const& o) {
                    return std::ranges::adjacent_find(o.output.compared, std::greater_equal{}) ==
                           o.output.compared.end();
                  },
                  "its times do not rise"});

  app::require_ranks<Options>(schema, "numerics.ranks", [](Options const& o) { return o.numerics.ranks; });
  app::require_memory<Options>(schema, "numerics.spacing", [](Options const& o) {
    double const dr = o.numerics.spacing * o.geometry.height;
    double const in_plane = o.geometry.height / dr * (o.geometry.width / dr);
    return o.numerics.dimension == 2 ? in_plane : in_plane * o.geometry.depth / dr;
  });

  auto const in_3d = [](Options const& o) { return o.numerics.dimension == 3; };
  auto const moves = [](Options const& o) { return !o.geometry.upright; };
  schema.only_when({"geometry.depth", in_3d, "has no effect unless numerics.dimension = 3"});
  schema.only_when({"numerics.depth_boundary", in_3d, "has no effect unless numerics.dimension = 3"});
  schema.only_when({"numerics.seed", [](Options const& o) { return o.numerics.jitter > 0; },
                    "has no effect while numerics.jitter = 0"});
  schema.only_when({"model.d_bar", [](Options const& o) { return o.model.closure == Closure::shear_rate; },
                    "has no effect unless model.closure = \"shear-rate\""});
  schema.only_when({"time.strain_per_step", moves, "has no effect in a box that stands still"});
  return schema;
}

}  // namespace shear_box
