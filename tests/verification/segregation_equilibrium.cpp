// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "grain_equilibrium.hpp"
#include "segregation_layer.hpp"

#include <scree/segregation/conservative.hpp>
#include <scree/segregation/hybrid.hpp>
#include <scree/segregation/shear_rate_closure.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

// The steady state of the closure of Zhu et al. (2024), which is the same for any shear rate.
namespace scree::test::segregation_equilibrium_tests {
using namespace fields;
namespace {

/// Shear rates over the height, 1/s.
enum class Shear { uniform, bagnold, rising };
struct GivenShearRate {
  Shear shear;
  using reads = Fields<Position>;
  using writes = Fields<ShearRate>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    auto const& x = i[position];
    auto const z = x[x.size() - 1];
    out[shear_rate] = shear == Shear::uniform ? 1 : shear == Shear::bagnold ? Kokkos::sqrt(1 - z) : 0.3 + 0.7 * z;
  }
};
template <class Segregation>
struct Sheared {
  Segregation segregation;
  GivenShearRate shear_rate;
  using evolves = typename Segregation::evolves;
  auto passes(Resolution const& resolution) const {
    return std::tuple_cat(std::tuple(point_pass<Material>("given shear rate", shear_rate)),
                          segregation.transport(resolution, Gravity{}));
  }
  auto limits(Resolution const& resolution) const { return segregation.limits(resolution); }
};

ShearRateClosure const closure{.chi_V = 0.11, .chi_D = 0.0307, .d_small = 0.05, .d_large = 0.1};

/// The largest error of a row, from an even mixture, after a time in which grains could cross the layer at least twice.
struct Found {
  double error, error_of_one_size, lost;
};
template <int Dim, class Segregation>
Found settle(Shear shear, int rows, double mean) {
  using Physics = Sheared<Segregation>;
  using F = Formulated<Policy<Dim, double, Kokkos::DefaultExecutionSpace>, Physics>;
  auto layer = segregating_layer<F>(1.0 / rows, 0, Physics{{closure, {}}, {shear}}, [&](double) { return mean; });
  layer.solver.run(500);
  auto const C = concentrations_of(layer.solver);
  auto one_size = closure;
  one_size.d_small = one_size.d_large = (closure.d_small + closure.d_large) / 2;
  GrainEquilibrium const exact(closure, 1, mean), other(one_size, 1, mean);
  Found found{0, 0, layer.lost()};
  for (std::size_t i = 0; i < C.size(); ++i) {
    found.error = std::max(found.error, std::abs(C[i] - exact(layer.heights[i])));
    found.error_of_one_size = std::max(found.error_of_one_size, std::abs(C[i] - other(layer.heights[i])));
  }
  return found;
}

}  // namespace

TEST_CASE("the equilibrium of small and large grains does not depend on the shear rate") {
  for (auto const& [shear, mean] :
       {std::pair{Shear::uniform, 0.5}, {Shear::bagnold, 0.5}, {Shear::bagnold, 0.2}, {Shear::rising, 0.5}}) {
    auto const found = settle<2, ConservativeSegregation<ShearRateClosure>>(shear, 40, mean);
    INFO("profile " << int(shear) << ", mean C " << mean << ": largest error " << found.error
                    << ", with one grain size " << found.error_of_one_size << ", lost " << found.lost);
    CHECK(found.error < 0.01);
    CHECK(found.lost < 1e-12);
    CHECK(found.error_of_one_size > 0.03);  // the bar distinguishes this equilibrium from that of a constant V/D
  }
}

}  // namespace scree::test::segregation_equilibrium_tests
