// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: a group takes points of its dimension in double precision
#include <scree/fields/groups.hpp>

void run(scree::Groups<3>& groups) {
#ifdef FIXED
  std::vector<scree::Vec<3, double>> const points;
#else
  std::vector<scree::Vec<2, double>> const points;
#endif
  groups.add("gate", points);
}
