// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/passes/fuse.hpp>

#include <scree/boundaries/adami.hpp>
#include <scree/boundaries/conserving.hpp>
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/granular/granular.hpp>
#include <scree/neighbours/verlet_list.hpp>
#include <scree/passes/stage.hpp>

#include <support/bodies.hpp>
#include <support/two_bodies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>

namespace scree::test::fuse_tests {
using namespace fields;
namespace {

template <int K>
struct Sum : Scalar<"sum", "1"> {};
template <int K>
struct Result : Scalar<"result", "1"> {};

/// Sum K of the field F of neighbours.
template <int K, class F>
struct Add {
  using reads = Fields<Volume, F>;
  using adds = Fields<Sum<K>>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    sum[Sum<K>{}] += j[volume] * j[F{}] * ij.W();
  }
};
template <int K, class F>
struct AddTimes : Add<K, F> {
  double factor;
};
/// Writes sum K, times a field of the particle.
template <int K, class Into, class Factor = Volume>
struct Keep {
  using reads = Fields<Factor>;
  using writes = Fields<Into>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    out[Into{}] = total[Sum<K>{}] * i[Factor{}];
  }
};
/// A lens with a value.
struct Scaled {
  double by;
  bool operator==(Scaled const&) const = default;
  using provides = Fields<Mass>;
  using reads = Fields<Mass>;
  template <class I, class J>
  SCREE_FN auto operator()(Mass, I const&, J const& j) const {
    return by * j[mass];
  }
};

struct Mirrored : GranularModels {
  using volume_control = VolumeConsistency;
  using walls = MirrorWalls;
};
struct Conserved : GranularModels {
  using walls = ConservingWalls;
};
template <class Q>
struct WithLists : Q {
  template <class P>
  using search = VerletList<P>;
};
template <class... Passes>
constexpr std::size_t sweeps_of(Passes const&... passes) {
  return std::tuple_size_v<decltype(fused(std::tuple(passes...)))>;
}

auto const first = pair_pass_then<Material>("test::first", Keep<0, Result<0>>{}, over<Material>(Add<0, Mass>{}));

}  // namespace

TEST_CASE("passes over one body that do not depend on each other are one sweep") {
  auto const second = pair_pass_then<Material>("test::second", Keep<1, Result<1>>{}, over<Material>(Add<1, Density>{}));
  auto const both = fused(std::tuple(first, second));
  STATIC_REQUIRE(std::tuple_size_v<decltype(both)> == 1);
  CHECK(std::get<0>(both).label == "test::first+second");
  STATIC_CHECK(std::is_same_v<decltype(std::get<0>(both).overs),
                              detail::Tuple<Over<Material, AsIs, Add<0, Mass>, Add<1, Density>>>>);
  auto const other = pair_pass_then<Wall>("test::wall", Keep<1, Result<1>>{}, over<Material>(Add<1, Density>{}));
  CHECK(sweeps_of(first, other) == 2);
  CHECK(std::get<0>(
            fused(std::tuple(other, pair_pass_then<Wall>("own", Keep<0, Result<0>>{}, over<Material>(Add<0, Mass>{})))))
            .label == "test::wall+own");
}

TEST_CASE("passes stay apart where one sweep would give something else") {
  // The second reads a field that the first writes, of the particle itself or of neighbours,
  CHECK(sweeps_of(first, pair_pass_then<Material>("own", Keep<1, Result<1>, Result<0>>{},
                                                  over<Material>(Add<1, Mass>{}))) == 2);
  CHECK(sweeps_of(first, pair_pass_then<Material>("neighbour", Keep<1, Result<1>>{},
                                                  over<Material>(Add<1, Result<0>>{}))) == 2);
  // the second writes what the first reads of neighbours (of the particle itself it may),
  CHECK(sweeps_of(first, pair_pass_then<Material>("mass", Keep<1, Mass>{}, over<Wall>(Add<1, Mass>{}))) == 2);
  auto const of_own_mass =
      pair_pass_then<Material>("test::own", Keep<0, Result<0>, Mass>{}, over<Material>(Add<0, Density>{}));
  CHECK(sweeps_of(of_own_mass, pair_pass_then<Material>("mass", Keep<1, Mass>{}, over<Wall>(Add<1, Mass>{}))) == 1);
  // sums are stored, or only some particles are targets.
  CHECK(sweeps_of(first, pair_pass<Material>("stored", over<Material>(Add<1, Mass>{}))) == 2);
  struct Heavy : Everywhere {};
  CHECK(sweeps_of(first, pair_pass_where<Material>("where", Heavy{}, Keep<1, Result<1>>{},
                                                   over<Material>(Add<1, Mass>{}))) == 2);
}

