// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "segregation_layer.hpp"
#include "sorting.hpp"

#include <scree/segregation/conservative.hpp>
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/hybrid.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

// Segregation without diffusion, at an infinite cell Peclet number: shocks and fans.
namespace scree::test::segregation_shocks_tests {
namespace {

using Conservative = ConservativeSegregation<ConstantClosure>;
using Hybrid = HybridSegregation<ConstantClosure>;
template <class Physics, int Dim>
using Layer = Formulated<Policy<Dim, double, Kokkos::DefaultExecutionSpace>, Physics>;

template <class Physics>
Physics without_diffusion() {
  return {{.velocity = 1, .diffusivity = 0}, {}};
}

/// Results of a run up to a time.
struct Found {
  double error;    ///< mean over the rows, in spacings
  double outside;  ///< how far C was outside [0, 1] on the way
  double lost;     ///< of the small grains, relative
};
template <class L, class Exact>
Found run(L& layer, Exact const& exact, double time) {
  double outside = 0;
  while (layer.solver.time() < time * (1 - 1e-12)) {
    layer.solver.run(std::min(time, layer.solver.time() + 0.05));
    outside = std::max(outside, outside_of_range(concentrations_of(layer.solver)));
  }
  return {layer.error([&](double z) { return exact(z, time); }) / layer.spacing, outside, layer.lost()};
}

template <class Physics, int Dim, class Exact>
auto layer_of(Exact const& exact, double spacing, double jittered) {
  return segregating_layer<Layer<Physics, Dim>>(spacing, jittered, without_diffusion<Physics>(),
                                                [&](double z) { return exact(z, 0); });
}

/// The largest of the errors at the given times, in spacings. C stays bounded and conserved up to then.
template <int Dim, class Exact>
double largest_error(Exact const& exact, double spacing, double jittered, std::vector<double> const& times) {
  auto layer = layer_of<Conservative, Dim>(exact, spacing, jittered);
  double largest = 0;
  for (double const time : times) {
    auto const found = run(layer, exact, time);
    INFO("spacing " << spacing << ", time " << time << ": error " << found.error << " spacings");
    CHECK(found.outside < 1e-12);
    CHECK(found.lost < 1e-12);
    largest = std::max(largest, found.error);
  }
  return largest;
}

/// `exact` in spacings of 0.02 and 0.01 on a lattice: first order, below one spacing.
template <class Exact>
void check_order(Exact const& exact, std::vector<double> const& times) {
  double const coarse = largest_error<2>(exact, 0.02, 0, times), fine = largest_error<2>(exact, 0.01, 0, times);
  double const order = std::log2(2 * coarse / fine);
  INFO("errors in spacings " << coarse << " and " << fine << ", order " << order);
  CHECK(fine < 1.0);
  CHECK(order > 0.8);
}

/// Whether everything is sorted: less than half a spacing from the end.
template <class L, class Exact>
bool is_sorted_at(L& layer, Exact const& exact, double time) {
  layer.solver.run(time);
  double const error = layer.error([&](double z) { return exact(z, 1e9); }) / layer.spacing;
  INFO("time " << time << ", " << error << " spacings from the end");
  return error < 0.5;
}

}  // namespace

TEST_CASE("shocks between mixed and sorted grains move as the exact ones") {
  check_order(sorting::Mixed{}, {0.3, 0.6, 0.9});
}

TEST_CASE("small grains above large ones fall in a fan and gather behind shocks") {
  check_order(sorting::Inverted{}, {0.3, 0.9, 1.5});
}

TEST_CASE("grains are sorted at the exact time") {
  // No earlier than 2 spacings before the exact time, when half a spacing is left to sort, and no later than 2 after
  // it.
  double const dr = 0.02;
  for (double const interface : {0.5, 0.4}) {
    sorting::Inverted const exact{interface};
    auto layer = layer_of<Conservative, 2>(exact, dr, 0);
    INFO("interface at " << interface << ", sorted at " << exact.sorted());
    CHECK_FALSE(is_sorted_at(layer, exact, exact.sorted() - 2 * dr));
    CHECK(is_sorted_at(layer, exact, exact.sorted() + 2 * dr));
  }
}

TEST_CASE("shocks and fans in space are those in the plane") {
  CHECK(largest_error<3>(sorting::Mixed{}, 0.0625, 0, {0.6}) < 1.0);
  CHECK(largest_error<3>(sorting::Inverted{}, 0.0625, 0, {0.9}) < 1.0);
}

TEST_CASE("shocks and fans among disordered particles") {
  // Displaced by up to a tenth of a spacing. The additional error does not fall with the spacing, see the
  // documentation.
  CHECK(largest_error<2>(sorting::Mixed{}, 0.02, 0.1, {0.3, 0.6, 0.9}) < 1.5);
  CHECK(largest_error<2>(sorting::Inverted{}, 0.02, 0.1, {0.3, 0.9, 1.5}) < 1.5);
  CHECK(largest_error<3>(sorting::Inverted{}, 0.0625, 0.1, {0.9}) < 1.5);
}

TEST_CASE("the hybrid scheme does not sort without diffusion") {
  // The scheme is not meant for this: oscillations behind shocks take it far out of [0, 1], and a jump from 1 to 0 does
  // not change.
  double const dr = 0.02;
  auto mixed = layer_of<Hybrid, 2>(sorting::Mixed{}, dr, 0);
  auto const rings = run(mixed, sorting::Mixed{}, 0.6);
  INFO("error " << rings.error << " spacings, out of [0, 1] by " << rings.outside << ", lost " << rings.lost);
  CHECK(rings.outside > 0.2);
  CHECK(rings.error > 3);
  auto inverted = layer_of<Hybrid, 2>(sorting::Inverted{}, dr, 0);
  run(inverted, sorting::Inverted{}, 0.9);
  CHECK(concentrations_of(inverted.solver) == inverted.start);
}

}  // namespace scree::test::segregation_shocks_tests
