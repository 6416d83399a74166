// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/shear_rate_closure.hpp>

#include <support/bodies.hpp>
#include <support/shear_box.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numbers>

namespace scree::test::shear_rate_closure_tests {
using namespace fields;
namespace {
ShearRateClosure const closure{.chi_V = 0.11, .chi_D = 0.0307, .d_small = 0.004, .d_large = 0.008};
}

TEMPLATE_LIST_TEST_CASE("V and D follow the shear rate and the mean diameter", "", Policies) {
  using P = TestType;
  STATIC_CHECK(SegregationClosure<ShearRateClosure, P>);
  auto body = body_of<P, Concentration, ShearRate, SegregationVelocity, Diffusivity>(lattice<P::dim>(0.25), 1);
  set(body, concentration, [](auto const& x) { return x[0]; });
  set(body, shear_rate, [](auto const& x) { return 2 + x[1]; });
  for_each_particle<P>("closure", body, closure);
  // (2.7) with d_avg from 8 mm (large grains only) to 4 mm.
  auto const d = [](auto const& x) { return 0.008 - 0.004 * x[0]; };
  CHECK(largest_error(body, segregation_velocity, 2 * 0.11 * 0.008,
                      [&](auto const& x) { return 0.11 * (2 + x[1]) * d(x); }) < ulps<P>(8));
  CHECK(largest_error(body, diffusivity, 2 * 0.0307 * sq(0.008),
                      [&](auto const& x) { return 0.0307 * (2 + x[1]) * sq(d(x)); }) < ulps<P>(8));
}

TEMPLATE_LIST_TEST_CASE("the shear rate of a sheared bed reaches the closure, at its boundaries too", "",
                        DoublePolicies) {
  using P = TestType;
  using F = Formulated<P, ConservativeSegregation<ShearRateClosure>, OscillatingShear>;
  // At the start the shear rate of the bed is amplitude 2 pi/period. u is linear in height, where the corrected
  // gradient is exact.
  OscillatingShear const swing{.amplitude = 0.5, .period = 4};
  auto solver = solver_of<F>(open_bed<P::dim>(Vec<P::dim, double>::Constant(0.8), 0.1), 0.1, {closure, {}}, swing);
  set_field(solver, concentration, [](auto const&) { return 0.5; });
  solver.update_rates();
  double const rate = 0.5 * 2 * std::numbers::pi / 4;
  double worst = 0;
  for (double const V : solver.material().to_host(segregation_velocity))
    worst = std::max(worst, std::abs(V / (0.11 * rate * 0.006) - 1));
  CHECK(worst < 1e-11);
}

}  // namespace scree::test::shear_rate_closure_tests
