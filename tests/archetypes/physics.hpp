// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/formulation/formulation.hpp>
#include "condition.hpp"
#include "function_of_sums.hpp"
#include "lens.hpp"
#include "limit.hpp"
#include "term.hpp"

namespace scree::test::archetypes {

struct Physics {
  using evolves = Fields<Concentration>;
  auto passes(Resolution const&) const {
    return std::tuple(pair_pass_where<Material>("mix", Condition{}, Keep{}, over<Material>(Term{}),
                                                over_through<Wall>(Lens{}, Term{})));
  }
  auto limits(Resolution const&) const { return archetypes::limits(); }
};
static_assert(HasPasses<Physics> && HasLimits<Physics>);

}  // namespace scree::test::archetypes
