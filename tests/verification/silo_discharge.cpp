// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <scree/fields/groups.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/openings/regions.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <vector>

// A silo with a slot in its floor. The discharge does not depend on the height of the fill and grows as the width of
// the slot to the power 3/2 (Beverloo, Leniger & van de Velde 1961, for a slot in the plane).
namespace scree::test::silo::silo_discharge_tests {
namespace {

struct Discharge : Formulation<2> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<>;
  using integrator = SymplecticEuler;
};
using S = Solver<Discharge>;

double const width = 0.15;  // m

struct Case {
  double slot, height = 1.2 * width, dr = width / 50;  // m
  MuOfI<> sand = {.elastic = {.young = 1.5e5, .poisson = poisson, .rest_density = bed_density},
                  .grains = {.diameter = 1e-3}};
  double begin = 0.1, end = 0.25;  // of the measurement, s
};

/// The mass (kg per m and s) that falls through the slot.
double discharge(Case const& now) {
  using namespace fields;
  auto const [slot, height, dr, sand, begin, end] = now;
  double const left = (width - slot) / 2, right = left + slot, thick = 4 * dr;
  std::vector<Vec<2, double>> walls;
  for (auto const& box :
       {Box<2>{{-thick, -thick}, {left, 0}}, Box<2>{{right, -thick}, {width + thick, 0}},
        Box<2>{{-thick, 0}, {0, height + thick}}, Box<2>{{width, 0}, {width + thick, height + thick}}})
    for (auto const& x : fill_lattice(box, dr)) walls.push_back(x);
  SolverSettings<Discharge> settings{.spacing = dr, .lost_share = 1};
  settings.physics.law = sand;
  settings.physics.cfl = 0.6;
  S solver(settings, fill_lattice(Box<2>{{0, 0}, {width, height}}, dr), walls);
  Geostatic const at_rest{height, bed_density, g, 0.75};
  solver.set(stress, [&](auto const& x) { return packed_stress<2>(at_rest, x); });
  auto const remove_below = [fallen = Beyond<2>{{0, -8 * dr}, {0, -1}}](S& s) { s.remove(fallen); };
  solver.run(begin, {every<S>(0.01, remove_below)});
  auto const passed = [&solver, cell = dr * dr] {  // the mass below the floor or removed
    double volume_below = double(solver.turnover().removed) * cell;
    for (auto const& x : solver.material().to_host(position))
      if (x[1] < 0) volume_below += cell;
    return bed_density * volume_below;
  };
  double const before = passed();
  solver.run(end, {every<S>(0.01, remove_below)});
  show_packing(solver);
  return (passed() - before) / (end - begin);
}
/// The discharge in rho sqrt(g) D^(3/2). Material sticks to the edges of the slot, as to all walls, so that the part of
/// it that flows, D, is one spacing narrower.
double coefficient(Case const& now, double rate) {
  return rate / (bed_density * std::sqrt(g) * std::pow(now.slot - now.dr, 1.5));
}

/// The exponent of a power law through points, by least squares of the logarithms.
double exponent(std::vector<double> const& x, std::vector<double> const& y) {
  double n = double(x.size()), a = 0, b = 0, aa = 0, ab = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    double const u = std::log(x[k]), v = std::log(y[k]);
    a += u, b += v, aa += u * u, ab += u * v;
  }
  return (n * ab - a * b) / (n * aa - a * a);
}

}  // namespace

TEST_CASE("a silo discharges as the slot to the power 3/2", "[verification]") {
  Case const narrow{.slot = 0.030}, wide{.slot = 0.048};
  double const slow = discharge(narrow), fast = discharge(wide);
  double const power = std::log(fast / slow) / std::log((wide.slot - wide.dr) / (narrow.slot - narrow.dr));
  CAPTURE(coefficient(narrow, slow), coefficient(wide, fast), power);
  CHECK(std::abs(power - 1.5) < 0.1);
}

TEST_CASE("the discharge does not depend on the fill height", "[verification]") {
  Case const low{.slot = 0.036, .height = width}, high{.slot = 0.036, .height = 1.6 * width};
  double const ratio = discharge(high) / discharge(low);
  CAPTURE(ratio);
  CHECK(std::abs(ratio - 1) < 0.03);
}

TEST_CASE("control: almost without friction the discharge grows with the fill height", "[verification]") {
  Case low{.slot = 0.036, .height = width, .begin = 0.05, .end = 0.15};
  low.sand.mu_s = low.sand.mu_d = 0.02;
  Case high = low;
  high.height = 1.6 * width;
  double const ratio = discharge(high) / discharge(low);
  CAPTURE(ratio);
  CHECK(ratio > 1.1);
}

TEST_CASE("five slots of 20 to 40 spacings and three fill heights", "[.long]") {
  double const fine = width / 100;
  std::vector<double> slots, rates;
  for (double const spacings : {20.0, 25.0, 30.0, 35.0, 40.0}) {
    Case const now{.slot = spacings * fine, .dr = fine};
    slots.push_back(now.slot), rates.push_back(discharge(now));
    WARN(spacings << " spacings: coefficient " << coefficient(now, rates.back()));
  }
  double const power = exponent(slots, rates);  // of the whole slot
  WARN("exponent " << power);
  CHECK(std::abs(power - 1.5) < 0.1);
  double const low = discharge({.slot = 0.036, .height = width, .dr = fine});
  for (double const height : {1.3, 1.6}) {
    double const ratio = discharge({.slot = 0.036, .height = height * width, .dr = fine}) / low;
    WARN("height " << height << " widths: " << ratio);
    CHECK(std::abs(ratio - 1) < 0.03);
  }
}

}  // namespace scree::test::silo::silo_discharge_tests
