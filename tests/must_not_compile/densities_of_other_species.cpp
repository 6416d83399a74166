// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// expected: the mechanics has the densities of another number of species
#include <scree/granular/segregating.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/segregation/constant_species.hpp>
#include <scree/segregation/species_segregation.hpp>

struct HeavyAndLight : scree::GranularModels {
  using law = scree::MixtureDensity<scree::MuOfI<>, 3>;
};
#ifdef FIXED
constexpr int species = 3;
#else
constexpr int species = 2;
#endif

auto const passes = scree::SpeciesSegregation<scree::ConstantSpecies<species>>{}.passes_with(
    scree::Granular<HeavyAndLight>{}, scree::Resolution{});
