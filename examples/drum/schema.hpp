// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "options.hpp"

#include <scree/app/checkpoints.hpp>
#include <scree/app/memory.hpp>
#include <scree/app/ranks.hpp>
#include <scree/app/species_section.hpp>
#include <scree/granular/granular.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/shear_rate_closure.hpp>

#include <functional>

// Names, units, ranges and meanings of the options; options that contradict each other, and options that have no effect
// unless others are set.
namespace drum {

namespace app = scree::app;

using app::Names;

constexpr auto names_of(Ends) { return Names<Ends, 2>{{{Ends::periodic, "periodic"}, {Ends::walled, "walled"}}}; }
constexpr auto names_of(Scheme) {
  return Names<Scheme, 2>{{{Scheme::conservative, "conservative"}, {Scheme::hcsr, "hcsr"}}};
}
constexpr auto names_of(Flux) {
  return Names<Flux, 2>{{{Flux::symmetric, "symmetric"}, {Flux::asymmetric, "asymmetric"}}};
}
constexpr auto names_of(Closure) {
  return Names<Closure, 5>{{{Closure::shear_rate, "shear-rate"},
                            {Closure::schlick, "schlick"},
                            {Closure::trewhela, "trewhela"},
                            {Closure::constant, "constant"},
                            {Closure::none, "none"}}};
}
constexpr auto names_of(Precision) {
  return Names<Precision, 2>{{{Precision::double_precision, "double"}, {Precision::single_precision, "float"}}};
}
constexpr auto names_of(StressFilter) {
  return Names<StressFilter, 3>{
      {{StressFilter::none, "none"}, {StressFilter::shepard, "shepard"}, {StressFilter::linear, "linear"}}};
}
constexpr auto names_of(VolumeControl) {
  return Names<VolumeControl, 3>{
      {{VolumeControl::none, "none"}, {VolumeControl::memory, "memory"}, {VolumeControl::consistency, "consistency"}}};
}
constexpr auto names_of(Filling) {
  return Names<Filling, 2>{{{Filling::rings, "rings"}, {Filling::cartesian, "cartesian"}}};
}

namespace detail {

using scree::BidisperseGrains;
using scree::ConstantClosure;
using scree::Elastic;
using scree::Granular;
using scree::Gravity;
using scree::LinearFilter;
using scree::MuOfI;
using scree::parameter_of;
using scree::ShearRateClosure;
using scree::VolumeConsistency;

inline void describe_drum(app::Schema<Options>& schema) {
  schema.section("geometry", &Options::geometry, "The drum, its filling and its rotation")
      .add("radius", &Geometry::radius, {.unit = "m", .range = {1e-3, 10}, .meaning = "inner radius R"})
      .add("fill_depth", &Geometry::fill_depth,
           {.range = {0.01, 0.95}, .meaning = "depth of the filling over 2 R; 0.42 in EV, 0.591 in EN"})
      .add("length", &Geometry::length, {.unit = "m", .range = {1e-3, 10}, .meaning = "along the axis, in 3D"})
      .add("ends", &Geometry::ends, {.meaning = "both ends of the drum in 3D; walls turn with it"})
      .add("rotation_speed", &Geometry::rotation_speed,
           {.unit = "rpm",
            .range = {-100, 100},
            .meaning = "positive: clockwise with x to the right and z upwards, the surface descends to the right"})
      .add("gravity", &Geometry::gravity, parameter_of<&Gravity::magnitude>.within(1e-3, 1e3));
  schema.section("material", &Options::material, "Table 1: elasticity, the mu(I) law and the grains")
      .add("young", &Material::young, parameter_of<&Elastic::young>.within(1, 1e12))
      .add("poisson", &Material::poisson, parameter_of<&Elastic::poisson>.within(0, 0.49))
      .add("density", &Material::density, parameter_of<&Elastic::rest_density>.within(1, 1e5))
      .add("grain_density", &Material::grain_density, parameter_of<&MuOfI<>::grain_density>.within(1, 1e5))
      .add("mu_s", &Material::mu_s, parameter_of<&MuOfI<>::mu_s>.within(1e-3, 2))
      .add("mu_d", &Material::mu_d, parameter_of<&MuOfI<>::mu_d>.within(1e-3, 2))
      .add("I0", &Material::I0, parameter_of<&MuOfI<>::I0>.within(1e-4, 10))
      .add("d_small", &Material::d_small, parameter_of<&BidisperseGrains::d_small>.within(1e-6, 0.1))
      .add("d_large", &Material::d_large, parameter_of<&BidisperseGrains::d_large>.within(1e-6, 0.1))
      .add("stiffness_factor", &Material::stiffness_factor,
           {.range = {1e-4, 100}, .meaning = "scales young; 1 is Table 1, the step grows as its inverse root"});
}

inline void describe_segregation(app::Schema<Options>& schema) {
  schema.section("segregation", &Options::segregation, "F = A C (1 - C)(1 - kappa C), velocity V and diffusivity D")
      .add("scheme", &Segregation::scheme, {.meaning = "treatment of the boundaries"})
      .add("flux", &Segregation::flux, {.meaning = "A = 1, kappa = 0 (symmetric) or A = 1.6, kappa = 0.89"})
      .add("closure", &Segregation::closure,
           {.meaning = "V and D by (2.7), by Schlick et al. (2015), by Trewhela et al. (2021), constant, or none"})
      .add("C0", &Segregation::C0,
           {.range = {0, 1}, .meaning = "initial concentration of small grains; 0.5 in EV, 1/9 in EN"})
      .add("chi_V", &Segregation::chi_V, parameter_of<&ShearRateClosure::chi_V>.within(0, 10))
      .add("chi_D", &Segregation::chi_D, parameter_of<&ShearRateClosure::chi_D>.within(0, 10))
      .add("V", &Segregation::V, parameter_of<&ConstantClosure::velocity>.within(0, 1))
      .add("D", &Segregation::D, parameter_of<&ConstantClosure::diffusivity>.within(0, 1))
      .add("interval", &Segregation::interval,
           {.unit = "s",
            .range = {0, 1},
            .meaning = "about the time from one evaluation of the segregation to the next; 0: every step"});
}

inline void describe_sizes(app::Schema<Options>& schema) {
  app::describe_species(schema, &Options::species, "In any order",
                        {"material.d_small", "material.d_large", "segregation.C0"});
  auto const two_sizes = [](Options const& o) { return o.species.empty(); };
  schema.require({"segregation.scheme",
                  [=](Options const& o) { return two_sizes(o) || o.segregation.scheme == Scheme::conservative; },
                  "not conservative; with species.diameters there is no other scheme"});
  schema.require({"segregation.flux",
                  [=](Options const& o) { return two_sizes(o) || o.segregation.flux == Flux::symmetric; },
                  "not symmetric; with species.diameters there is no other flux"});
  schema.require({"segregation.closure",
                  [=](Options const& o) {
                    return two_sizes(o) || o.segregation.closure == Closure::schlick ||
                           o.segregation.closure == Closure::none;
                  },
                  "not \"schlick\" or \"none\"; others do not say how species.diameters differ in their speeds"});
}

inline void describe_numerics(app::Schema<Options>& schema) {
  schema.section("numerics", &Options::numerics, "Particles (Wendland C2 kernel) and their steps")
      .add("dimension", &Numerics::dimension, {.range = {2, 3}, .meaning = "2: plane strain; 3: a drum with a length"})
      .add("spacing", &Numerics::spacing,
           {.unit = "m", .range = {1e-5, 1}, .meaning = "particle spacing dr; run time in 2D grows as dr^-3"})
      .add("smoothing", &Numerics::smoothing, {.unit = "dr", .range = {1.1, 3}, .meaning = "smoothing length h"})
      .add("precision", &Numerics::precision, {.meaning = "of all numbers of the particles"})
      .add("filling", &Numerics::filling, {.meaning = "first places of the particles: along the wall or on a lattice"})
      .add("cfl", &Numerics::cfl, parameter_of<&Granular<>::cfl>.within(1e-3, 1))
      .add("viscosity_speed", &Numerics::viscosity_speed, parameter_of<&Granular<>::viscosity_speed>.within(0, 100))
      .add("stress_filter", &Numerics::stress_filter, {.meaning = "smoothing of the stress; the paper's is (3.12)"})
      .add("filter_period", &Numerics::filter_period, parameter_of<&LinearFilter::period>.within(1, 1000000))
      .add("volume_control", &Numerics::volume_control,
           {.meaning = "none as in the paper; memory of expansion; memory and a volume-consistency rate"})
      .add("volume_rate", &Numerics::volume_rate, parameter_of<&VolumeConsistency::per_strain>.within(0, 30))
      .add("ranks", &Numerics::ranks, app::about_ranks());
}

inline void describe_results(app::Schema<Options>& schema) {
  schema.section("time", &Options::time, "Length of the run")
      .add("duration", &Time::duration, {.unit = "s", .range = {0, 1e5}, .meaning = "from the start of the rotation"});
  schema.section("output", &Options::output, "Results")
      .add("history_interval", &Output::history_interval,
           {.unit = "s", .range = {1e-6, 1e5}, .meaning = "between rows of history.csv"})
      .add("frame_interval", &Output::frame_interval,
           {.unit = "s", .range = {1e-6, 1e5}, .meaning = "between the stored states of all particles"})
      .add("profile_times", &Output::profile_times,
           {.unit = "s", .range = {0, 1e5}, .meaning = "rising times of the profiles"})
      .add("profile_average", &Output::profile_average,
           {.unit = "s", .range = {0, 1e3}, .meaning = "a profile is the mean of this long before its time; 0: none"})
      .add("checkpoints", &Output::checkpoints, app::about_checkpoints())
      .add("restart_from", &Output::restart_from, app::about_restart());
  schema.rename("time.restart_from", "output.restart_from");
  schema.rename("output.checkpoint_interval", "output.checkpoints");
}

}  // namespace detail

namespace detail {

inline bool rises(std::vector<double> const& times) {
  return std::ranges::adjacent_find(times, std::greater_equal{}) == times.end();
}

inline void add_contradictions(app::Schema<Options>& schema) {
  schema.require({"numerics.spacing", [](Options const& o) { return o.numerics.spacing <= o.geometry.radius / 10; },
                  "more than a tenth of geometry.radius: too coarse for a drum"});
  schema.require(
      {"geometry.fill_depth",
       [](Options const& o) { return 2 * o.geometry.radius * o.geometry.fill_depth >= 8 * o.numerics.spacing; },
       "the bed, 2 geometry.radius geometry.fill_depth, is less than eight particles (numerics.spacing) deep"});
  schema.require(
      {"geometry.length",
       [](Options const& o) { return o.numerics.dimension == 2 || o.geometry.length >= 3.999 * smoothing_length(o); },
       "less than 4 numerics.smoothing numerics.spacing, in which a particle would meet itself"});
  schema.require({"material.d_large", [](Options const& o) { return o.material.d_large >= o.material.d_small; },
                  "smaller than material.d_small"});
  schema.require({"segregation.flux",
                  [](Options const& o) {
                    auto const closure = o.segregation.closure;
                    return (closure != Closure::schlick && closure != Closure::trewhela) ||
                           o.segregation.flux == Flux::symmetric;
                  },
                  "not symmetric; the speeds of segregation.closure = \"schlick\" and \"trewhela\" are those of the "
                  "symmetric flux"});
  schema.require({"material.grain_density",
                  [](Options const& o) { return o.material.grain_density >= o.material.density; },
                  "less than material.density, that of the bed with its pores"});
  schema.require({"material.mu_d", [](Options const& o) { return o.material.mu_d >= o.material.mu_s; },
                  "less than material.mu_s: friction would fall with the shear rate"});
  schema.require({"material.stiffness_factor",
                  [](Options const& o) {
                    double const depth = 2 * o.geometry.radius * o.geometry.fill_depth;
                    return o.material.density * o.geometry.gravity * depth <= 0.05 * bulk_modulus(o);
                  },
                  "so soft that the bed's own weight strains it by more than 5 %"});
  app::require_ranks<Options>(schema, "numerics.ranks", [](Options const& o) { return o.numerics.ranks; });
  app::require_memory<Options>(schema, "numerics.spacing", number_of_grains);
  schema.require({"output.profile_times", [](Options const& o) { return rises(o.output.profile_times); },
                  "its times do not rise"});
}

inline void add_effects(app::Schema<Options>& schema) {
  auto const in_3d = [](Options const& o) { return o.numerics.dimension == 3; };
  auto const segregates = [](Options const& o) { return o.segregation.closure != Closure::none; };
  auto const by_shear = [](Options const& o) { return o.segregation.closure == Closure::shear_rate; };
  auto const constant = [](Options const& o) { return o.segregation.closure == Closure::constant; };
  auto const filters = [](Options const& o) { return o.numerics.stress_filter != StressFilter::none; };
  for (auto const* key : {"geometry.length", "geometry.ends"})
    schema.only_when({key, in_3d, "has no effect unless numerics.dimension = 3"});
  for (auto const* key : {"segregation.scheme", "segregation.flux"})
    schema.only_when({key, segregates, "has no effect while segregation.closure = \"none\""});
  for (auto const* key : {"segregation.chi_V", "segregation.chi_D"})
    schema.only_when({key, by_shear, "has no effect unless segregation.closure = \"shear-rate\""});
  for (auto const* key : {"segregation.V", "segregation.D"})
    schema.only_when({key, constant, "has no effect unless segregation.closure = \"constant\""});
  schema.only_when({"numerics.volume_rate",
                    [](Options const& o) { return o.numerics.volume_control == VolumeControl::consistency; },
                    "has no effect unless numerics.volume_control = \"consistency\""});
  schema.only_when({"numerics.filter_period", filters, "has no effect while numerics.stress_filter = \"none\""});
}

}  // namespace detail

inline void add_rules(app::Schema<Options>& schema) {
  detail::add_contradictions(schema);
  detail::add_effects(schema);
}

/// The options with name, unit, range and meaning.
inline app::Schema<Options> schema() {
  app::Schema<Options> schema;
  detail::describe_drum(schema);
  detail::describe_segregation(schema);
  detail::describe_sizes(schema);
  detail::describe_numerics(schema);
  detail::describe_results(schema);
  add_rules(schema);
  return schema;
}

}  // namespace drum
