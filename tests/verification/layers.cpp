// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <scree/boundaries/conserving.hpp>
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/laws/by_group.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// Layers of different materials, each a group of one body.
namespace scree::test::layers_tests {
using namespace fields;
namespace {

MuOfI<> material(double density, double mu_s = 0.382) {
  MuOfI<> law = beads(10, 1e-3);
  law.elastic.young *= density / law.elastic.rest_density;  // the same wave speed
  law.elastic.rest_density = density;
  law.mu_s = mu_s, law.mu_d = mu_s + 0.3;
  return law;
}

template <class OfWalls>
struct LayerModels : GranularModels {
  using law = ByGroup<MuOfI<>>;
  using walls = OfWalls;
};
template <class OfWalls>
using Layered = Granular<LayerModels<OfWalls>>;

template <class OfWalls>
struct WithWallForces : GranularCase<2, Layered<OfWalls>> {
  using diagnostics = WallForces;
};

/// A bed of two layers on a floor, periodic to the sides.
struct Bed {
  double below, above;  // kg/m^3
  int rows = 20;
  double depth = 0.1;  // m

  double spacing() const { return depth / rows; }
  double width() const { return 20 * spacing(); }
  /// -sigma_zz, Pa.
  double pressure(double z) const {
    return g * (above * (depth - std::max(z, depth / 2)) + below * std::max(0.0, depth / 2 - z));
  }
};

/// The mean of -sigma_zz of each row over the second half of a run, less the exact one, over that at the floor; and the
/// packing at the end.
struct Rows {
  std::vector<double> errors;
  Packing packing;
};
template <class OfWalls>
Rows rows_at_rest(Bed const& bed) {
  using P = GranularCase<2, Layered<OfWalls>>;
  double const dr = bed.spacing(), middle = bed.depth / 2;
  Groups<2> groups;
  groups.add("below", fill_lattice(Box<2>{{0, 0}, {bed.width(), middle}}, dr));
  groups.add("above", fill_lattice(Box<2>{{0, middle}, {bed.width(), bed.depth}}, dr));
  // The viscosity damps the waves from the start; it has no part in a bed at rest.
  Layered<OfWalls> physics{.law = ByGroup<MuOfI<>>(groups), .viscosity_speed = 5};
  physics.law.set(groups.number("below"), material(bed.below)).set(groups.number("above"), material(bed.above));
  std::vector<Vec<2, double>> const floor = fill_lattice(Box<2>{{0, -4 * dr}, {bed.width(), 0}}, dr);
  Solver<P> solver({.spacing = dr, .physics = physics, .periods = {{0, 0, bed.width()}}}, groups, floor);
  solver.set(stress, [&](auto const& x) {
    double const p = bed.pressure(x[1]);
    return Vec<4, double>(-p / 2, -p, -p / 2, 0);
  });
  solver.set(velocity, [](auto const&) { return Vec<2, double>(0, 0); });
  std::vector<double> sum(std::size_t(bed.rows)), number(std::size_t(bed.rows));
  double const end = 1.0;
  solver.run(end / 2);
  solver.run(end, {every<Solver<P>>(1e-3, [&](Solver<P>& s) {
               auto const x = s.material().to_host(position);
               auto const sigma = s.material().to_host(stress);
               for (std::size_t i = 0; i < x.size(); ++i) {
                 auto const row = std::size_t(std::clamp(int(x[i][1] / dr), 0, bed.rows - 1));
                 sum[row] += (-sigma[i][1] - bed.pressure(x[i][1])) / bed.pressure(0), number[row] += 1;
               }
             })});
  for (std::size_t row = 0; row < sum.size(); ++row) sum[row] /= number[row];
  return {sum, solver.packing()};
}
/// The largest errors of rows, and of means with weights 1/4, 1/2, 1/4 over three rows: errors of neighbouring rows
/// alternate. Below the uppermost two rows, where a bed of one material has 1 % as well.
struct Worst {
  double of_rows = 0, of_means = 0;
};
Worst worst_of(std::vector<double> const& errors) {
  Worst worst;
  for (std::size_t row = 0; row + 2 < errors.size(); ++row) {
    double const below = errors[row == 0 ? 0 : row - 1], here = errors[row], above = errors[row + 1];
    worst.of_rows = std::max(worst.of_rows, std::abs(here));
    worst.of_means = std::max(worst.of_means, std::abs(below / 4 + here / 2 + above / 4));
  }
  return worst;
}

}  // namespace

TEMPLATE_TEST_CASE("layers of different density rest under the pressure of their weight", "", AdamiWalls, MirrorWalls,
                   ConservingWalls) {
  for (Bed const& bed : {Bed{2000, 1000}, Bed{1000, 2000}}) {
    auto const [errors, packing] = rows_at_rest<TestType>(bed);
    auto const worst = worst_of(errors);
    CAPTURE(bed.above, bed.below, errors, worst.of_means, worst.of_rows, packing.text());
    CHECK(worst.of_means < 0.01);
    CHECK(worst.of_rows < 0.025);
    CHECK(is_packed_as_at_rest(packing));
  }
}

TEMPLATE_TEST_CASE("the force of layers on walls is what the material does not gain as momentum", "", AdamiWalls,
                   MirrorWalls) {
  using P = WithWallForces<TestType>;
  double const dr = 0.005;
  Groups<2> groups;
  groups.add("below", fill_lattice(Box<2>{{0, 0}, {0.1, 0.05}}, dr))
      .add("above", fill_lattice(Box<2>{{0, 0.05}, {0.1, 0.1}}, dr));
  Layered<TestType> physics{.law = ByGroup<MuOfI<>>(groups)};
  physics.law.set(0, material(1000)).set(1, material(2000));
  Solver<P> solver({.spacing = dr, .physics = physics}, groups,
                   fill_between(Box<2>{{0, 0}, {0.1, 0.15}}, Box<2>{{-0.02, -0.02}, {0.12, 0.15}}, dr));
  solver.set(stress, [](auto const& x) { return Vec<4, double>(-9e3 * x[0], -5e3 * (0.2 - x[1]), -700, 300); });
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(std::sin(40 * x[1]), std::cos(50 * x[0])); });
  solver.update_rates();
  solver.update_diagnostics();
  Vec<2, double> gained(0, 0), on_walls(0, 0);
  auto const a = solver.material().to_host(acceleration);
  auto const V = solver.material().to_host(volume), rho = solver.material().to_host(density);
  for (std::size_t i = 0; i < a.size(); ++i) gained += rho[i] * V[i] * (a[i] - Vec<2, double>(0, -g));
  for (auto const& f : solver.wall().to_host(wall_force)) on_walls += f;
  CHECK(on_walls.norm() > 10);
  CHECK((gained + on_walls).norm() < 1e-11 * on_walls.norm());
}

