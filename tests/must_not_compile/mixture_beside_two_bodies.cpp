// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: species with densities of their own can only be in a case with one body that evolves
#include <scree/granular/granular.hpp>
#include <scree/laws/mixture_density.hpp>

struct Models : scree::GranularModels {
#ifdef FIXED
  using law = scree::MuOfI<>;
#else
  using law = scree::MixtureDensity<scree::MuOfI<>, 2>;
#endif
};

auto const terms = scree::Granular<Models>{}.interface_terms(scree::Granular<>{}, scree::Resolution{});
