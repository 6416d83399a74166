// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/segregating.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/tension_cutoff.hpp>
#include <scree/laws/volume_memory.hpp>
#include <scree/segregation/constant_closure.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>

#include <limits>

namespace scree::test::settings_tests {
namespace {

struct Models : GranularModels {
  using law = VolumeMemory<MuOfI<>>;
};
using Mechanics = Granular<Models>;
double const nan = std::numeric_limits<double>::quiet_NaN();

Mechanics good() {
  Mechanics mechanics;
  mechanics.law = {{.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}}};
  return mechanics;
}
/// The message of the error of limits() after a change.
template <class Change>
std::string complaint_of(Change change) {
  auto mechanics = good();
  change(mechanics, mechanics.law);
  try {
    mechanics.limits({.dimensions = 2, .spacing = 0.1, .smoothing_length = 0.15});
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a granular material with a setting out of range is refused by its name") {
  CHECK(complaint_of([](auto&, auto&) {}) == "");
  CHECK(complaint_of([](auto& m, auto&) { m.cfl = 100; }) == "scree: cfl (-) must be above 0 and at most 1, not 100");
  CHECK(complaint_of([](auto& m, auto&) { m.cfl = nan; }).starts_with("scree: cfl (-) must be "));
  CHECK(complaint_of([](auto& m, auto&) { m.viscosity_speed = -1; }).starts_with("scree: viscosity_speed (m/s) must"));
  CHECK(complaint_of([](auto&, auto& law) { law.elastic.poisson = 1; }) ==
        "scree: poisson (-) must be above -1 and below 0.5, not 1");
  CHECK(complaint_of([](auto&, auto& law) { law.elastic.young = 0; }) == "scree: young (Pa) must be above 0, not 0");
  CHECK(complaint_of([](auto&, auto& law) { law.elastic.rest_density = 0; }).starts_with("scree: rest_density"));
  CHECK(
      complaint_of([](auto&, auto& law) { law.mu_s = nan; }).starts_with("scree: mu_s (-) of MuOfI must be 0 or more"));
  CHECK(complaint_of([](auto&, auto& law) {
          law.mu_d = -1;
        }).starts_with("scree: mu_d (-) of MuOfI must be mu_s or more"));
  CHECK(complaint_of([](auto&, auto& law) { law.I0 = 0; }).starts_with("scree: I0 (-) of MuOfI must be above 0"));
  CHECK(complaint_of([](auto&, auto& law) { law.grains.diameter = 0; }).starts_with("scree: diameter (m) must be"));
  CHECK(complaint_of([](auto&, auto& law) { law.grain_density = 0; }).starts_with("scree: grain_density"));
  CHECK(complaint_of([](auto&, auto& law) { law.regularisation = -1; }).starts_with("scree: regularisation"));
}

TEST_CASE("laws within laws and closures are checked") {
  CHECK_THROWS_AS(check_settings_of(TensionCutoff<DruckerPrager>{}), std::invalid_argument);
  CHECK_NOTHROW(check_settings_of(TensionCutoff<DruckerPrager>{{.elastic = {1e5, 0.3, 1500}}}));
  CHECK_THROWS_AS((BidisperseGrains{0, 1e-3}.check()), std::invalid_argument);
  ConservativeSegregation<ConstantClosure> segregation{.closure = {.velocity = -1, .diffusivity = 0}};
  CHECK_THROWS_AS(segregation.limits({}), std::invalid_argument);
  segregation.closure = {.velocity = 1, .diffusivity = nan};
  CHECK_THROWS_AS(segregation.limits({}), std::invalid_argument);
  segregation.closure.diffusivity = 1;
  CHECK_NOTHROW(segregation.limits({}));
}

}  // namespace scree::test::settings_tests
