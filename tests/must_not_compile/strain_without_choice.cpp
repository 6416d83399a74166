// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `strain` needs a constant `corrected`
#include <scree/granular/granular.hpp>

struct Strain {
#ifdef FIXED
  static constexpr bool corrected = true;
#endif
};
struct Models : scree::GranularModels {
  using strain = Strain;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
