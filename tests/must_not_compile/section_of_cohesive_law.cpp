// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: `section` of the models needs a law that takes a section
#include <scree/granular/granular.hpp>
#include <scree/laws/drucker_prager.hpp>

#ifdef FIXED
using Soil = scree::MuOfI<>;
#else
using Soil = scree::DruckerPrager;
#endif
struct Models : scree::GranularModels {
  using law = Soil;
  using section = scree::MatsuokaNakai;
};

auto limits(scree::Granular<Models> const& physics) { return physics.limits({}); }
