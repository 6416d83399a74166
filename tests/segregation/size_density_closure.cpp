// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/formulation/combined.hpp>
#include <scree/granular/granular.hpp>
#include <scree/laws/mixture_density.hpp>
#include <scree/motion/oscillating_shear.hpp>
#include <scree/segregation/size_density_closure.hpp>
#include <scree/segregation/size_ratio_closure.hpp>
#include <scree/segregation/species_segregation.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <numbers>

namespace scree::test::size_density_closure_tests {
using namespace fields;
namespace {

using Closure = SizeDensityClosure<2>;
using P =
    Formulated<Policy<2, double, Kokkos::DefaultHostExecutionSpace>, SpeciesSegregation<Closure>, OscillatingShear>;

/// The first species is small and light, the second one large and heavy.
Closure const opposed{.diameters = {1e-3, 2e-3}, .densities = {1000, 1500}, .S_density = 0.3};
/// The concentration of the small grains at which both effects cancel.
double neutral_mixture() {
  double const d = 0.26 * 1e-3 * std::log(2.0) / (0.3 * std::log(1.5));
  return (2e-3 - d) / 1e-3;
}

/// A layer with a uniform mixture in shear: the speed of the small grains through the large ones, and the mean flux of
/// small grains along gravity, m/s.
struct Speed {
  double S, moved;
};
Speed speed_at(double C) {
  double const dr = 0.05;
  P::physics physics{.closure = opposed};
  OscillatingShear const shear{.amplitude = 3, .period = 2 * std::numbers::pi};  // at a rate of 3/s at the start
  auto solver = solver_of<P>({fill_lattice(Box<2>{{0, 0}, {0.6, 1}}, dr), {}}, dr, physics, shear, {{0, 0, 0.6}});
  solver.set(concentrations<2>, [&](auto const&) { return Vec<2, double>(C, 1 - C); });
  solver.update_rates();
  auto const S = solver.material().to_host(segregation_velocities<2>);
  auto const rates = solver.material().to_host(concentration_rates<2>);
  auto const x = solver.material().to_host(position);
  double moved = 0;
  for (std::size_t i = 0; i < x.size(); ++i) moved -= rates[i][0] * x[i][1] / double(x.size());
  return {S[S.size() / 2][0], moved};
}

}  // namespace

TEST_CASE(
    "a mixture in which size and density cancel does not segregate, and those beside it do so in opposite directions") {
  double const C = neutral_mixture();
  REQUIRE(C > 0.4);
  REQUIRE(C < 0.6);
  auto const at = speed_at(C), more_large = speed_at(C - 0.2), more_small = speed_at(C + 0.2);
  INFO("at C " << C << ": S " << at.S << ", moved " << at.moved << "; with more large grains " << more_large.S << ", "
               << more_large.moved << "; with more small ones " << more_small.S << ", " << more_small.moved);
  CHECK(std::abs(at.moved) < 1e-13 * more_small.moved);
  CHECK(more_small.S > 1e-5);  // small grains sink,
  CHECK(more_small.moved > 0);
  CHECK(more_large.S < -1e-5);  // or the heavy ones
  CHECK(more_large.moved < 0);
  CHECK(std::abs(more_small.moved / (more_small.S * (C + 0.2) * (0.8 - C)) - 1) < 1e-12);
}

TEST_CASE("with equal densities it is the closure of sizes, with equal sizes heavy grains sink") {
  struct Point {
    Vec<3, double> C{0.2, 0.3, 0.5};
    double rate = 7;
    SCREE_FN auto const& operator[](Concentrations<3>) const { return C; }
    SCREE_FN double operator[](ShearRate) const { return rate; }
  } const point;
  struct Out {
    Vec<3, double> S;
    double D = 0;
    SCREE_FN auto& operator[](SegregationVelocities<3>) { return S; }
    SCREE_FN double& operator[](Diffusivity) { return D; }
  };
  Vec<3, double> const sizes(1e-3, 3e-3, 2e-3), one = Vec<3, double>::Constant(2e-3);
  Out of_sizes, of_both, of_density;
  SizeRatioClosure<3>{.diameters = sizes}(point, of_sizes);
  SizeDensityClosure<3>{.diameters = sizes, .densities = {1200, 1200, 1200}, .S_density = 1}(point, of_both);
  SizeDensityClosure<3>{.diameters = one, .densities = {1000, 4000, 2000}, .S_density = 0.5}(point, of_density);
  CHECK((of_both.S - of_sizes.S).norm() < 1e-15 * of_sizes.S.norm());
  CHECK(of_both.D == of_sizes.D);
  double const unit = 7 * 0.5 * 2e-3 * std::log(2.0);  // of a ratio of 2
  CHECK((of_density.S - Vec<3, double>(-2, -1, 1) * unit).norm() < 1e-14 * unit);
}

TEST_CASE("the factor of the density has no default") {
  using Catch::Matchers::ContainsSubstring;
  CHECK_NOTHROW(opposed.check());
  auto none = opposed;
  none.S_density = 0;
  CHECK_THROWS_WITH(none.check(), ContainsSubstring("S_density of SizeDensityClosure"));
  auto weightless = opposed;
  weightless.densities[1] = 0;
  CHECK_THROWS_WITH(weightless.check(), ContainsSubstring("densities[1] (kg/m^3) of SizeDensityClosure"));
  auto large = opposed;
  large.diameters = {1e-3, 4e-3};
  CHECK(opposed.warning().empty());
  CHECK_THAT(large.warning(), ContainsSubstring("S of SizeDensityClosure was fitted"));
}

TEST_CASE("densities of the closure have the ratios of those of the law") {
  using Catch::Matchers::ContainsSubstring;
  struct Models : GranularModels {
    using law = MixtureDensity<MuOfI<>, 2>;
  };
  Combined<Granular<Models>, SpeciesSegregation<Closure>> physics;
  physics.mechanics.law = {{.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}}, {600, 900}};  // as packed
  physics.transport.closure = opposed;                                                    // of grains
  CHECK_NOTHROW(physics.check());
  physics.transport.closure.densities = {1500, 1000};
  CHECK_THROWS_WITH(physics.check(), ContainsSubstring("densities[1] over densities[0] of the closure of the "
                                                       "segregation must be 1.5, as in the law, not 0.666"));
}

}  // namespace scree::test::size_density_closure_tests
