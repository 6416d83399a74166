// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "sand3d.hpp"

#include <scree/rigid/measured_mass.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>

// A sphere falls on a bed. Its depth grows as (rho_b/rho_g)^(1/2) D^(2/3) H^(1/3)/mu with the whole way H that it has
// fallen (Uehara, Ambroso, Ojha & Durian 2003), with a factor of 0.14.
namespace scree::test::sand3d::sphere_impact_tests {
namespace {

struct Sphere : RigidBody {
  static constexpr std::string_view name = "sphere";
};
struct Impact : Formulation<3> {
  using physics = Granular<>;
  using bodies = Bodies<Material, Wall, Sphere>;
  using integrator = SymplecticEuler;
};

/// How deep (m) a sphere of a density (kg/m^3) and diameter (m) gets that falls from a height (m).
double depth(double density, double diameter, double height) {
  using namespace fields;
  double const dr = 2.5e-3, half = 0.075, bed = 0.1;  // m
  Ball<3> const ball{.centre = {0, 0, bed + diameter / 2 + dr / 2}, .radius = diameter / 2};
  Groups<3> spheres;
  spheres.add("sphere", fill_lattice(ball, dr));
  Rigid<3> sphere{.properties = mass_properties(ball, density, dr), .velocity = {0, 0, -std::sqrt(2 * g * height)}};
  SolverSettings<Impact> settings{.spacing = dr, .lost_share = 1};
  settings.physics.law = {.elastic = {.young = 2e6, .poisson = poisson, .rest_density = bed_density},
                          .grains = {.diameter = 0.3e-3}};
  settings.rigid.bodies = {sphere};
  Box<3> const vessel{{-half, -half, 0}, {half, half, bed}};
  auto const wall = kept(wall_around(vessel, dr, 4), [&](X const& x) { return x[2] < bed; });
  Solver<Impact> solver(settings, particles_of<Material>(fill_lattice(vessel, dr)), particles_of<Wall>(wall),
                        particles_of<Sphere>(spheres));
  Geostatic const at_rest{bed, bed_density, g, 0.75};
  solver.set(stress, [&](auto const& x) { return packed_stress<3>(at_rest, x); });
  double lowest = ball.centre[2];
  auto const look = [&](Solver<Impact>& now) {
    lowest = std::min(lowest, double(now.body<RigidStates>().to_host(rigid_centre)[0][2]));
  };
  solver.run(0.15, {every<Solver<Impact>>(1e-3, look)});
  show_packing(solver);
  return bed - (lowest - diameter / 2);
}

}  // namespace

TEST_CASE("a sphere sinks into sand as it was measured", "[.long]") {
  double const diameter = 25e-3, mu = friction_ratio(MuOfI<>().mu_s);
  std::vector<double> ways, depths, ratios, of_ratios;
  for (double const height : {0.05, 0.1, 0.2, 0.4}) {
    depths.push_back(depth(2 * bed_density, diameter, height));
    ways.push_back(height + depths.back());
    double const scale = std::sqrt(2.0) * std::pow(diameter, 2 / 3.0) * std::cbrt(ways.back()) / mu;
    WARN("from " << height << " m: " << depths.back() << " m deep, factor " << depths.back() / scale);
  }
  for (double const ratio : {1.0, 2.0, 4.0}) {
    double const found = depth(ratio * bed_density, diameter, 0.1);
    ratios.push_back(ratio);
    of_ratios.push_back(found / std::cbrt(0.1 + found));
    WARN("density ratio " << ratio << ": " << found << " m deep");
  }
  double const of_way = exponent(ways, depths), of_ratio = exponent(ratios, of_ratios);
  WARN("exponents: of the way " << of_way << ", of the density " << of_ratio);
  CHECK(std::abs(of_way - 1 / 3.0) < 0.1);
  CHECK(std::abs(of_ratio - 0.5) < 0.1);
}

}  // namespace scree::test::sand3d::sphere_impact_tests
