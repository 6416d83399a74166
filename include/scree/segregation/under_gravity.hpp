// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/resolution.hpp"
#include "../passes/validity.hpp"
#include "../terms/gravity.hpp"

namespace scree {

/// A segregation model with a gravity of its own, for a prescribed motion without mechanics. In a combination with
/// mechanics, SegregatingGranular passes the gravity of the mechanics to the segregation.
template <class Segregation>
struct UnderGravity {
  Segregation segregation = {};  ///< the model of the segregation
  Gravity gravity = {};          ///< its magnitude matters only to closures with under()

  using evolves = typename Segregation::evolves;

  /// Throws std::invalid_argument if a setting is out of range.
  void check() const {
    check_settings_of(segregation);
    gravity.check();
  }
  /// Returns the warning of the segregation; empty if there is none.
  std::string warning() const requires requires(Segregation const& each) { each.warning(); }
  { return segregation.warning(); }
  /// Returns the warning of the segregation about the present state of a body (WholeBody); empty if there is none.
  template <class Whole>
  std::string warning_of_state(Whole const& body) const requires requires(Segregation const& each) {
    each.warning_of_state(body);
  }
  { return segregation.warning_of_state(body); }
  /// Returns the passes of the segregation under this gravity.
  auto passes(Resolution const& resolution) const { return segregation.passes(resolution, gravity); }
  /// Returns the limits of the time step of the segregation. Throws as segregation.limits() does.
  auto limits(Resolution const& resolution) const { return segregation.limits(resolution); }
  /// Returns the bounds on the state of the segregation.
  ///
  auto validity(Resolution const& resolution) const { return validity_of(segregation, resolution); }
};

}  // namespace scree
