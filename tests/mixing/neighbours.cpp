// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "bed.hpp"

#include <scree/mixing/neighbours.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::neighbours_tests {
using namespace fields;
using namespace mixing;
namespace {
bool near(double a, double b, double by) { return std::abs(a - b) <= by; }

template <int Dim, class Real, class Kinds, class Carried>
struct Observed : MixedBed<Dim, Real, Carried> {
  using diagnostics = NeighbourMixing<Kinds>;
};
template <int Dim, class Real = double, class Kinds = TwoSizes, class Carried = Fields<>>
auto observed(int rows, std::vector<Period> const& periods = {}, Kinds const& kinds = {}) {
  using F = Observed<Dim, Real, Kinds, Carried>;
  using vector = Vec<Dim, double>;
  double const dr = 1.0 / rows;
  auto const points = fill_lattice(Box<Dim>{vector::Zero(), vector::Constant(1)}, dr);
  return Solver<F>({.spacing = dr, .physics = {}, .diagnostics = {kinds}, .periods = periods, .start_checks = false},
                   cast<Real>(points));
}

/// <|z|> over the neighbours of a point of a lattice with spacing dr, in dr, weighted by the kernel.
template <int Dim>
double mean_distance_of_rows() {
  KernelFunction<WendlandC2, Dim, double> const kernel(1.5);
  double sum = 0, weight = 0;
  int const n = 3, depth = Dim == 3 ? n : 0;
  for (int x = -n; x <= n; ++x)
    for (int y = -depth; y <= depth; ++y)
      for (int z = -n; z <= n; ++z) {
        double const r = std::sqrt(double(x * x + y * y + z * z));
        if (r == 0 || r >= kernel.radius()) continue;
        sum += kernel.value(r) * std::abs(z), weight += kernel.value(r);
      }
  return sum / weight;
}

}  // namespace

TEMPLATE_TEST_CASE("mixed grains have the neighbour index 1", "", float, double) {
  auto bed = observed<2, TestType>(12);
  for (double const C : {0.5, 0.1}) {
    bed.set(concentration, [&](auto const&) { return TestType(C); });
    CHECK(near(neighbour_index(bed).value, 1, std::is_same_v<TestType, double> ? 1e-12 : 1e-5));
    CHECK(near(neighbour_index(bed).unlike, 2 * C * (1 - C), std::is_same_v<TestType, double> ? 1e-12 : 1e-6));
  }
}

TEST_CASE("grains that are apart have the neighbour index of their border") {
  for (int const rows : {12, 24}) {  // the border is farther from the ends than a support
    auto plane = observed<2>(rows, {{.axis = 0, .low = 0, .high = 1}});
    plane.set(concentration, [](auto const& x) { return x[1] < 0.5 ? 1.0 : 0.0; });
    CHECK(near(neighbour_index(plane).value, 2 * mean_distance_of_rows<2>() / rows, 1e-12));
  }
  auto space = observed<3>(12, {{.axis = 0, .low = 0, .high = 1}, {.axis = 1, .low = 0, .high = 1}});
  space.set(concentration, [](auto const& x) { return x[2] < 0.5 ? 0.0 : 1.0; });
  CHECK(near(neighbour_index(space).value, 2 * mean_distance_of_rows<3>() / 12, 1e-12));
}

TEST_CASE("particles of one kind each in no order have the neighbour index 1, on average") {
  auto bed = observed<2>(100);
  double mean = 0;
  int const draws = 10;
  std::uint64_t k = 0;
  for (int draw = 0; draw < draws; ++draw) {
    bed.set(concentration, [&](auto const&) { return chance(k++) < 0.3 ? 1.0 : 0.0; });
    mean += neighbour_index(bed).value / draws;
  }
  // Each of 1e5 particles has some ten independent neighbours: a scatter of about 1e-3.
  CHECK(near(mean, 1, 3e-3));
}

TEST_CASE("a chess board prefers unlike neighbours") {
  auto bed = observed<2>(20);
  bed.set(concentration, [](auto const& x) { return (int(20 * x[0]) + int(20 * x[1])) % 2; });
  CHECK(neighbour_index(bed).value > 1.15);
}

TEST_CASE("species and marked particles have the neighbour index of the same concentrations") {
  auto two = observed<2>(10);
  auto three = observed<2, double, SpeciesOf<3>>(10);
  two.set(concentration, [](auto const& x) { return x[0] * x[1]; });
  three.set(concentrations<3>, [](auto const& x) { return Vec<3, double>(x[0] * x[1], 0, 1 - x[0] * x[1]); });
  CHECK(near(neighbour_index(three).value, neighbour_index(two).value, 1e-14));
  auto marked = observed<2, double, MarkedGroup>(10, {}, MarkedGroup{3});
  two.set(concentration, [](auto const& x) { return x[0] < 0.4 ? 1.0 : 0.0; });
  marked.set(group, [](auto const& x) { return x[0] < 0.4 ? 3 : 1; });
  CHECK(near(neighbour_index(marked, MarkedGroup{3}).value, neighbour_index(two).value, 1e-14));
}

TEST_CASE("one kind alone has no neighbour index, and a particle alone no unlike neighbours") {
  auto bed = observed<2>(10);
  CHECK(std::isnan(neighbour_index(bed).value));
  bed.set(position, [](auto const& x) { return Vec<2, double>(100 * x[0], 100 * x[1]); });
  bed.set(concentration, [](auto const& x) { return x[0] < 50 ? 1.0 : 0.0; });
  CHECK(neighbour_index(bed).value == 0);
}

}  // namespace scree::test::neighbours_tests
