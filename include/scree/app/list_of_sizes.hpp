// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../io/each_concentration.hpp"
#include "../laws/grains.hpp"
#include "../segregation/size_ratio_closure.hpp"
#include "../segregation/species_segregation.hpp"
#include "species_list.hpp"

namespace scree::app {

/// The models of a mixture whose grain sizes come from a list. Programs use them in place of their models for two
/// sizes.
struct ListOfSizes {
  static constexpr int species = most_species;
  using Grains = PolydisperseGrains<species>;
  using Segregation = SpeciesSegregation<SizeRatioClosure<species>>;
  /// The concentrations of all species, for output.
  using EachConcentration = scree::EachConcentration<species>;

  /// Returns the grains of a law, with the diameters of a list.
  static Grains grains(SpeciesList const& list) { return {.diameters = list.all_diameters()}; }
  /// Returns the segregation model, with the diameters of a list in its closure.
  static Segregation segregation(SpeciesList const& list) { return {.closure = {.diameters = list.all_diameters()}}; }
};

}  // namespace scree::app