TEST_CASE("a sum that two passes need is computed once, unless they need different sums") {
  auto const same = pair_pass_then<Material>("same", Keep<0, Result<1>>{}, over<Material>(Add<0, Mass>{}));
  [[maybe_unused]] auto const both = fused(std::tuple(first, same));
  STATIC_REQUIRE(std::tuple_size_v<decltype(both)> == 1);
  STATIC_CHECK(std::is_same_v<decltype(std::get<0>(both).overs), detail::Tuple<Over<Material, AsIs, Add<0, Mass>>>>);
  auto const of_density = pair_pass_then<Material>("other", Keep<0, Result<1>>{}, over<Material>(Add<0, Density>{}));
  CHECK(sweeps_of(first, of_density) == 2);
  auto const of_wall = pair_pass_then<Material>("wall", Keep<0, Result<1>>{}, over<Wall>(Add<0, Mass>{}));
  CHECK(sweeps_of(first, of_wall) == 2);
  // The values of terms cannot be compared at compile time.
  auto const with_value = [](double factor) {
    return pair_pass_then<Material>("value", Keep<0, Result<1>>{}, over<Material>(AddTimes<0, Mass>{{}, factor}));
  };
  CHECK(sweeps_of(with_value(1), with_value(2)) == 2);
}

TEST_CASE("a pass moves in front of others only if that changes nothing") {
  auto const second = pair_pass_then<Material>("test::second", Keep<1, Result<1>>{}, over<Material>(Add<1, Density>{}));
  auto const between = [](auto keep) {
    return pair_pass_then<Wall>("between", keep, over<Material>(Add<2, Volume>{}));
  };
  auto const unrelated = fused(std::tuple(first, between(Keep<2, Result<2>>{}), second));
  STATIC_REQUIRE(std::tuple_size_v<decltype(unrelated)> == 2);
  CHECK(std::get<0>(unrelated).label == "test::first+second");
  // It writes what the second pass reads,
  auto const writes_density = pair_pass_then<Material>("density", Keep<2, Density>{}, over<Wall>(Add<2, Mass>{}));
  auto const stay = fused(std::tuple(first, point_pass<Wall>("wall", Keep<2, Result<2>>{}), writes_density, second));
  CHECK(std::tuple_size_v<decltype(stay)> == 3);
  CHECK(std::get<2>(stay).label == "test::second");
  // or reads what both write;
  auto const reads_both =
      pair_pass_then<Material>("both", Keep<2, Result<2>, Result<0>>{}, over<Material>(Add<2, Result<1>>{}));
  CHECK(sweeps_of(first, reads_both, second) == 3);
  // if it reads only what the second pass writes, the first can move behind it.
  auto const reads_second = pair_pass_then<Wall>("reads", Keep<2, Result<2>>{}, over<Material>(Add<2, Result<1>>{}));
  auto const moved = fused(std::tuple(first, reads_second, second));
  REQUIRE(std::tuple_size_v<decltype(moved)> == 2);
  CHECK(std::get<0>(moved).label == "reads");
  CHECK(std::get<1>(moved).label == "test::first+second");
  // Or it moves particles, on which all sums depend.
  CHECK(sweeps_of(first, point_pass<Material>("move", Keep<2, Position>{}), second) == 3);
}

TEST_CASE("passes with lenses of one type are fused if the lenses can be compared, and must be equal") {
  auto const seen = [](double by) {
    return pair_pass_then<Material>("seen", Keep<0, Result<0>>{}, over_through<Wall>(Scaled{by}, Add<0, Mass>{}));
  };
  auto const also = [](double by) {
    return pair_pass_then<Material>("also", Keep<1, Result<1>>{}, over_through<Wall>(Scaled{by}, Add<1, Mass>{}));
  };
  CHECK(sweeps_of(seen(2), also(2)) == 1);
  CHECK_THROWS_WITH(fused(std::tuple(seen(2), also(3))), Catch::Matchers::ContainsSubstring("two lenses of one type"));
}

