// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "packing.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

// What check_start() refuses, and what it says then.
namespace scree {

/// How messages of check_start() name the particles, and what it allows.
struct StartWords {
  char const* when = "at the start";
  char const* of_others = " of the wall";
  bool may_be_sparse = false;  ///< whether particles may be without neighbours
  bool judges_packing = true;  ///< whether spacing and volumes are compared with the distances, see Packing
};

namespace detail {

/// A particle in a message of check_start().
struct NamedParticle {
  std::size_t number;
  std::array<double, 3> x;  // m
};

/// Each function throws std::invalid_argument if it refuses a start.
struct StartFaults {
  double spacing;  // m
  int dimensions;
  StartWords words = {};

  /// Refuses a particle for which Crowding::is_wrong() holds. It has a nearest neighbour.
  [[noreturn, gnu::cold]] void refuse(NamedParticle const& i, Crowding const& at, std::size_t neighbour,
                                      bool is_of_wall) const {
    if (at.nearest < 0.1 * spacing)
      refuse(i, formatted("is %.6g m from particle %zu%s: a tenth of the spacing, %.6g m, is the least allowed",
                          at.nearest, neighbour, is_of_wall ? words.of_others : "", 0.1 * spacing));
    refuse(i, formatted("stands in a material and walls %.6g times as dense as the volumes of the particles allow "
                        "(at most 1.6): do bodies overlap, or is the spacing in the settings, %.6g m, larger than "
                        "that of the particles?",
                        at.density, spacing));
  }
  /// Whether it refuses that so many of the particles have no neighbour within 1.5 spacings.
  bool refuses_alone(long alone, long particles) const {
    return !words.may_be_sparse && particles >= 30 && 2 * alone > particles;
  }
  /// Names one of them.
  [[noreturn, gnu::cold]] void refuse_alone(NamedParticle const& i, long alone, long particles) const {
    refuse(i, formatted("has no neighbour within 1.5 spacings (%.6g m), as %ld of %ld particles: is the spacing in "
                        "the settings smaller than that of the particles?",
                        1.5 * spacing, alone, particles));
  }
  /// Whether it looks at the packing.
  bool judges_packing() const { return !words.may_be_sparse && words.judges_packing; }
  [[gnu::cold]] void check(Packing const& packing) const {
    if (!packing.can_tell()) return;
    auto fault = fault_of_packing(packing, spacing, dimensions, words.when);
    if (fault.empty()) fault = fault_of_walls(packing, spacing, words.when);
    if (!fault.empty()) throw std::invalid_argument(fault + "; if this is meant, set `start_checks = false`");
  }

 private:
  [[noreturn, gnu::cold]] void refuse(NamedParticle const& i, std::string const& what) const {
    throw std::invalid_argument(formatted(
        "scree: %s particle %zu at (%.6g, %.6g%s) m %s; if this is meant, set `start_checks = false`", words.when,
        i.number, i.x[0], i.x[1], dimensions == 2 ? "" : formatted(", %.6g", i.x[2]).c_str(), what.c_str()));
  }
};

}  // namespace detail
}  // namespace scree
