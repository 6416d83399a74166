// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/fields/standard.hpp>
#include <scree/pairs/term.hpp>

namespace scree::test::archetypes {

/// Particles with C > 0.
struct Condition {
  using reads = Fields<Concentration>;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[fields::concentration] > 0;
  }
};
static_assert(ParticleCondition<Condition, detail::AnyPoint>);

}  // namespace scree::test::archetypes
