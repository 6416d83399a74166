// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/hybrid.hpp>
#include <scree/segregation/shear_rate_closure.hpp>

#include <support/formulations.hpp>
#include <support/policies.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

namespace scree::test::ends_of_ranges_tests {
using namespace fields;
namespace {

using Catch::Matchers::ContainsSubstring;

template <class Real>
using Plane = Policy<2, Real, Kokkos::DefaultHostExecutionSpace>;
template <class Real, class Physics>
using Column = Solver<Formulated<Plane<Real>, Physics>>;

double const V = 0.1, D = 2e-3, height = 1;  // m/s, m^2/s, m

/// A column at rest with large grains below small ones, or a mixture.
template <class S>
S column(typename S::policy::physics const& physics, bool layered) {
  auto solver = solver_of<typename S::policy>(layer({0.5, height}, 0.05), 0.05, physics, {}, {{0, 0, 0.5}});
  set_field(solver, concentration, [=](auto const& x) { return layered ? (x[1] > height / 2 ? 1.0 : 0.0) : 0.7; });
  return solver;
}

}  // namespace

TEMPLATE_TEST_CASE("the conservative scheme runs for kappa up to 1", "", float, double) {
  using Physics = ConservativeSegregation<ConstantClosure>;
  double const eps = std::numeric_limits<TestType>::epsilon();
  for (double const kappa : {0.0, 0.999999, 1.0})
    for (double const A : {1.0, 10.0})
      for (bool const layered : {true, false}) {
        INFO("kappa " << kappa << ", A " << A << (layered ? ", layered" : ", mixed"));
        auto solver = column<Column<TestType, Physics>>({.closure = {V, D}, .flux = {A, kappa}}, layered);
        double const before = sum_of(concentrations_of(solver));
        solver.run(2);
        auto const C = concentrations_of(solver);
        CHECK(outside_of_range(C) < 50 * eps);
        CHECK(std::abs(sum_of(C) - before) < 50 * eps * double(C.size()));
        // Small grains have moved down.
        double low = 0, high = 0;
        auto const x = solver.material().to_host(position);
        for (std::size_t i = 0; i < C.size(); ++i) (x[i][1] < height / 2 ? low : high) += C[i];
        CHECK((layered ? low > 0.01 * before : low > 1.02 * high));
      }
}

TEST_CASE("concentrations that are none are refused at the start") {
  auto const complaint = [](auto solver, double C) {
    set_field(solver, concentration, [=](auto const& x) { return x[1] < 0.05 ? C : 0.5; });
    try {
      solver.step(1);
    } catch (OutsideValidity const& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using Conservative = ConservativeSegregation<ConstantClosure>;
  using Hybrid = HybridSegregation<ConstantClosure>;
  for (double const C : {-0.1, 1.1, 2.0}) {
    CHECK_THAT(complaint(column<Column<double, Conservative>>({.closure = {V, D}}, false), C),
               ContainsSubstring("the distance of the concentration from [0, 1] must be at most 0.001, and is "));
    CHECK_THAT(complaint(column<Column<double, Hybrid>>({.closure = {V, D}}, false), C),
               ContainsSubstring("it is the share of the small grains"));
  }
  for (double const C : {0.0, 1.0, 1 + 1e-15})
    CHECK(complaint(column<Column<double, Conservative>>({.closure = {V, D}}, false), C) == "");
}

TEST_CASE("settings of the segregation out of range are refused") {
  using Physics = ConservativeSegregation<ShearRateClosure>;
  ShearRateClosure const good{.d_small = 1e-3, .d_large = 2e-3};
  auto const refused = [](ShearRateClosure const& closure, SegregationFlux const& flux) {
    auto solver = column<Column<double, Physics>>({.closure = closure, .flux = flux}, false);
    CHECK_THROWS_AS(solver.step(1), std::invalid_argument);
  };
  refused({.d_small = 0, .d_large = 1e-3}, {});
  refused({.d_small = 1e-3, .d_large = -1}, {});
  refused({.chi_V = -1, .d_small = 1e-3, .d_large = 1e-3}, {});
  refused({.chi_D = std::nan(""), .d_small = 1e-3, .d_large = 1e-3}, {});
  refused(good, {.asymmetry = 1.5});
  refused(good, {.amplitude = 0});
}

}  // namespace scree::test::ends_of_ranges_tests
