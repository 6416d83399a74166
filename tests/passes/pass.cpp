// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/passes/run_passes.hpp>

#include <support/bodies.hpp>
#include <support/two_bodies.hpp>

#include <scree/neighbours/verlet_list.hpp>
#include <scree/terms/kernel_sums.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <type_traits>

namespace scree::test::pass_tests {
using namespace fields;

template <class Q>
struct SystemPolicy : Q {
  template <class P>
  using search = VerletList<P>;
};

/// Adds up the density of the wall, weighted with the material's own `Mass`.
struct DensityOfWall {
  using reads = Fields<Volume, Density>;
  using reads_i = Fields<Mass>;
  using adds = Fields<Concentration>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    sum[concentration] += i[mass] * j[volume] * j[density] * ij.W();
  }
};
struct DoubleVolume {
  using reads = Fields<Volume>;
  using writes = Fields<Volume>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[volume] = 2 * i[volume];
  }
};
/// Density = 3 x (sum over material).
struct TripleSum {
  using reads = Fields<>;
  using writes = Fields<Density>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    out[density] = 3 * total[kernel_sum<Material>];
  }
};
/// For material particles, as neighbours of the wall: their volume is taken from their mass.
struct VolumeOfMass {
  using provides = Fields<Volume>;
  using reads = Fields<Mass>;
  template <class I, class J>
  SCREE_FN auto operator()(Volume, I const&, J const& j) const {
    return j[mass];
  }
};
/// The volume of a wall particle as a material particle sees it: weighted with the mass of the latter.
struct VolumeByOwnMass {
  using provides = Fields<Volume>;
  using reads = Fields<Density>;
  using reads_i = Fields<Mass>;
  template <class I, class J>
  SCREE_FN auto operator()(Volume, I const& i, J const& j) const {
    return i[mass] * j[density];
  }
};
struct Heavy {
  using reads = Fields<Mass>;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[mass] > 2;
  }
};

namespace {

auto wall_then_material() {
  return std::tuple(pair_pass_then<Wall>("wall", TripleSum{}, over<Material>(KernelSums<Material>{})),
                    pair_pass<Material>("material", over<Wall>(DensityOfWall{})));
}
using Passes = decltype(wall_then_material());

template <class A, class B>
constexpr bool same_set = std::is_same_v<Without<A, B>, Fields<>>&& std::is_same_v<Without<B, A>, Fields<>>;

}  // namespace

TEST_CASE("the fields of a body follow from the passes") {
  STATIC_CHECK(same_set<fields_of_passes<Wall, Passes>, Fields<Position, Volume, Density>>);
  STATIC_CHECK(same_set<fields_of_passes<Material, Passes>, Fields<Position, Volume, Density, Mass, Concentration>>);
  // Sums that only `then` reads, kernel_sum here, are not fields of the body; reads_i is a field of the target only.
  STATIC_CHECK_FALSE(OneOf<KernelSum<Material>, fields_of_passes<Wall, Passes>>);
  STATIC_CHECK_FALSE(OneOf<Mass, fields_of_passes<Wall, Passes>>);
  STATIC_CHECK(OneOf<Mass, fields_of_passes<Material, Passes>>);
  STATIC_CHECK(OneOf<Concentration, fields_of_passes<Material, Passes>>);
  STATIC_CHECK(std::is_same_v<fields_of_passes<Wall, std::tuple<>>, Fields<>>);
}

TEST_CASE("what a lens provides need not be a field of the source, what it reads must") {
  using OfWall =
      decltype(std::tuple(pair_pass<Wall>("", over_through<Material>(VolumeOfMass{}, KernelSums<Material>{}))));
  STATIC_CHECK(same_set<fields_of_passes<Material, OfWall>, Fields<Position, Mass>>);
  STATIC_CHECK(OneOf<KernelGradient<Material>, fields_of_passes<Wall, OfWall>>);
}

TEMPLATE_LIST_TEST_CASE("a lens may read the target", "", Backends) {
  using Q = SystemPolicy<Policy<2, double, TestType>>;
  auto const passes =
      std::tuple(pair_pass<Material>("seen", over_through<Wall>(VolumeByOwnMass{}, KernelSums<Wall>{})));
  using OfPasses = std::remove_const_t<decltype(passes)>;
  using OfMaterial = fields_of_passes<Material, OfPasses>;
  STATIC_REQUIRE(OneOf<Mass, OfMaterial>);
  TwoBodies<Q, VerletList<Q>, Merge<OfMaterial, Fields<Identity>>,
            Merge<fields_of_passes<Wall, OfPasses>, Fields<Identity>>>
      system(1, {});
  auto& material = system.template body<Material>();
  auto& wall = system.template body<Wall>();
  material.resize(1);
  wall.resize(1);
  material.fill(position, zero<Vec<2, double>>());
  wall.fill(position, zero<Vec<2, double>>());
  material.fill(mass, 3.0);
  wall.fill(density, 5.0);
  system.positions_changed();
  run_passes(system, passes);
  CHECK(std::abs(material.to_host(kernel_sum<Wall>)[0] - 15 * system.kernel().value(0)) < 1e-12);
}

