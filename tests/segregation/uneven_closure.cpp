// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/segregation/conservative.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::uneven_closure_tests {
using namespace fields;
namespace {

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;

/// V and D that differ between two neighbours.
struct UnevenClosure {
  double of_V = 0, of_D = 0;
  using reads = Fields<Position>;
  using writes = Fields<SegregationVelocity, Diffusivity>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    auto const x = i[position];
    out[segregation_velocity] = of_V * (1 + Kokkos::sin(20 * x[0]) * Kokkos::cos(30 * x[1]));
    out[diffusivity] = of_D * (1 + Kokkos::cos(25 * x[0] + x[1]));
  }
};

}  // namespace

TEST_CASE("velocities and diffusivities that differ between neighbours create and destroy nothing") {
  using F = Formulated<OnHost, ConservativeSegregation<UnevenClosure>>;
  for (auto const& closure : {UnevenClosure{2, 0.001}, UnevenClosure{0, 0.03}, UnevenClosure{2, 0.03}}) {
    auto solver = solver_of<F>(open_bed<2>({0.6, 1}, 0.1), 0.1, {closure, SegregationFlux::asymmetric()});
    set_field(solver, concentration, [](auto const& x) { return 0.5 + 0.45 * std::sin(9 * x[0] + 7 * x[1]); });
    auto const rates = rates_of(solver);
    double magnitude = 0;
    for (double const rate : rates) magnitude += std::abs(rate);
    CHECK(magnitude > 1);
    CHECK(std::abs(sum_of(rates)) < 1e-14 * magnitude);
  }
}

}  // namespace scree::test::uneven_closure_tests
