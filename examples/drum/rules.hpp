// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "quantities.hpp"

#include <scree/app/room.hpp>

#include <functional>

// Options that contradict each other, and options that have no effect unless others are set.
namespace drum {

namespace detail {

inline bool rises(std::vector<double> const& times) {
  return std::ranges::adjacent_find(times, std::greater_equal{}) == times.end();
}

inline void add_contradictions(scree::app::Schema<Options>& schema) {
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
  scree::app::require_room<Options>(schema, "numerics.spacing", number_of_grains);
  schema.require({"output.profile_times", [](Options const& o) { return rises(o.output.profile_times); },
                  "its times do not rise"});
}

inline void add_effects(scree::app::Schema<Options>& schema) {
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

inline void add_rules(scree::app::Schema<Options>& schema) {
  detail::add_contradictions(schema);
  detail::add_effects(schema);
}

}  // namespace drum
