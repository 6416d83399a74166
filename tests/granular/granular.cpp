// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/laws/drucker_prager.hpp>

#include <laws/hochstetten.hpp>
#include <support/granular_box.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

namespace scree::test::granular_tests {
using namespace fields;
namespace {

using granular_box::stepped;
using granular_box::turning;
using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
double const nan = std::numeric_limits<double>::quiet_NaN();

/// Sets one entry of a field of one particle.
template <class S, Field F>
void inject(S& solver, F field, std::size_t particle, double bad) {
  auto values = solver.material().to_host(field);
  values[particle][1] = bad;
  std::size_t next = 0;
  solver.set(field, values, [&](auto const&) { return values[next++]; });
}
/// The error that stops a run of a hundred steps, and the step after which it does.
template <class S>
std::pair<std::string, long> stopped(S& solver) {
  long const before = solver.steps();
  try {
    stepped(solver, before + 100);
  } catch (std::runtime_error const& error) {
    return {error.what(), solver.steps() - before};
  }
  return {"", 100};
}

}  // namespace

TEMPLATE_TEST_CASE("a granular run repeated, and one that goes on from a snapshot, give the same bits", "", double,
                   float) {
  auto whole = turning<TestType>(), again = turning<TestType>();
  auto const end = stepped(whole, 120).snapshot();
  auto const first = stepped(again, 47).snapshot();  // off the phase of filter (10), segregation (7) and check (100)
  CHECK(stepped(again, 120).snapshot() == end);      // compares bytes
  auto resumed = turning<TestType>();
  resumed.restore(first);
  CHECK(resumed.steps() == 47);
  CHECK(resumed.snapshot() == first);
  CHECK(stepped(resumed, 120).snapshot() == end);

  // The run covers everything: lists are kept and rebuilt, particles move, segregate, and do not leave.
  CHECK(whole.neighbour_builds() > 1);
  CHECK(whole.neighbour_builds() < 120);
  double fastest = 0;
  for (auto const& u : whole.material().to_host(velocity)) fastest = std::max(fastest, double(u.norm()));
  INFO("fastest " << fastest << " m/s, time " << whole.time() << " s");
  CHECK((fastest > 0.1 && fastest < 3));
  CHECK(whole.material().to_host(concentration) != turning<TestType>().material().to_host(concentration));
}

TEST_CASE("a granular run without its phase gives other bits") {
  // If this fails, the test above no longer tests anything.
  auto whole = turning(), first = turning(), resumed = turning();
  stepped(whole, 120);
  auto snapshot = stepped(first, 47).snapshot();
  snapshot.steps = 40;
  resumed.restore(snapshot);
  stepped(resumed, 113);
  CHECK(resumed.material().to_host(stress) != whole.material().to_host(stress));
  CHECK(resumed.material().to_host(concentration) != whole.material().to_host(concentration));
}

TEST_CASE("a granular run stops where a value is not finite, and names the particle") {
  using Catch::Matchers::ContainsSubstring;
  auto in_velocity = turning(), in_stress = turning();
  auto const infinity = std::numeric_limits<double>::infinity();
  for (double const bad : {nan, infinity, -infinity}) {
    INFO("value " << bad);
    inject(stepped(in_stress = turning(), 20), stress, 57, bad);
    auto const by_stress = stopped(in_stress);
    CHECK_THAT(by_stress.first, ContainsSubstring("scree: particle 57 is not finite after step 20 at ("));
    CHECK_THAT(by_stress.first, ContainsSubstring("stress = ("));
    CHECK(by_stress.second == 0);

    // The viscosity ignores a NaN, so that half a step runs before it is found: stresses of neighbours are not finite
    // then either, and the message names the lowest number.
    inject(stepped(in_velocity = turning(), 20), velocity, 57, bad);
    auto const x = in_velocity.material().to_host(position);
    auto const by_velocity = stopped(in_velocity);
    CHECK(by_velocity.second == 0);
    CHECK_THAT(by_velocity.first, ContainsSubstring(" is not finite after step 20 at ("));
    REQUIRE(by_velocity.first.starts_with("scree: particle "));
    auto const named = std::stoul(by_velocity.first.substr(16));
    CHECK((x.at(named) - x[57]).norm() < in_velocity.resolution().support);
  }
}

TEST_CASE("a stress that is no number is not made admissible") {
  // A cone returns it to zero. A run with a staggered integrator, which takes the step from the rates of the previous
  // step, would continue silently.
  using Law = VolumeMemory<MuOfI<>>;
  using Admit = granular::Admit<Law, SectionByLaw, Fields<>>;
  Admit const admit{{{.elastic = {1e5, 0.3, 1500}, .grains = {0.01}}}};
  using Known = Record<OnHost, reads_of<Admit>>;
  auto const admitted = [&](Vec<4, double> const& sigma) {
    Known i;
    static_cast<scree::detail::Slot<OnHost, Stress>&>(i).value = sigma;
    static_cast<scree::detail::Slot<OnHost, ShearRate>&>(i).value = 1;
    static_cast<scree::detail::Slot<OnHost, Opening>&>(i).value = 0;
    Results<OnHost, writes_of<Admit>> out;
    admit(i, out);
    return out[stress];
  };
  CHECK(admitted({-100, -110, -105, 3}) == Vec<4, double>(-100, -110, -105, 3));
  CHECK(admitted({1, 2, 3, 4}).norm() == 0);
  CHECK_FALSE(admitted({-100, nan, -100, 0}).allFinite());
  CHECK_FALSE(admitted({-100, -100, -100, nan}).allFinite());
  CHECK_FALSE(admitted({-100, -100, -std::numeric_limits<double>::infinity(), 0}).allFinite());
}

TEST_CASE("history that the law leaves alone stays as it was") {
  using Admit = granular::Admit<Hypoplastic, SectionByLaw, Fields<>>;
  Record<OnHost, reads_of<Admit>> i;
  static_cast<scree::detail::Slot<OnHost, Stress>&>(i).value = Vec<4, double>(-100, -110, -105, 3);
  static_cast<scree::detail::Slot<OnHost, VoidRatio>&>(i).value = 0.7;
  Results<OnHost, writes_of<Admit>> out;
  out[void_ratio] = -1;
  Admit{hochstetten()}(i, out);
  CHECK(out[void_ratio] == 0.7);
}

TEST_CASE("yielding is what the law takes off the shear stress, over the bulk modulus") {
  using Admit = granular::Admit<DruckerPrager, SectionByLaw, LinearFilter::history>;
  DruckerPrager const law{{1e5, 0.3, 1500}, {.friction = 0.4}};
  auto const after = [&](double shear_stress) {
    Record<OnHost, reads_of<Admit>> i;
    static_cast<scree::detail::Slot<OnHost, Stress>&>(i).value = Vec<4, double>(-100, -100, -100, shear_stress);
    static_cast<scree::detail::Slot<OnHost, Yielding>&>(i).value = 0.5;
    Results<OnHost, writes_of<Admit>> out;
    Admit{law}(i, out);
    return out[yielding];
  };
  CHECK(after(39) == 0.5);
  CHECK(std::abs(after(100) - (0.5 + 60 / law.bulk_modulus())) < 1e-15);
  CHECK(std::abs(after(-100) - (0.5 + 60 / law.bulk_modulus())) < 1e-15);
}

}  // namespace scree::test::granular_tests
