// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "moment.hpp"
#include "scaling.hpp"
#include "schema.hpp"

#include <scree/app/summary.hpp>

// Steadiness of a run (means and spreads of its history), and the contents of summary.json.
namespace drum {

/// Spread of one quantity over a span of time, from means over blocks of one second, which average out the noise of
/// particles that pass the surface one by one. NaN without a whole block.
struct Spread {
  double mean = detail::missing(), least = detail::missing(), largest = detail::missing();
  double slope = detail::missing();  ///< per s, of the straight line through the blocks
};

namespace detail {

struct Block {
  double time, mean;
};
inline std::vector<Block> blocks(std::vector<Moment> const& history, double Moment::*quantity, double from) {
  std::map<long, std::pair<Mean, Mean>> seconds;  // time, value
  for (auto const& m : history) {
    if (m.time < from || std::isnan(m.*quantity)) continue;
    auto& [time, value] = seconds[std::lround(std::floor(m.time - from))];
    time.add(m.time), value.add(m.*quantity);
  }
  std::vector<Block> result;
  for (auto const& [second, means] : seconds)
    if (history.back().time >= from + double(second) + 1 - 1e-6)
      result.push_back({means.first.value(), means.second.value()});
  return result;
}

}  // namespace detail

inline Spread spread(std::vector<Moment> const& history, double Moment::*quantity, double from) {
  Spread s;
  if (history.empty()) return s;
  auto const found = detail::blocks(history, quantity, from);
  Mean time, value;
  for (auto const& b : found) time.add(b.time), value.add(b.mean);
  s.mean = value.value(), s.least = value.lowest(), s.largest = value.highest();
  double tt = 0, tv = 0;
  for (auto const& b : found) {
    tt += (b.time - time.value()) * (b.time - time.value());
    tv += (b.time - time.value()) * (b.mean - value.value());
  }
  s.slope = tv / tt;
  return s;
}

struct Findings {
  Options options;
  app::Figures figures;
  std::vector<Moment> const& history;
  std::vector<Profile> const& profiles;
};

/// Time after which a run counts as steady, s: half a turn, or half of a run that ends less than two seconds after it.
inline double steady_from(Options const& o, double end) { return half_turn(o) + 2 <= end ? half_turn(o) : end / 2; }

namespace detail {

using app::Json;

inline Json::Object as_json(Spread const& s) {
  return {{"mean", s.mean}, {"min", s.least}, {"max", s.largest}, {"slope_per_s", s.slope}};
}

inline Json::Object as_json(Profile const& profile, Profile const& last, double omega) {
  double const D = profile.bed_depth;
  auto const& peak = most_sheared(profile);
  return {{"time", profile.time},
          {"samples", profile.samples},
          {"bed_depth", D},
          {"surface_speed", profile.surface_speed},
          {"active_depth_over_bed_depth", active_depth(profile, omega) / D},
          {"zero_velocity_depth_over_bed_depth", zero_velocity_depth(profile) / D},
          {"peak_shear_rate", peak.shear_rate},
          {"peak_shear_rate_depth_over_bed_depth", peak.depth / D},
          {"passive_over_peak_shear_rate", passive_shear_rate(profile) / peak.shear_rate},
          {"gradient_V_rate_vanishes_at_depth_over_bed_depth", rate_vanishes_at(profile) / D},
          {"velocity_difference_from_last", difference(profile, last)}};
}

inline void add_case(Json::Object& all, Options const& o) {
  auto const& n = o.numerics;
  Json::Object const names{{"scheme", app::name_of(o.segregation.scheme)},
                           {"flux", app::name_of(o.segregation.flux)},
                           {"closure", app::name_of(o.segregation.closure)},
                           {"precision", app::name_of(n.precision)},
                           {"filling", app::name_of(n.filling)},
                           {"stress_filter", app::name_of(n.stress_filter)},
                           {"volume_control", app::name_of(n.volume_control)},
                           {"dimension", n.dimension},
                           {"spacing", n.spacing},
                           {"stiffness_factor", o.material.stiffness_factor},
                           {"sound_speed", sound_speed(o)},
                           {"artificial_viscosity_alpha", artificial_viscosity(o)},
                           {"artificial_dynamic_viscosity", artificial_dynamic_viscosity(o)}};
  all.insert(all.end(), names.begin(), names.end());
}

inline void add_costs(Json::Object& all, Findings const& r) {
  Json::Object limits;
  for (auto const& [name, count] : r.figures.steps_by_limit) limits.emplace_back(name, count);
  double const wall = r.history.empty() ? 0 : r.history.back().wall_seconds,
               steps = std::max(1.0, double(r.figures.steps));
  Json::Object const costs{{"time", r.figures.time},
                           {"duration", r.options.time.duration},
                           {"execution_space", r.figures.execution_space},
                           {"particles", r.figures.particles},
                           {"wall_particles", r.figures.wall_particles},
                           {"lost", r.figures.lost},
                           {"steps", r.figures.steps},
                           {"dt", r.figures.time / steps},
                           {"steps_by_limit", limits},
                           {"rebuilds", r.figures.neighbour_builds},
                           {"wall_seconds", wall},
                           {"microseconds_per_step", 1e6 * wall / steps}};
  all.insert(all.end(), costs.begin(), costs.end());
}

inline void add_extremes(Json::Object& all, Findings const& r) {
  Mean drift, C, lost, above, speed, radius, density;
  for (auto const& m : r.history) {
    drift.add(std::abs(m.C_mean - r.history.front().C_mean));
    C.add(m.C_min), C.add(m.C_max);
    lost.add(m.lost), above.add(m.above_surface), speed.add(m.largest_speed), radius.add(m.largest_radius);
    if (m.number_density_min > 0) density.add(m.number_density_min);
  }
  Json::Object const extremes{{"mean_C", r.history.empty() ? missing() : r.history.back().C_mean},
                              {"mean_C_drift", drift.highest()},
                              {"min_C", C.lowest()},
                              {"max_C", C.highest()},
                              {"intensity", r.history.empty() ? missing() : r.history.back().intensity},
                              {"lacey", r.history.empty() ? missing() : r.history.back().lacey},
                              {"lost_particles", lost.highest()},
                              {"particles_above_surface", above.highest()},
                              {"largest_radius_over_R", radius.highest() / r.options.geometry.radius},
                              {"largest_speed_over_sound_speed", speed.highest() / sound_speed(r.options)},
                              {"least_number_density", density.lowest()}};
  all.insert(all.end(), extremes.begin(), extremes.end());
  app::add_packing(all, r.figures.packing);
}

inline void add_scaling(Json::Object& all, Findings const& r, double bed_depth, double layer_depth) {
  auto const s = scaling(r.options, bed_depth, layer_depth);
  auto const rise = rise_of_segregation(r.history);
  all.emplace_back("scaling", Json::Object{{"layer_depth", s.layer_depth},
                                           {"half_surface", s.half_surface},
                                           {"epsilon", s.epsilon},
                                           {"Lambda", s.lambda},
                                           {"Pe", s.peclet},
                                           {"Froude", s.froude},
                                           {"degree", rise.last},
                                           {"time", rise.time},
                                           {"time_in_turns", rise.time / (2 * half_turn(r.options))},
                                           {"deviation", rise.error}});
}

inline void add_flow(Json::Object& all, Findings const& r) {
  double const from = steady_from(r.options, r.figures.time), omega = std::abs(angular_velocity(r.options));
  auto const steady = [&](double Moment::*quantity) { return spread(r.history, quantity, from); };
  auto const depth = steady(&Moment::bed_depth);
  Json::Object const flow{
      {"steady_from", from},
      {"surface_angle", as_json(steady(&Moment::angle))},
      {"surface_scatter", as_json(steady(&Moment::surface_scatter))},
      {"surface_speed", as_json(steady(&Moment::surface_speed))},
      {"bed_depth", as_json(depth)},
      {"bed_depth_variation", (depth.largest - depth.least) / depth.mean},
      {"active_depth_over_bed_depth", steady(&Moment::active_depth).mean / depth.mean},
      {"zero_velocity_depth_over_bed_depth", steady(&Moment::zero_velocity_depth).mean / depth.mean},
      {"number_density", as_json(steady(&Moment::number_density))},
      {"zero_stress_fraction", as_json(steady(&Moment::zero_stress_fraction))}};
  all.insert(all.end(), flow.begin(), flow.end());
  add_scaling(all, r, depth.mean, steady(&Moment::zero_velocity_depth).mean);
  if (r.profiles.empty()) return;
  all.emplace_back("granular_dynamic_viscosity", granular_viscosity(r.profiles.back()));
  Json::Array profiles;
  for (auto const& profile : r.profiles)
    if (!profile.rows.empty()) profiles.emplace_back(as_json(profile, r.profiles.back(), omega));
  all.emplace_back("profiles", profiles);
}

}  // namespace detail

inline app::Json::Object summary(Findings const& r) {
  app::Json::Object all;
  detail::add_case(all, r.options);
  detail::add_costs(all, r);
  detail::add_extremes(all, r);
  detail::add_flow(all, r);
  return all;
}

}  // namespace drum
