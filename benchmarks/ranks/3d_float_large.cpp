// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "scaling.hpp"

namespace scree::bench {

void add_row_of_large(Team<Space> const& team, Space const& space, Plan const& plan) {
  add_row<LargeOnRanks>(team, space, plan, "float, large");
}

}  // namespace scree::bench
