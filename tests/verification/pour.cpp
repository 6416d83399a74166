// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "granular.hpp"

#include <scree/integrators/symplectic_euler.hpp>
#include <scree/openings/inlet.hpp>
#include <scree/setup/setup.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Sand rains into a closed box and makes a bed as deep as its volume. Figures: docs/theory/verification.md.
namespace scree::test::pour_tests {
namespace {

using X = Vec<2, double>;
double const width = 0.06, poured_depth = 0.04, inlet_height = 0.12;  // m

struct Way {
  double speed = 0.3;             ///< of the grains that enter, m/s
  int half_width = 4;             ///< of the inlet, spacings
  double young = 3e5, dr = 3e-3;  ///< Pa, m
};
/// The bed 1.5 s after the last grain entered.
struct Bed {
  double depth = 0;     ///< twice the mean height, over the volume over the width
  double packing = 0;   ///< number density over that of the lattice in the lower half: median,
  double loose = 0;     ///< and 5 % quantile
  double pressure = 0;  ///< the largest one over that of the weight on the floor
  double speed = 0;     ///< the largest one, m/s
  std::string warning;  ///< of the run
};
template <class Vector>
std::vector<X> in_double(std::vector<Vector> const& values) {
  std::vector<X> all;
  for (Vector const& value : values) all.push_back(value.template cast<double>());
  return all;
}
template <class Models, class Real, class Integrator>
struct Pouring : Formulation<2, Real> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<Models>;
  using integrator = Integrator;
};

template <class Models, class Real = double, class Integrator = SymplecticEuler>
Bed poured(Way const& way) {
  using Case = Pouring<Models, Real, Integrator>;
  using namespace fields;
  double const dr = way.dr, half = dr * way.half_width, pouring = poured_depth * width / (2 * half * way.speed);
  Granular<Models> physics;
  MuOfI<> const sand{.elastic = {.young = way.young, .poisson = poisson, .rest_density = bed_density},
                     .grains = {.diameter = 1e-3}};
  physics.law = sand;
  physics.cfl = std::is_same_v<Integrator, Midpoint> ? 0.2 : 0.4;
  Bed bed;
  auto const warn = [&](std::string const& text) { bed.warning += text; };
  Solver<Case> solver({.spacing = dr, .physics = physics, .warn = warn}, std::vector<Vec<2, Real>>{},
                      cast<Real>(wall_around(Box<2>{{-width / 2, 0}, {width / 2, 0.2}}, dr, 3)));
  solver.feed(Inlet<2>{.layer = fill_lattice(Box<2>{{-half, inlet_height}, {half, inlet_height + dr}}, dr),
                       .velocity = {0, -way.speed},
                       .pushes = false,
                       .duration = pouring});
  solver.run(pouring + 1.5);
  auto const x = in_double(solver.material().to_host(position)), u = in_double(solver.material().to_host(velocity));
  auto const sigma = solver.material().to_host(stress);
  double const count = double(x.size()), depth = count * sq(dr) / width;
  KernelFunction<WendlandC2, 2, double> const W(solver.resolution().smoothing_length);
  auto const walls = in_double(solver.wall().to_host(position));
  std::vector<double> packing;
  for (std::size_t i = 0; i < x.size(); ++i) {
    bed.depth += 2 * x[i][1] / (count * depth);
    bed.pressure =
        std::max(bed.pressure, -double(sigma[i][0] + sigma[i][1] + sigma[i][2]) / (3 * bed_density * g * depth));
    bed.speed = std::max(bed.speed, u[i].norm());
    if (x[i][1] > depth / 2) continue;
    double sum = 0;
    for (auto const* const all : {&x, &walls})
      for (X const& other : *all)
        if (double const r = (x[i] - other).norm(); r < W.radius()) sum += sq(dr) * W.value(r);
    packing.push_back(sum / solver.resolution().lattice_sum);
  }
  std::sort(packing.begin(), packing.end());
  if (!packing.empty()) bed.packing = packing[packing.size() / 2], bed.loose = packing[packing.size() / 20];
  UNSCOPED_INFO("depth " << bed.depth << ", packing " << bed.packing << " (5 % " << bed.loose << "), pressure "
                         << bed.pressure << ", fastest " << bed.speed << " m/s");
  return bed;
}

struct Uncontrolled : GranularModels {
  using volume_control = NoVolumeControl;
};

/// The bars that a bed misses, or "".
std::string faults(Bed const& bed) {
  std::string found;
  if (!(std::abs(bed.depth - 1) < 0.03)) found += "depth ";
  if (!(std::abs(bed.packing - 1) < 0.03)) found += "packing ";
  if (!(bed.pressure < 2)) found += "pressure ";
  if (!(bed.speed < 0.02)) found += "speed ";
  found += bed.warning;
  return found;
}

}  // namespace

TEST_CASE("sand that rains makes a bed as deep and as dense as its volume") {
  CHECK(faults(poured<GranularModels>({})) == "");
  CHECK(faults(poured<GranularModels>({.speed = 3, .half_width = 10})) == "");
}
TEST_CASE("sand that rains makes the same bed in single precision and with the midpoint scheme", "[.long]") {
  for (Way const& way : {Way{}, Way{.speed = 3, .half_width = 10}}) {
    CHECK(faults(poured<GranularModels, float>(way)) == "");
    CHECK(faults(poured<GranularModels, double, Midpoint>(way)) == "");
  }
}
TEST_CASE("sand that rains in any of six ways makes a bed as deep and as dense as its volume", "[.long]") {
  for (Way const& way : {Way{}, Way{.young = 3e6}, Way{.dr = 2e-3}, Way{.speed = 1, .half_width = 10},
                         Way{.speed = 3, .half_width = 10}, Way{.speed = 0.5, .half_width = 2}})
    CHECK(faults(poured<GranularModels>(way)) == "");
}
// A pressure that is not tied to the packing keeps what the impacts left.
TEST_CASE("without volume control sand that rains makes a bed that is too deep, and the run says so") {
  auto const bed = poured<Uncontrolled>({});
  CHECK(faults(bed).starts_with("depth packing pressure"));
  CHECK_THAT(bed.warning, Catch::Matchers::ContainsSubstring("grains under pressure are packed 0.") &&
                              Catch::Matchers::ContainsSubstring("`FlowConsistency`"));
}

}  // namespace scree::test::pour_tests
