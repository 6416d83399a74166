// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/tuple.hpp"
#include "../passes/over_lists.hpp"
#include "../passes/stage.hpp"
#include "granular.hpp"

#include <type_traits>
#include <utility>

// The pair loops that the library scree::compiled has: those of Granular<>, in one sweep for all rates and in stages,
// and of its filter. Other models share those of them that have the same terms, and the sums over neighbours, those of
// laws without volume control too. src/compiled/loops.cpp makes them from these lists.
#ifdef SCREE_COMPILED_LOOPS
namespace scree::detail {

/// The loop of a pass over neighbours in lists, in a system that has one body for each that the pass names.
template <class P, class Pass>
struct loop_over_lists;
template <class P, class Target, class Where, class Then, class... Overs>
struct loop_over_lists<P, PairPass<Target, Where, Then, Overs...>> {
  using type = PairLoopOver<P, Where, Then, typename source_in_lists<P, Target, Overs>::type...>;
};
template <class P, class Passes>
struct loops_over_lists;
template <class P, class... Passes>
struct loops_over_lists<P, Tuple<Passes...>> {
  using type = Tuple<typename loop_over_lists<P, Passes>::type...>;
};
template <class Model>
auto passes_with_neighbours(Model const& model) {
  Resolution const resolution;
  auto const filter = Tuple(value_at<0>(model.filters(resolution)));  // the other pass has no neighbours
  return with_values(
      [&](auto const&... stages) { return in_a_row(rates_of(model, resolution), stages.passes..., filter); },
      model.stages(resolution));
}
template <class P, class Model = Granular<>>
struct loops_of_model : loops_over_lists<P, decltype(passes_with_neighbours(std::declval<Model const&>()))> {};
template <class P>
using DefaultLoops = typename loops_of_model<P>::type;

template <class P, class Loop>
requires is_default_basis<P> && is_listed_type<Loop, DefaultLoops<P>>
inline constexpr bool is_compiled_loop<P, Loop> = true;

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
          OfMaterial<P, StressForce, ViscousForce>,                                       //
          OfMaterial<P, linear_filter::Sums>,                                             //
          OfWall<P, AsIs, conserving::WallStrain, FirstMomentSum>,                        //
          OfWall<P, AsIs, conserving::WallStrain, FirstMomentSum, NumberDensitySum>,      //
          OfWall<P, conserving::Lens, StressForce, ForceAlongWall, ViscousForce>,         //
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
