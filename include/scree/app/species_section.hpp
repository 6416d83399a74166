// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "schema.hpp"
#include "species_list.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace scree::app {

namespace detail {

inline std::string fault_of_count(SpeciesList const& list) {
  int const n = list.count();
  if (n == 0 || (n >= 2 && n <= most_species)) return "";
  return fmt::format("{} diameter{}; a list has 2 to {}, and an empty one is no list", n, n == 1 ? "" : "s",
                     most_species);
}
inline std::string fault_of_shares(SpeciesList const& list) {
  if (list.shares.size() != list.diameters.size())
    return fmt::format("{} shares for {} species.diameters", list.shares.size(), list.diameters.size());
  double sum = 0;
  for (double const share : list.shares) sum += share;
  if (list.empty() || std::abs(sum - 1) <= 1e-6) return "";
  return fmt::format("they add up to {:.7g}, not to 1", sum);
}

}  // namespace detail

/// Adds a section "species" with the list. `order` is a text that explains the order of the list; `replaced` names the
/// options that a list replaces.
template <class T>
void describe_species(Schema<T>& schema, SpeciesList T::*list, std::string const& order,
                      std::vector<std::string> const& replaced) {
  schema.section("species", list, fmt::format("Instead of two sizes of grains a list of 2 to {}", most_species))
      .add("diameters", &SpeciesList::diameters,
           {.unit = "m", .range = {1e-6, 0.1}, .meaning = "of the grains of each size; []: two sizes. " + order})
      .add("shares", &SpeciesList::shares,
           {.range = {0, 1}, .meaning = "volume of the grains of each size over that of all; they add up to 1"});
  schema.complain({"species.diameters", [=](T const& o) { return detail::fault_of_count(o.*list); }});
  schema.complain({"species.shares", [=](T const& o) { return detail::fault_of_shares(o.*list); }});
  for (auto const& key : replaced)
    schema.only_when(
        {key, [=](T const& o) { return (o.*list).empty(); }, "has no effect while species.diameters is given"});
}

}  // namespace scree::app
