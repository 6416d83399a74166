// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/beside_cone.hpp>

#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/laws/by_group.hpp>
#include <scree/laws/drucker_prager.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace scree::test::beside_cone_tests {
namespace {

template <class Law, class Named = CircularCone>
struct With : GranularModels {
  using law = Law;
  using section = Named;
};
template <class Law, int Dim = 3, class Named = CircularCone>
struct Sand : Formulation<Dim> {
  using space = Kokkos::DefaultHostExecutionSpace;
  using physics = Granular<With<Law, Named>>;
  using integrator = SymplecticEuler;
};
/// MuOfI as a law of a user that takes no section.
struct OfUser : MuOfI<> {
  static constexpr bool takes_section = false;
};
/// A law that says that its strength is not that of a circular cone.
struct Pyramid : MuOfI<> {
  static constexpr bool circular = false;
};
double const rho = 1500, g = 9.81;

MuOfI<> grains(double friction, double sound_speed) {
  MuOfI<> law{.elastic = {.young = 0.74 * rho * sq(sound_speed), .poisson = 0.3, .rest_density = rho},
              .grains = {.diameter = 1e-3},
              .mu_s = friction};
  law.mu_d = friction + 0.3;
  return law;
}
/// What a run with these settings says of the state that it has come to.
template <class S>
std::string said(S const& solver) {
  auto const all = warnings_of_state(solver.settings().physics, solver.whole());
  return all.empty() ? "" : all.front();
}

/// sqrt(J2)/p in triaxial compression where I1 I2/I3 is that of plane shear at the ratio k, by bisection.
double strength_in_compression(double k) {
  double const wanted = (9 - 3 * k * k) / (1 - k * k);
  double low = 0, high = 0.86;
  for (int n = 0; n < 60; ++n) {
    double const t = (low + high) / 2, s1 = 1 + 2 * t / std::sqrt(3.0), s3 = 1 - t / std::sqrt(3.0);
    double const found = (s1 + 2 * s3) * (2 * s1 * s3 + s3 * s3) / (s1 * s3 * s3);
    (found < wanted ? low : high) = t;
  }
  return low;
}

/// A block that stands free on a rough floor, `time` in sqrt(H/g) after it was released.
template <class Law, class Named = CircularCone>
std::string collapsed(double friction, double time) {
  using Case = Sand<Law, 3, Named>;
  double const dr = 0.02, H = 8 * dr, side = 3 * dr;
  SolverSettings<Case> settings{.spacing = dr, .warn = {}};
  settings.physics.law = Law{grains(friction, 12 * std::sqrt(g * H))};
  settings.physics.cfl = 0.4;
  Solver<Case> solver(settings, fill_lattice(Box<3>{{-side, -side, 0}, {side, side, H}}, dr),
                      fill_lattice(Box<3>{{-2 * H, -2 * H, -3 * dr}, {2 * H, 2 * H, 0}}, dr));
  Geostatic const bed{H, rho, g, 1};
  solver.set(fields::stress, [&](auto const& x) { return packed<3>(Mat<3, double>(bed(x))); });
  solver.run(time * std::sqrt(H / g));
  return said(solver);
}

/// A layer that flows down a rough slope, periodic in both directions along it, from the exact flow.
std::string flowing(double friction) {
  using namespace fields;
  double const dr = 1e-3, H = 10 * dr, k = friction_ratio(friction + 0.1), angle = std::atan(k), d = 1e-3;
  SolverSettings<Sand<MuOfI<>>> settings{.spacing = dr, .periods = {{0, 0, 6 * dr}, {1, 0, 6 * dr}}, .warn = {}};
  MuOfI<> const law = settings.physics.law = grains(friction, 4);
  settings.physics.gravity = {g, angle};
  settings.physics.cfl = 0.4;
  Solver<Sand<MuOfI<>>> solver(settings, fill_lattice(Box<3>{{0, 0, 0}, {6 * dr, 6 * dr, H}}, dr),
                               fill_lattice(Box<3>{{0, 0, -3 * dr}, {6 * dr, 6 * dr, 0}}, dr));
  double const cosine = std::cos(angle), I = law.I0 * 0.1 / (law.mu_d - friction - 0.1);
  double const scale = 2.0 / 3 * I / d * std::sqrt(rho / law.grain_density * g * cosine);
  solver.set(stress, [&](auto const& x) {
    double const p = rho * g * cosine * (H - x[2]);
    Mat<3, double> sigma = -p * Mat<3, double>::Identity();
    sigma(0, 2) = sigma(2, 0) = k * p;
    return packed<3>(sigma);
  });
  solver.set(velocity,
             [&](auto const& x) { return Vec<3, double>(scale * (std::pow(H, 1.5) - std::pow(H - x[2], 1.5)), 0, 0); });
  solver.run(0.03);
  auto const found = beside_cone(law, solver.whole());
  CAPTURE(found.yielding, found.difference);
  CHECK(found.yielding > 0.8);
  CHECK(found.difference < 0.05);
  return said(solver);
}

}  // namespace

