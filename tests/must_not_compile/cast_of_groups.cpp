// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: groups need no cast
#include <scree/fields/groups.hpp>
#include <scree/setup/lattice.hpp>

[[maybe_unused]] int run(scree::Groups<2> const& groups) {
#ifdef FIXED
  return groups.count();
#else
  return scree::cast<float>(groups).count();
#endif
}
