// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../passes/over_lists.hpp"
#include "../passes/stage.hpp"
#include "granular.hpp"

#include <type_traits>
#include <utility>

// The pair loops that are compiled in the library scree::compiled: the loops of Granular<>, fused into one sweep for
// all rates and separate for each stage, and the loop of its filter. Other models use the compiled loops that have the
// same terms, and the compiled sums over neighbours, which include the sums of laws without volume control.
// src/compiled/loops.cpp instantiates loops and sums from these lists.
#ifdef SCREE_COMPILED_LOOPS
namespace scree::detail {

template <class Model>
auto passes_with_neighbours(Model const& model) {
  Resolution const resolution;
  auto const filter = Tuple(value_at<0>(model.filters(resolution)));  // the second pass of the filter has no neighbours
  return with_values(
      [&](auto const&... stages) { return in_a_row(rates_of(model, resolution), stages.passes..., filter); },
      model.stages(resolution));
}
template <class P, class Model = Granular<>>
struct loops_of_model : loops_over_lists<P, decltype(passes_with_neighbours(std::declval<Model const&>()))> {};
template <class P>
using DefaultLoops = typename loops_of_model<P>::type;

/// The loops of the acceleration with AdamiWalls and of ShepardFilter.
template <class P>
using LoopsBesideAdamiWalls =
    LoopsOf<P,
            PairPass<Material, Everywhere, granular::Motion<std::tuple<>>,
                     Over<Material, AsIs, StressDivergence<UniformDensity>, ArtificialViscosity<UniformDensity>>,
                     Over<Wall, adami::Seen, StressDivergence<UniformDensity>, ArtificialViscosity<UniformDensity>>>,
            PairPass<Material, Everywhere, ShepardMean<Stress>, Over<Material, AsIs, ShepardSums<Stress>>>>;

template <class P, class Loop>
requires is_default_basis<P> && is_listed_type<Loop, DefaultLoops<P>>
struct is_compiled_loop<P, Loop> : std::true_type {
};
template <class P, class Loop>
requires is_default_basis<P> && is_listed_type<Loop, LoopsBesideAdamiWalls<P>>
struct is_compiled_loop<P, Loop> : std::true_type {
};

#ifdef SCREE_HAS_PACKS
using StressForce = StressDivergence<UniformDensity>;
using ViscousForce = ArtificialViscosity<UniformDensity>;
using ForceAlongWall = conserving::AlongWall<UniformDensity>;
using MeanStress = adami::Weighted<Stress>;
using MeanVelocity = adami::Weighted<Velocity>;

template <class P>
using GranularSums =
    Tuple<OfMaterial<P, VelocityGradientSum, FirstMomentSum>,
          OfMaterial<P, VelocityGradientSum, FirstMomentSum, NumberDensitySum>,
          OfMaterial<P, VelocityGradientSum, FirstMomentSum, StressForce, ViscousForce>,
          OfMaterial<P, VelocityGradientSum, FirstMomentSum, NumberDensitySum, StressForce, ViscousForce>,
          OfMaterial<P, StressForce, ViscousForce>,                                   //
          OfMaterial<P, linear_filter::Sums>,                                         //
          OfWall<P, AsIs, conserving::WallStrain, FirstMomentSum>,                    //
          OfWall<P, AsIs, conserving::WallStrain, FirstMomentSum, NumberDensitySum>,  //
          OfWall<P, conserving::Lens, StressForce, ForceAlongWall, ViscousForce>,     //
          OfWall<P, adami::Seen, VelocityGradientSum, FirstMomentSum>,
          OfWall<P, adami::Seen, VelocityGradientSum, FirstMomentSum, NumberDensitySum>,
          OfWall<P, adami::Seen, VelocityGradientSum, FirstMomentSum, StressForce, ViscousForce>,
          OfWall<P, adami::Seen, VelocityGradientSum, FirstMomentSum, NumberDensitySum, StressForce, ViscousForce>,
          AtWall<P, adami::Weights, MeanVelocity, conserving::SlipGradientSum>,           //
          AtWall<P, adami::Weights, MeanStress, MeanVelocity, conserving::SlipForceSum>,  //
          AtWall<P, adami::Weights, MeanVelocity, conserving::SlipGradientSum, MeanStress, conserving::SlipForceSum>>;

template <class P, class Source>
requires is_default_basis<P> && is_listed_type<Source, GranularSums<P>>
inline constexpr bool is_compiled_sum<P, Source> = true;
#endif

}  // namespace scree::detail

SCREE_INSTANCE struct scree::Granular<scree::GranularModels>;
#endif
