// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/granular/forces.hpp>

namespace scree::test::archetypes {

/// 1 m/s^2 along the first axis.
struct Force {
  using reads = Fields<Velocity>;
  template <class I>
  SCREE_FN auto acceleration(I const& i) const {
    auto a = zero<std::remove_cvref_t<decltype(i[fields::velocity])>>();
    a[0] = 1;
    return a;
  }
};

}  // namespace scree::test::archetypes
