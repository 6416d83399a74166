// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <scree/boundaries/conserving.hpp>
#include <scree/boundaries/mirror_lens.hpp>
#include <scree/integrators/symplectic_euler.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>

// Level sand at rest in a box of few particles. It is so stiff that the artificial viscosity is a sixtieth of the speed
// of sound: it does not hide what walls do to the energy.
namespace scree::test::stiff_box_tests {
namespace {

template <class Scheme>
struct Models : GranularModels {
  using walls = Scheme;
};

struct Found {
  double early = 0, late = 0;  // rms speed around a half and at the end, m/s
  double way = 0;              // of the farthest particle, m
  Packing packing = {};        // at the end
};
template <class Scheme>
Found at_rest(double duration, bool smooth = false) {
  using namespace fields;
  using P = GranularCase<2, Granular<Models<Scheme>>, double, SymplecticEuler>;
  double const dr = 0.01;
  Box<2> const sand{{0, 0}, {0.1, 0.06}}, open{{0, 0}, {0.1, 0.09}}, outer{{-0.03, -0.03}, {0.13, 0.09}};
  SolverSettings<P> settings{.spacing = dr};
  settings.physics.law = {.elastic = {.young = 1e6, .poisson = 0.3, .rest_density = bed_density}, .grains = {1e-3}};
  Solver<P> solver(settings, fill_lattice(sand, dr), fill_between(open, outer, dr));
  Geostatic const bed{0.06, bed_density, g, 0.5};
  solver.set(stress, [&](auto const& x) { return packed_stress<2>(bed, Vec<2, double>(x)); });
  if (smooth)
    solver.template set<Wall>(slip_normal,
                              [](auto const& x) { return x[1] < 0 ? Vec<2, double>(0, 1) : Vec<2, double>(1, 0); });
  auto const start = solver.material().to_host(position);
  auto const fastest_rms = [&](double until) {
    double most = 0;
    for (double const from = solver.time(); solver.time() < until;) {
      solver.run(std::min(until, solver.time() + (until - from) / 10 + 1e-12));
      double sum = 0;
      for (auto const& u : solver.material().to_host(velocity)) sum += u.squaredNorm();
      most = std::max(most, std::sqrt(sum / double(start.size())));
    }
    return most;
  };
  solver.run(0.4 * duration);
  Found found{.early = fastest_rms(0.5 * duration)};
  solver.run(0.9 * duration);
  found.late = fastest_rms(duration);
  auto const x = solver.material().to_host(position);
  auto const number = solver.material().to_host(identity);
  for (std::size_t i = 0; i < x.size(); ++i)
    found.way = std::max(found.way, (x[i] - start[std::size_t(number[i])]).norm());
  found.packing = solver.packing();
  return found;
}

}  // namespace

TEMPLATE_TEST_CASE("stiff sand comes to rest in a box of few rows between walls that keep its energy", "", MirrorWalls,
                   ConservingWalls) {
  auto const [early, late, way, packing] = at_rest<TestType>(1);
  CAPTURE(early, late, way, packing.text());
  CHECK(late < early / 3);
  CHECK(late < 1e-4);
  CHECK(way < 1e-5);
  CHECK(is_packed_as_at_rest(packing));
}

TEST_CASE("stiff sand comes to rest between smooth walls that keep its energy") {
  auto const [early, late, way, packing] = at_rest<ConservingWalls>(1, true);
  CAPTURE(early, late, way, packing.text());
  CHECK(late < early / 3);
  CHECK(late < 1e-4);
  CHECK(way < 1e-5);
  CHECK(is_packed_as_at_rest(packing));
}

// Their mean velocities and mean stresses do not take and give the same power.
TEST_CASE("negative control: walls of mean velocities shake stiff sand in a box of few rows") {
  auto const [early, late, way, packing] = at_rest<AdamiWalls>(1);
  CAPTURE(early, late, way, packing.text());
  CHECK(late > 1e-3);
  CHECK(way > 1e-4);
}

}  // namespace scree::test::stiff_box_tests