TEST_CASE("conditions and point functions bring their fields") {
  using List =
      decltype(std::tuple(pair_pass_where<Material>("", Heavy{}, StoreSums{}, over<Material>(KernelSums<Material>{})),
                          point_pass<Wall>("", DoubleVolume{})));
  STATIC_CHECK(OneOf<Mass, fields_of_passes<Material, List>>);
  STATIC_CHECK(std::is_same_v<fields_of_passes<Wall, List>, Fields<Volume>>);
}

TEMPLATE_LIST_TEST_CASE("passes run in order, over the bodies they name", "", Policies) {
  using P = SystemPolicy<TestType>;
  using MaterialFields = Fields<Position, Volume, Mass, Density, Concentration>;
  constexpr int dim = P::dim;
  TwoBodies<P, typename P::template search<P>, MaterialFields, Fields<Position, Volume, Density>> system(0.15, {});
  auto const points = lattice<dim>(0.1);
  Points<dim> left, right;
  for (auto const& x : points) (x[0] < 0.5 ? left : right).push_back(x);
  auto& material = system.template body<Material>();
  auto& wall = system.template body<Wall>();
  material.resize(static_cast<int>(left.size()));
  wall.resize(static_cast<int>(right.size()));
  material.from_host(position, cast<typename P::real>(left));
  wall.from_host(position, cast<typename P::real>(right));
  material.fill(volume, typename P::real(std::pow(0.1, dim)));
  material.fill(mass, 1);
  wall.fill(volume, typename P::real(std::pow(0.1, dim)));
  system.positions_changed();
  run_passes(system, wall_then_material());

  // By hand: the material sees the densities that the first pass computed.
  KernelFunction<WendlandC2, dim, double> const W(0.15);
  auto const share = [&](auto const& a, auto const& b) {
    double const r = (a - b).norm();
    return r < W.radius() ? std::pow(0.1, dim) * W.value(r) : 0.0;
  };
  std::vector<double> densities;
  for (auto const& x : right) {
    double sum = 0;
    for (auto const& y : left) sum += share(x, y);
    densities.push_back(3 * sum);
  }
  double error = 0, largest_value = 0;
  auto const found = material.to_host(concentration);
  for (std::size_t i = 0; i < left.size(); ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < right.size(); ++j) sum += densities[j] * share(left[i], right[j]);
    error = std::max(error, std::abs(double(found[i]) - sum));
    largest_value = std::max(largest_value, sum);
  }
  CHECK(largest_value > 0.01);
  CHECK(error < ulps<P>(200));
}

TEMPLATE_LIST_TEST_CASE("a pass sees ghosts with the present values of their origins", "", Policies) {
  using P = SystemPolicy<TestType>;
  constexpr int dim = P::dim;
  std::vector<Period> periods;
  for (int axis = 0; axis < dim; ++axis) periods.push_back({axis, 0, 1});
  TwoBodies<P, typename P::template search<P>, Fields<Position, Volume, KernelSum<Material>, KernelGradient<Material>>,
            Fields<Position, Volume>>
      system(0.15, periods);
  auto& material = system.template body<Material>();
  auto const points = lattice<dim>(0.1);
  material.resize(static_cast<int>(points.size()));
  material.from_host(position, cast<typename P::real>(points));
  material.fill(volume, typename P::real(std::pow(0.1, dim)));
  system.positions_changed();
  auto const sum = std::tuple(pair_pass<Material>("sums", over<Material>(KernelSums<Material>{})));
  run_passes(system, sum);
  auto const before = material.to_host(kernel_sum<Material>);
  run_passes(system, std::tuple_cat(std::tuple(point_pass<Material>("double", DoubleVolume{})), sum));
  auto const after = material.to_host(kernel_sum<Material>);
  double error = 0;
  for (std::size_t i = 0; i < after.size(); ++i) error = std::max(error, std::abs(double(after[i] - 2 * before[i])));
  CHECK(error == 0);  // a factor of two changes no digit
  CHECK(double(before[0]) > 0.98);
}

/// A pass of a user, which does more than the one that it derives from.
struct Counted : PointPass<Material, DoubleVolume> {
  int* runs;
  Counted(PointPass<Material, DoubleVolume> const& pass, int& count)
      : PointPass<Material, DoubleVolume>(pass), runs(&count) {}
  template <class Sys>
  void run(Sys& system) const {
    ++*runs;
    PointPass<Material, DoubleVolume>::run(system);
  }
};

TEMPLATE_LIST_TEST_CASE("a pass that derives from one of the library runs its own function, only if it is active", "",
                        Policies) {
  using P = SystemPolicy<TestType>;
  using Sys = TwoBodies<P, typename P::template search<P>, Fields<Position, Volume>, Fields<Position, Volume>>;
  Sys system(0.15, {});
  auto& material = system.template body<Material>();
  material.resize(3);
  material.fill(volume, typename P::real(1));
  int runs = 0;
  Counted const counted(point_pass<Material>("double", DoubleVolume{}), runs);
  run_passes(system, std::tuple(counted));
  CHECK(runs == 1);
  CHECK(material.to_host(volume)[2] == 2);
  run_passes(system, only_if(false, std::tuple(counted)));
  run_passes(system, only_if(true, std::tuple(counted, counted)));
  CHECK(runs == 3);
  CHECK(material.to_host(volume)[0] == 8);
}

}  // namespace scree::test::pass_tests
