// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/default_control.hpp>

#include <scree/granular/granular.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/hypoplastic.hpp>
#include <scree/laws/rising_mu_of_i.hpp>
#include <scree/laws/tension_cutoff.hpp>

#include <catch2/catch_test_macros.hpp>

namespace scree::test::default_control_tests {
namespace {

template <class Law>
struct With : GranularModels {
  using law = Law;
};
template <class Law, class Control>
struct Under : With<Law> {
  using volume_control = Control;
};
template <class Models>
using control_of = typename Granular<Models>::Volume;
template <class Models>
constexpr bool remembers = OneOf<Opening, typename Granular<Models>::evolves>;
template <class Law>
constexpr bool follows_packing = std::is_same_v<control_of<With<Law>>, FlowConsistency>&& remembers<With<Law>>;
template <class Law>
constexpr bool has_none = std::is_same_v<control_of<With<Law>>, NoVolumeControl> && !remembers<With<Law>>;

}  // namespace

TEST_CASE("the pressure of grains without cohesion follows the packing by default, that of other laws does not") {
  STATIC_CHECK(std::is_same_v<control_of<GranularModels>, FlowConsistency>);
  STATIC_CHECK(follows_packing<MuOfI<>>);
  STATIC_CHECK(follows_packing<MuOfI<BidisperseGrains>>);
  STATIC_CHECK(follows_packing<RisingMuOfI<>>);
  STATIC_CHECK(follows_packing<ByGroup<MuOfI<>>>);
  STATIC_CHECK(follows_packing<TensionCutoff<MuOfI<>>>);
  STATIC_CHECK(follows_packing<VolumeMemory<MuOfI<>>>);
  STATIC_CHECK(has_none<DruckerPrager>);
  STATIC_CHECK(has_none<Elastic>);
  STATIC_CHECK(has_none<ByGroup<DruckerPrager>>);
  STATIC_CHECK(std::is_same_v<control_of<With<Hypoplastic>>, NoVolumeControl>);
}

TEST_CASE("a volume control that is named is taken, and one memory is enough") {
  STATIC_CHECK(std::is_same_v<control_of<Under<MuOfI<>, NoVolumeControl>>, NoVolumeControl>);
  STATIC_CHECK_FALSE(remembers<Under<MuOfI<>, NoVolumeControl>>);
  STATIC_CHECK_FALSE(remembers<Under<MuOfI<>, VolumeConsistency>>);
  STATIC_CHECK(remembers<Under<DruckerPrager, FlowConsistency>>);
  STATIC_CHECK(std::is_same_v<Granular<>::EvolvedLaw, VolumeMemory<MuOfI<>>>);
  STATIC_CHECK(std::is_same_v<Granular<With<VolumeMemory<MuOfI<>>>>::EvolvedLaw, VolumeMemory<MuOfI<>>>);
  // The law of a user stays what it is.
  STATIC_CHECK(std::is_same_v<decltype(Granular<>::law), MuOfI<>>);
}

}  // namespace scree::test::default_control_tests
