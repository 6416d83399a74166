// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/resolution.hpp"
#include "../passes/validity.hpp"
#include "../terms/gravity.hpp"

namespace scree {

/// Segregation without mechanics, for a prescribed motion, with a gravity of its own. With mechanics,
/// SegregatingGranular passes the gravity of the mechanics.
template <class Segregation>
struct UnderGravity {
  Segregation segregation = {};  ///< the model whose gravity this is
  Gravity gravity = {};          ///< only its direction matters

  using evolves = typename Segregation::evolves;

  /// Throws std::invalid_argument if a setting is out of range.
  void check() const {
    check_settings_of(segregation);
    gravity.check();
  }
  /// The warning of the closure; empty if there is none.
  std::string warning() const requires requires(Segregation const& each) { each.warning(); }
  { return segregation.warning(); }
  /// The warning of the segregation about the state that a body (WholeBody) has come to; empty if there is none.
  template <class Whole>
  std::string warning_of_state(Whole const& body) const requires requires(Segregation const& each) {
    each.warning_of_state(body);
  }
  { return segregation.warning_of_state(body); }
  /// The passes of the segregation under this gravity.
  auto passes(Resolution const& resolution) const { return segregation.passes(resolution, gravity); }
  /// The limits of the step of the segregation. Throws as those do.
  auto limits(Resolution const& resolution) const { return segregation.limits(resolution); }
  /// The bounds on the state of the segregation.
  auto validity(Resolution const& resolution) const { return validity_of(segregation, resolution); }
};

}  // namespace scree
