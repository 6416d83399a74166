// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/granular/strain.hpp>

namespace scree::test::archetypes {

struct Strain {
  static constexpr bool corrected = true;
};
static_assert(StrainChoice<Strain>);

}  // namespace scree::test::archetypes
