// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../passes/over_lists.hpp"
#include "../passes/stage.hpp"
#include "granular.hpp"

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

// The pair loops that the library scree::compiled has: those of Granular<>, in one sweep for all rates and in stages,
// and of its filter. Other models share those of them that have the same terms. src/compiled/loops.cpp makes them from
// this list.
#ifdef SCREE_COMPILED_LOOPS
namespace scree::detail {

/// The loop of a pass over neighbours in lists, in a system that has one body for each that the pass names.
template <class P, class Pass>
struct loop_over_lists;
template <class P, class Target, class Where, class Then, class... Overs>
struct loop_over_lists<P, PairPass<Target, Where, Then, Overs...>> {
  using type = PairLoopOver<P, Where, Then, typename source_in_lists<P, Target, Overs>::type...>;
};

inline auto passes_of_default_models() {
  Granular<> const model;
  Resolution const resolution;
  auto const filter = std::tuple(std::get<0>(model.filters(resolution)));  // the other pass has no neighbours
  return std::apply(
      [&](auto const&... stages) { return std::tuple_cat(rate_passes(model, resolution), stages.passes..., filter); },
      model.stages(resolution));
}
using DefaultPasses = decltype(passes_of_default_models());
template <class P, std::size_t K>
using DefaultLoop = typename loop_over_lists<P, std::tuple_element_t<K, DefaultPasses>>::type;
static_assert(std::tuple_size_v<DefaultPasses> == 7, "SCREE_LOOPS lists all of them");

}  // namespace scree::detail

#define SCREE_LOOP(P, K)                                                                   \
  SCREE_INSTANCE void scree::detail::run_loop<P>(P::space const&, scree::PassLabel const&, \
                                                 scree::detail::DefaultLoop<P, K> const&)
#define SCREE_LOOPS(P) \
  SCREE_LOOP(P, 0);    \
  SCREE_LOOP(P, 1);    \
  SCREE_LOOP(P, 2);    \
  SCREE_LOOP(P, 3);    \
  SCREE_LOOP(P, 4);    \
  SCREE_LOOP(P, 5);    \
  SCREE_LOOP(P, 6)
SCREE_FOR_DEFAULT_BASES(SCREE_LOOPS);
#undef SCREE_LOOPS
#undef SCREE_LOOP
SCREE_INSTANCE struct scree::Granular<scree::GranularModels>;

// The sums over neighbours in these loops, which models with other laws and the same terms share; those of laws without
// volume control too.
#ifdef SCREE_HAS_PACKS
namespace scree::detail {
using StressForce = StressDivergence<UniformDensity>;
using ViscousForce = ArtificialViscosity<UniformDensity>;
using ForceAlongWall = conserving::AlongWall<UniformDensity>;
using MeanStress = adami::Weighted<Stress>;
using MeanVelocity = adami::Weighted<Velocity>;
}  // namespace scree::detail

#define SCREE_SUMS(P)                                                                                                 \
  namespace scree::detail {                                                                                           \
  SCREE_SUM(P, OfMaterial<P, VelocityGradientSum, FirstMomentSum>);                                                   \
  SCREE_SUM(P, OfMaterial<P, VelocityGradientSum, FirstMomentSum, NumberDensitySum>);                                 \
  SCREE_SUM(P, OfMaterial<P, VelocityGradientSum, FirstMomentSum, StressForce, ViscousForce>);                        \
  SCREE_SUM(P, OfMaterial<P, VelocityGradientSum, FirstMomentSum, NumberDensitySum, StressForce, ViscousForce>);      \
  SCREE_SUM(P, OfMaterial<P, StressForce, ViscousForce>);                                                             \
  SCREE_SUM(P, OfMaterial<P, linear_filter::Sums>);                                                                   \
  SCREE_SUM(P, OfWall<P, AsIs, conserving::WallStrain, FirstMomentSum>);                                              \
  SCREE_SUM(P, OfWall<P, AsIs, conserving::WallStrain, FirstMomentSum, NumberDensitySum>);                            \
  SCREE_SUM(P, OfWall<P, conserving::Lens, StressForce, ForceAlongWall, ViscousForce>);                               \
  SCREE_SUM(P, AtWall<P, adami::Weights, MeanVelocity, conserving::SlipGradientSum>);                                 \
  SCREE_SUM(P, AtWall<P, adami::Weights, MeanStress, MeanVelocity, conserving::SlipForceSum>);                        \
  SCREE_SUM(                                                                                                          \
      P, AtWall<P, adami::Weights, MeanVelocity, conserving::SlipGradientSum, MeanStress, conserving::SlipForceSum>); \
  }
SCREE_FOR_DEFAULT_BASES(SCREE_SUMS)
#undef SCREE_SUMS
#endif
#endif
