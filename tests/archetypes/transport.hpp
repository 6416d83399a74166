// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/formulation/combined.hpp>
#include <scree/segregation/conservative.hpp>
#include "closure.hpp"

namespace scree::test::archetypes {

/// Nothing is added to the concentration that flows with the material.
struct Transport {
  using evolves = Fields<Concentration>;
  template <class Mechanics>
  auto passes_with(Mechanics const& mechanics, Resolution const& resolution) const {
    return ConservativeSegregation<Closure>{}.transport(resolution, gravity_of(mechanics));
  }
  std::tuple<> limits(Resolution const&) const { return {}; }
};

}  // namespace scree::test::archetypes
