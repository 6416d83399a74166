// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "sand3d.hpp"

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

// A silo with a round hole in its floor. The discharge grows as the diameter of the hole to the power 5/2 and does not
// depend on the height of the fill (Beverloo, Leniger & van de Velde 1961).
namespace scree::test::sand3d::silo_discharge_3d_tests {
namespace {

struct Silo {
  double hole, height, friction = MuOfI<>().mu_s;  // m, m, -
  double width = 0.15, dr = 0.15 / 64;             // m
  double begin = 0.1, end = 0.25;                  // of the measurement, s
};

/// The volume (m^3) that falls through the hole in a second.
double discharge(Silo const& now) {
  using namespace fields;
  double const half = now.width / 2, dr = now.dr;
  auto const wall =
      kept(wall_around(Box<3>{{-half, -half, 0}, {half, half, 1.2 * now.height}}, dr, 4),
           [&](X const& x) { return x[2] < 1.2 * now.height && (x[2] > 0 || std::hypot(x[0], x[1]) > now.hole / 2); });
  SolverSettings<Sand> settings{.spacing = dr, .lost_share = 1};
  settings.physics.law = {.elastic = {.young = 1.5e5, .poisson = poisson, .rest_density = bed_density},
                          .grains = {.diameter = 1e-3}};
  auto& law = settings.physics.law;
  law.mu_d = now.friction * law.mu_d / law.mu_s, law.mu_s = now.friction;
  Solver<Sand> solver(settings, fill_lattice(Box<3>{{-half, -half, 0}, {half, half, now.height}}, dr), wall);
  Geostatic const at_rest{now.height, bed_density, g, 0.75};
  solver.set(stress, [&](auto const& x) { return packed_stress<3>(at_rest, x); });
  solver.drain({}, Beyond<3>{{0, 0, -8 * dr}, {0, 0, -1}});
  auto const passed = [&] {  // what is below the floor or has left
    double sum = solver.left()[0].volume;
    auto const volumes = solver.material().to_host(volume);
    auto const places = solver.material().to_host(position);
    for (std::size_t k = 0; k < places.size(); ++k)
      if (places[k][2] < 0) sum += volumes[k];
    return sum;
  };
  solver.run(now.begin);
  double const before = passed();
  solver.run(now.end);
  show_packing(solver);
  return (passed() - before) / (now.end - now.begin);
}

}  // namespace

TEST_CASE("a silo in 3D discharges as the hole to the power 5/2", "[.long]") {
  std::vector<double> holes, rates;
  for (double const spacings : {14.0, 17.0, 20.0, 24.0, 28.0}) {
    Silo const now{.hole = spacings * 0.15 / 64, .height = 0.13};
    holes.push_back(now.hole - now.dr);  // a ring of half a spacing along the edge does not flow
    rates.push_back(discharge(now));
    WARN(spacings << " spacings: coefficient " << rates.back() / (std::sqrt(g) * std::pow(holes.back(), 2.5)));
  }
  double const power = exponent(holes, rates);
  WARN("exponent " << power);
  CHECK(std::abs(power - 2.5) < 0.1);
}

TEST_CASE("the discharge of a silo in 3D does not depend on the fill height", "[.long]") {
  double const hole = 20 * 0.15 / 64, low = discharge({.hole = hole, .height = 0.12});
  for (double const height : {0.16, 0.20}) {
    double const ratio = discharge({.hole = hole, .height = height}) / low;
    WARN("height " << height << " m: " << ratio);
    CHECK(std::abs(ratio - 1) < 0.03);
  }
  double const slippery = 0.02;
  double const ratio = discharge({.hole = hole, .height = 0.20, .friction = slippery}) /
                       discharge({.hole = hole, .height = 0.12, .friction = slippery});
  WARN("almost without friction: " << ratio);
  CHECK(ratio > 1.1);
}

}  // namespace scree::test::sand3d::silo_discharge_3d_tests
