// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/fields/standard.hpp>
#include <scree/pairs/term.hpp>

namespace scree::test::archetypes {

struct Doubled : Scalar<"doubled", "1"> {};
inline constexpr Doubled doubled{};

/// 2 C.
struct PointFunctionOfOne {
  using reads = Fields<Concentration>;
  using writes = Fields<Doubled>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[doubled] = 2 * i[fields::concentration];
  }
};
static_assert(PointFunction<PointFunctionOfOne, detail::AnyPoint>);

}  // namespace scree::test::archetypes