TEST_CASE("three layers of different friction that flow keep their momentum and the mass of each") {
  using P = GranularCase<2, Layered<AdamiWalls>>;
  double const dr = 0.005;
  Groups<2> groups;
  for (int k = 0; k < 3; ++k)
    groups.add("layer " + std::to_string(k), fill_lattice(Box<2>{{0, 0.05 * k}, {0.1, 0.05 * (k + 1)}}, dr));
  Layered<AdamiWalls> physics{.law = ByGroup<MuOfI<>>(groups), .gravity = {.magnitude = 0}};
  std::array<double, 3> const densities = {1500, 1000, 2000}, frictions = {0.5, 0.2, 0.35};
  for (int k = 0; k < 3; ++k) physics.law.set(k, material(densities[std::size_t(k)], frictions[std::size_t(k)]));
  Solver<P> solver({.spacing = dr, .physics = physics}, groups);
  solver.set(stress, [](auto const&) { return Vec<4, double>(-500, -500, -500, 0); });
  // Flattened along one axis as it would be by its weight; nothing holds it, so its momentum is constant.
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(2 * (x[0] - 0.05), -2 * (x[1] - 0.075)); });
  auto const state = [&] {
    auto const u = solver.material().to_host(velocity);
    auto const V = solver.material().to_host(volume), rho = solver.material().to_host(density);
    auto const number = solver.material().to_host(group);
    std::array<double, 3> mass = {};
    Vec<2, double> momentum(0, 0);
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      mass[std::size_t(number[i])] += rho[i] * V[i];
      momentum += rho[i] * V[i] * u[i], sum += rho[i] * V[i] * u[i].norm();
    }
    return std::tuple(mass, momentum, sum);
  };
  solver.update_rates();
  auto const [mass, momentum, sum] = state();
  solver.run(0.05);
  auto const [mass_then, momentum_then, sum_then] = state();
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(std::abs(mass[k] / (densities[k] * 0.1 * 0.05) - 1) < 1e-12);
    CHECK(mass[k] == mass_then[k]);
  }
  INFO("momentum changes by " << (momentum_then - momentum).norm() / sum << " of the sum of its parts");
  show_packing(solver);
  CHECK((momentum_then - momentum).norm() < 1e-13 * sum * double(solver.steps()));
  CHECK(solver.steps() > 100);
  CHECK(std::abs(sum_then / sum - 1) > 0.01);  // something happened
}

}  // namespace scree::test::layers_tests
