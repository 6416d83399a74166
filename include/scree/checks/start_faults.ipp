// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "start_faults.hpp"

namespace scree {

SCREE_BODY void detail::StartFaults::refuse(NamedParticle const& i, Crowding const& at, std::size_t neighbour,
                                            bool is_of_wall) const {
  if (at.nearest < 0.1 * spacing)
    refuse(i, formatted("is %.6g m from particle %zu%s: a tenth of the spacing, %.6g m, is the least allowed",
                        at.nearest, neighbour, is_of_wall ? words.of_others : "", 0.1 * spacing));
  refuse(i, formatted("stands in a material and walls %.6g times as dense as the volumes of the particles allow "
                      "(at most %.6g): do bodies overlap, or is the spacing in the settings, %.6g m, larger than "
                      "that of the particles?",
                      at.density, words.most_density, spacing));
}

SCREE_BODY void detail::StartFaults::refuse_alone(NamedParticle const& i, long alone, long particles) const {
  refuse(i, formatted("has no neighbour within 1.5 spacings (%.6g m), as %ld of %ld particles: is the spacing in "
                      "the settings smaller than that of the particles?",
                      1.5 * spacing, alone, particles));
}

SCREE_BODY void detail::StartFaults::check(Packing const& packing) const {
  if (!packing.can_tell()) return;
  auto fault = fault_of_packing(packing, spacing, dimensions, words.when);
  if (fault.empty()) fault = fault_of_walls(packing, spacing, words.when);
  if (!fault.empty()) throw std::invalid_argument(fault + "; " + words.remedy);
  auto const doubt = warning_of_sparse_wall(packing, spacing);
  if (!doubt.empty() && words.warn) words.warn(doubt);
}

SCREE_BODY void detail::StartFaults::refuse(NamedParticle const& i, std::string const& what) const {
  throw std::invalid_argument(formatted("scree: %s particle %zu at (%.6g, %.6g%s) m %s; %s", words.when, i.number,
                                        i.x[0], i.x[1], dimensions == 2 ? "" : formatted(", %.6g", i.x[2]).c_str(),
                                        what.c_str(), words.remedy));
}

}  // namespace scree
