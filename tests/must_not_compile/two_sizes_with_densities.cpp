// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the species of the mechanics have densities of their own
#include <scree/granular/segregating.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/constant_species.hpp>
#include <scree/segregation/species_segregation.hpp>

struct HeavyAndLight : scree::GranularModels {
  using law = scree::MixtureDensity<scree::MuOfI<>, 2>;
};
#ifdef FIXED
using Segregation = scree::SpeciesSegregation<scree::ConstantSpecies<2>>;
#else
using Segregation = scree::ConservativeSegregation<scree::ConstantClosure>;
#endif

scree::SegregatingGranular<scree::Granular<HeavyAndLight>, Segregation> const physics{};
