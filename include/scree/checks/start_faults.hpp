// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "packing.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

// The faults that check_start() refuses, and their messages.
namespace scree {

/// Words for the messages of check_start(), and the cases that it allows.
struct StartWords {
  char const* when = "at the start";
  char const* of_others = " of the wall";
  bool may_be_sparse = false;  ///< whether particles may be without neighbours
  bool judges_packing = true;  ///< whether spacing and volumes are compared with distances of particles, see Packing
  char const* remedy = "if this is meant, set `start_checks = false`";  ///< the end of each message
  double most_density = detail::Crowding::most_density;                 ///< largest density of material and walls
  std::function<void(std::string const&)> warn = {};                    ///< gets the warning of a sparse wall
};

namespace detail {

/// A particle in a message of check_start().
struct NamedParticle {
  std::size_t number;
  std::array<double, 3> x;  // m
};

/// The faults for which check_start() refuses a start. Functions that refuse a start throw std::invalid_argument.
struct StartFaults {
  double spacing;  // m
  int dimensions;
  StartWords words = {};

  /// Refuses a start because of a particle for which Crowding::is_wrong() is true. `neighbour` is its nearest
  /// neighbour, if it has one.
  [[noreturn, gnu::cold]] void refuse(NamedParticle const& i, Crowding const& at, std::size_t neighbour,
                                      bool is_of_wall) const;
  /// Whether check_start() refuses a start in which this number of particles have no neighbour within 1.5 spacings.
  bool refuses_alone(long alone, long particles) const {
    return !words.may_be_sparse && particles >= 30 && 2 * alone > particles;
  }
  /// Refuses a start in which too many particles have no neighbours, and names one of these particles.
  [[noreturn, gnu::cold]] void refuse_alone(NamedParticle const& i, long alone, long particles) const;
  /// Whether check_start() checks the packing.
  bool judges_packing() const { return !words.may_be_sparse && words.judges_packing; }
  [[gnu::cold]] void check(Packing const& packing) const;

 private:
  [[noreturn, gnu::cold]] void refuse(NamedParticle const& i, std::string const& what) const;
};

}  // namespace detail
}  // namespace scree

#ifndef SCREE_COMPILED
#include "start_faults.ipp"
#endif
