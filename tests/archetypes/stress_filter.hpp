// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/granular/stress_filter.hpp>

namespace scree::test::archetypes {

struct Filter {
  int period = 2;  // steps
  using history = Fields<>;
  std::tuple<> passes() const { return {}; }
};
static_assert(StressFilter<Filter>);

}  // namespace scree::test::archetypes
