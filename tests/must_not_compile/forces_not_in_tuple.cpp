// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `forces` must be a std::tuple
#include <scree/granular/granular.hpp>

struct Models : scree::GranularModels {
#ifdef FIXED
  using forces = std::tuple<scree::TensileRepulsion>;
#else
  using forces = scree::TensileRepulsion;
#endif
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
