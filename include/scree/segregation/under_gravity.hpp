// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../granular/gravity.hpp"
#include "../solver/resolution.hpp"

namespace scree {

/// A segregation without mechanics, where the motion is prescribed, under a gravity of its own. With mechanics,
/// SegregatingGranular gives it the gravity of these.
template <class Segregation>
struct UnderGravity {
  Segregation segregation = {};
  Gravity gravity = {};  ///< its direction is what counts

  using evolves = typename Segregation::evolves;

  auto passes(Resolution const& resolution) const { return segregation.passes(resolution, gravity); }
  auto limits(Resolution const& resolution) const { return segregation.limits(resolution); }
};

}  // namespace scree
