// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "pendulum.hpp"

#include <scree/boundaries/mirror_lens.hpp>
#include <scree/granular/segregating.hpp>
#include <scree/motion/rotation.hpp>
#include <scree/segregation/shear_rate_closure.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

// The stages of the granular physics model are its passes split up: for one state both give the same rates.
namespace scree::test::granular_stages_tests {
using namespace fields;
namespace {

template <class Walls>
struct Models : GranularModels {
  using law = VolumeMemory<MuOfI<BidisperseGrains>>;
  using filter = NoFilter;
  using volume_control = VolumeConsistency;
  using walls = Walls;
};
template <class Walls>
using Mechanics = Granular<Models<Walls>>;
template <class Walls>
using Sorting = SegregatingGranular<Mechanics<Walls>, ConservativeSegregation<ShearRateClosure>>;
template <class Walls>
using Staggered = Integrated<Formulated<PendulumPolicy, Sorting<Walls>, Rotation>, SymplecticEuler>;

template <class Walls>
Sorting<Walls> physics() {
  Sorting<Walls> all;
  all.mechanics.law = {{.elastic = {1e5, 0.3, 1500}, .grains = {0.01, 0.02}}};
  all.transport.closure = {.chi_V = 0.11, .chi_D = 0.03, .d_small = 0.01, .d_large = 0.02};
  return all;
}

/// A turning bed under its weight, sheared, with unequal concentrations.
template <class Walls>
auto sheared_bed() {
  auto solver = solver_of<Staggered<Walls>>(open_bed<2>({1, 0.6}, 0.1), 0.1, physics<Walls>(), {.rate = 0.3});
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(0.1 * x[1] * x[1], 0.02 * std::sin(4 * x[0])); });
  solver.set(concentration, [](auto const& x) { return 0.5 + 0.3 * std::sin(5 * x[0] + x[1]); });
  solver.set(stress, [](auto const& x) {
    double const p = 1500 * 9.81 * (0.65 - x[1]);
    return Vec<4, double>(-0.5 * p, -p, -0.6 * p, 0.1 * p);
  });
  return solver;
}

template <class Values>
double largest_difference(Values const& a, Values const& b) {
  double worst = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if constexpr (std::is_arithmetic_v<typename Values::value_type>)
      worst = std::max(worst, std::abs(a[i] - b[i])), size = std::max(size, std::abs(a[i]));
    else
      worst = std::max(worst, (a[i] - b[i]).norm()), size = std::max(size, a[i].norm());
  return size > 0 ? worst / size : 1;
}

using Schemes = std::tuple<AdamiWalls, MirrorWalls>;

}  // namespace

TEMPLATE_LIST_TEST_CASE("stages give the rates that the passes give", "", Schemes) {
  auto solver = sheared_bed<TestType>();
  auto const rates = [&] {
    auto const& body = solver.material();
    return std::tuple(body.to_host(acceleration), body.to_host(stress_rate), body.to_host(concentration_rate),
                      body.to_host(shear_rate));
  };
  solver.update_rates();
  auto const together = rates();
  solver.stepper().evaluate(solver.stepper().stages());
  auto const apart = rates();
  CHECK(largest_difference(std::get<0>(together), std::get<0>(apart)) < 1e-13);
  CHECK(largest_difference(std::get<1>(together), std::get<1>(apart)) < 1e-13);
  CHECK(largest_difference(std::get<2>(together), std::get<2>(apart)) < 1e-13);
  CHECK(largest_difference(std::get<3>(together), std::get<3>(apart)) < 1e-13);
}

TEMPLATE_LIST_TEST_CASE("a stage gives in one sweep what its parts give one by one", "", Schemes) {
  auto at_once = sheared_bed<TestType>(), one_by_one = sheared_bed<TestType>();
  double const dt = 1e-4;
  auto now = at_once.stepper(), in_ranks = one_by_one.stepper();
  auto const strain = std::get<0>(now.stages());
  now.evaluate(strain), now.advance(strain, dt);
  in_ranks.evaluate(strain), in_ranks.evaluate(strain);
  in_ranks.apply(staggered_update<basis_of<Staggered<TestType>>>(typename decltype(strain)::evolves{}, dt));
  in_ranks.project(strain);
  auto const &a = at_once.material(), &b = one_by_one.material();
  CHECK(largest_difference(a.to_host(stress), b.to_host(stress)) < 1e-15);
  CHECK(largest_difference(a.to_host(concentration), b.to_host(concentration)) < 1e-15);
  CHECK(largest_difference(a.to_host(shear_rate), b.to_host(shear_rate)) < 1e-15);
  // The step has an effect: both the stress and the concentration have changed.
  auto const before = sheared_bed<TestType>();
  CHECK(largest_difference(a.to_host(stress), before.material().to_host(stress)) > 1e-4);
  CHECK(largest_difference(a.to_host(concentration), before.material().to_host(concentration)) > 1e-9);
}

TEMPLATE_LIST_TEST_CASE("a granular bed runs with staggered steps and keeps its mean concentration", "", Schemes) {
  auto solver = sheared_bed<TestType>();
  auto const mean = [&] { return sum_of(concentrations_of(solver)) / solver.material().size(); };
  double const before = mean();
  solver.run(0.05);
  CHECK(solver.steps() > 10);
  CHECK(std::abs(mean() - before) < 1e-14);
  double fastest = 0;
  for (auto const& u : solver.material().to_host(velocity)) fastest = std::max(fastest, u.norm());
  INFO("fastest " << fastest << " m/s after " << solver.steps() << " steps");
  CHECK(fastest < 1);
}

}  // namespace scree::test::granular_stages_tests