TEST_CASE("the rates of a granular material are one sweep, and one more over walls that extrapolate") {
  auto const labels_of = [](auto const& physics) {
    return std::apply([](auto const&... each) { return std::array{std::string(each.label)...}; },
                      rate_passes(physics, {}));
  };
  CHECK(labels_of(Granular<>{}) ==
        std::array<std::string, 2>{"scree::wall_velocity+wall_stress", "scree::strain_rates+acceleration"});
  CHECK(labels_of(Granular<Conserved>{}) == labels_of(Granular<>{}));
  CHECK(labels_of(Granular<Mirrored>{}) == std::array<std::string, 1>{"scree::strain_rates+acceleration"});
}

TEST_CASE("lists of the library can be joined with std::tuple_cat") {
  Granular<> const sand{.law = {.elastic = {1e5, 0.3, 1500}, .grains = {1e-3}}};
  auto const passes = std::tuple_cat(rate_passes(sand, {}), fused(std::tuple(first)), sand.wall_force_passes({}),
                                     only_if(true, std::tuple(first)), sand.filters({}));
  CHECK(std::get<2>(passes).label == "test::first");
  auto const bounds = std::tuple_cat(sand.validity({}), std::tuple(1));
  CHECK(std::get<0>(bounds).most == sand.largest_mach);
  Resolution const resolution{.dimensions = 2, .spacing = 0.01, .smoothing_length = 0.015};
  CHECK(std::get<1>(std::tuple_cat(std::tuple(1), sand.limits(resolution))).name == "acoustic");
}

TEMPLATE_LIST_TEST_CASE("fused passes give the results of the passes one by one", "", Policies) {
  using P = WithLists<TestType>;
  constexpr int dim = P::dim;
  auto const passes = std::tuple(
      first, pair_pass_then<Wall>("wall", Keep<0, Mass>{}, over<Material>(Add<0, Mass>{})),
      pair_pass_then<Material>("test::second", Keep<1, Result<1>>{}, over<Material>(Add<1, Density>{}, Add<0, Mass>{}),
                               over<Wall>(Add<1, Density>{})));
  auto const results = [&](auto const& list) {
    using Lists = std::remove_cvref_t<decltype(list)>;
    TwoBodies<P, VerletList<P>, fields_of_passes<Material, Lists>, fields_of_passes<Wall, Lists>> system(0.15, {});
    auto const fill = [&](auto& body, auto const& points) {
      body.resize(static_cast<int>(points.size()));
      body.from_host(position, cast<typename P::real>(points));
      auto const of = [](double a) { return [a](auto const& x) { return 1 + a * x[0]; }; };
      set(body, volume, of(0.01)), set(body, mass, of(0.5)), set(body, density, of(2));
    };
    auto points = lattice<dim>(0.1);
    fill(system.template body<Material>(), points);
    for (auto& x : points) x[0] += 0.97;
    fill(system.template body<Wall>(), points);
    system.positions_changed();
    run_passes(system, list);
    auto const& material = system.template body<Material>();
    return std::tuple(material.to_host(Result<0>{}), material.to_host(Result<1>{}),
                      system.template body<Wall>().to_host(mass));
  };
  STATIC_REQUIRE(std::tuple_size_v<decltype(fused(passes))> == 2);
  auto const one_by_one = results(passes), at_once = results(fused(passes));
  auto const worst = [](auto const& a, auto const& b) {
    double difference = 0, size = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
      difference = std::max(difference, std::abs(double(a[k] - b[k]))), size = std::max(size, std::abs(double(a[k])));
    REQUIRE(size > 0.1);
    return difference / size;
  };
  CHECK(worst(std::get<0>(one_by_one), std::get<0>(at_once)) < ulps<P>(8));
  CHECK(worst(std::get<1>(one_by_one), std::get<1>(at_once)) < ulps<P>(8));
  CHECK(worst(std::get<2>(one_by_one), std::get<2>(at_once)) < ulps<P>(8));
}

}  // namespace scree::test::fuse_tests