TEST_CASE("material beside the cone: loads are summed that yield, with the strength of Matsuoka and Nakai there") {
  for (double const friction : {0.25, 0.6}) {
    double const dr = 0.02, k = friction_ratio(friction);
    SolverSettings<Sand<MuOfI<>>> settings{.spacing = dr};
    settings.physics.law = grains(friction, 20);
    Solver<Sand<MuOfI<>>> solver(settings, fill_lattice(Box<3>{{0, 0, 0}, {6 * dr, 6 * dr, 6 * dr}}, dr), {});
    // Compressed along z at 0.97 of yield, in plane shear at yield, compressed at 0.9 of yield, and under tension.
    auto const state = [&](std::size_t n) {
      double const p = 100 + double(n % 7) * 10, t = (n % 4 == 0 ? 0.97 : 0.9) * k * p / std::sqrt(3.0);
      Mat<3, double> sigma = -p * Mat<3, double>::Identity();
      if (n % 4 == 1) sigma(0, 1) = sigma(1, 0) = k * p;
      if (n % 4 == 0 || n % 4 == 2) sigma.diagonal() += Vec<3, double>(t, t, -2 * t);
      return n % 4 == 3 ? Mat<3, double>(-sigma) : sigma;
    };
    std::size_t next = 0;
    solver.set(fields::stress, [&](auto const&) { return packed<3>(state(next++)); });
    double loads[4] = {};
    for (std::size_t n = 0; n < next; ++n) loads[n % 4] += std::abs(state(n).trace());
    double const all = loads[0] + loads[1] + loads[2], yielding = loads[0] + loads[1];
    auto const found = beside_cone(settings.physics.law, solver.whole());
    double const expected = (strength_in_compression(k) / k - 1) * loads[0] / yielding;
    CHECK(std::abs(found.yielding - yielding / all) < 1e-12);
    CHECK(std::abs(found.difference - expected) < 1e-9);
    CHECK(said(solver).empty() == !(expected > 0.1 && yielding > 0.1 * all));
  }
}

TEST_CASE("a run on the circular cone says so where a heap spreads to all sides, unless its friction is small") {
  using Catch::Matchers::ContainsSubstring;
  CHECK_THAT(collapsed<MuOfI<>>(0.6, 1.5), ContainsSubstring("section MatsuokaNakai"));
  CHECK_THAT(collapsed<VolumeMemory<MuOfI<>>>(0.6, 1.5), ContainsSubstring("section MatsuokaNakai"));
  CHECK(collapsed<MuOfI<>>(0.2, 1.5) == "");
  // By default sand has its own section; the law of a user keeps its cone.
  CHECK(collapsed<MuOfI<>, SectionByLaw>(0.6, 1.5) == "");
  CHECK_THAT((collapsed<OfUser, SectionByLaw>(0.6, 1.5)), ContainsSubstring("section MatsuokaNakai"));
}

TEST_CASE("flow in plane shear in space gives no warning about the cone, however large its friction") {
  CHECK(flowing(0.6) == "");
}

TEST_CASE("only laws on a circular cone without cohesion are looked at, and only in space") {
  STATIC_CHECK(detail::OnCircularCone<MuOfI<>>);
  STATIC_CHECK(detail::OnCircularCone<ByGroup<MuOfI<>>>);
  STATIC_CHECK(detail::OnCircularCone<VolumeMemory<MuOfI<>>>);
  STATIC_CHECK_FALSE(detail::OnCircularCone<Pyramid>);
  STATIC_CHECK_FALSE(detail::OnCircularCone<ByGroup<Pyramid>>);
  STATIC_CHECK_FALSE(detail::OnCircularCone<DruckerPrager>);
  SolverSettings<Sand<MuOfI<>, 2>> settings{.spacing = 0.02};
  settings.physics.law = grains(0.6, 20);
  Solver<Sand<MuOfI<>, 2>> solver(settings, fill_lattice(Box<2>{{0, 0}, {0.1, 0.1}}, 0.02), {});
  double const p = 100, t = 0.99 * friction_ratio(0.6) * p / std::sqrt(3.0);
  solver.set(fields::stress, [&](auto const&) { return Vec<4, double>(-p + t, -p - 2 * t, -p + t, 0); });
  CHECK(said(solver) == "");
}

}  // namespace scree::test::beside_cone_tests
