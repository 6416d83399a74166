// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "scaling.hpp"

namespace scree::bench {

void add_rows_in_float(Team<Space> const& team, Space const& space, Plan const& plan) {
  add_rows<float>(team, space, plan, "float");
}

}  // namespace scree::bench
