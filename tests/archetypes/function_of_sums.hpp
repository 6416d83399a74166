// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/fields/standard.hpp>
#include <scree/pairs/term.hpp>

namespace scree::test::archetypes {

/// Stores the sum.
struct Keep {
  using reads = Fields<>;
  using writes = Fields<ConcentrationRate>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace fields;
    out[concentration_rate] = total[concentration_rate];
  }
};
static_assert(FunctionOfSums<Keep, detail::AnyPoint, Fields<ConcentrationRate>>);

}  // namespace scree::test::archetypes
