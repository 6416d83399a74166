// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "profile_of_grains.hpp"
#include "segregation_layer.hpp"

#include <scree/segregation/conservative.hpp>
#include <scree/segregation/trewhela_closure.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>

// The steady state of the closure of Trewhela et al. (2021) under a given pressure, which is the same for any shear
// rate. Figures: docs/theory/verification.md.
namespace scree::test::trewhela_equilibrium_tests {
using namespace fields;
namespace {

TrewhelaClosure const closure{.d_small = 0.08, .d_large = 0.1, .grain_density = 2500};
double const packing = 0.6, g = 9.81;  // share of the volume that grains fill; m/s^2

/// The pressure of the weight above, and a shear rate over the height of a layer of 1 m.
struct GivenFlow {
  bool rising;  // the shear rate rises with the height; else it falls to the surface, as in Bagnold's flow
  double load;  // Pa, on the surface
  using reads = Fields<Position>;
  using writes = Fields<ShearRate, Stress>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    auto const& x = i[position];
    double const z = x[x.size() - 1], p = load + packing * closure.grain_density * g * (1 - z);
    out[shear_rate] = rising ? 0.3 + 0.7 * z : Kokkos::sqrt(1 - z);
    auto sigma = zero<std::remove_cvref_t<decltype(out[stress])>>();
    for (int k = 0; k < 3; ++k) sigma[k] = -p;
    out[stress] = sigma;
  }
};
struct InGivenFlow {
  ConservativeSegregation<TrewhelaClosure> segregation = {.closure = closure};
  GivenFlow flow;
  using evolves = Fields<Concentration>;
  auto passes(Resolution const& resolution) const {
    return std::tuple_cat(std::tuple(point_pass<Material>("given flow", flow)),
                          segregation.transport(resolution, Gravity{.magnitude = g}));
  }
  auto limits(Resolution const& resolution) const { return segregation.limits(resolution); }
};
/// The equilibrium, in terms of its own: the ratio of V to D of the large and of the small grains alone.
ProfileOfGrains equilibrium(double load, double mean) {
  return ProfileOfGrains(
      [=](double z, double C) {
        double const d = 0.1 - 0.02 * C, depth = packing * (1 - z) + load / (2500 * g);
        double const of_large = 0.25, of_small = 0.25 + 2.0957 * 0.25 * 0.25;
        return 0.7125 / 0.108 * (C * of_large + (1 - C) * of_small) / (0.2712 * d + depth);
      },
      1, mean);
}

/// The mean over the rows of the error of a row.
double settle(GivenFlow const& flow, int rows, double mean) {
  using F = Formulated<Policy<2, double, Kokkos::DefaultExecutionSpace>, InGivenFlow>;
  auto layer = segregating_layer<F>(1.0 / rows, 0, InGivenFlow{.flow = flow}, [=](double) { return mean; });
  layer.solver.run(1000);
  ProfileOfGrains const exact = equilibrium(flow.load, mean);
  double const error = layer.error(exact), mixed = layer.error([=](double) { return mean; });
  UNSCOPED_INFO(rows << " rows, " << (flow.rising ? "rising shear rate" : "Bagnold's") << ", load " << flow.load
                     << " Pa, mean " << mean << ": error " << error << ", from the mixture " << mixed << ", lost "
                     << layer.lost() << ", C from " << exact(0) << " to " << exact(1));
  CHECK(layer.lost() < 1e-12);
  CHECK(mixed > 0.15);
  return error;
}

}  // namespace

TEST_CASE("the equilibrium of Trewhela's closure under a pressure does not depend on the shear rate") {
  for (auto const& [flow, mean] : {std::pair{GivenFlow{true, 0}, 0.5}, {GivenFlow{false, 5000}, 0.3}}) {
    double const coarse = settle(flow, 12, mean), fine = settle(flow, 24, mean);
    CHECK(fine < 3e-3);
    CHECK(fine < 0.35 * coarse);
  }
}

}  // namespace scree::test::trewhela_equilibrium_tests
