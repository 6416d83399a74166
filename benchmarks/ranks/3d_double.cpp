// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "scaling.hpp"

namespace scree::bench {

void add_rows_in_double(Team<Space> const& team, Space const& space, Plan const& plan) {
  add_rows<double>(team, space, plan, "double");
}

}  // namespace scree::bench
