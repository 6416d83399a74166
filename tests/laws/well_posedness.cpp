// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "element.hpp"

#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/mu_of_i.hpp>
#include <scree/laws/rising_mu_of_i.hpp>
#include <scree/laws/well_posedness.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

// The condition of well-posedness against waves in a flow whose stress is that of the law, differentiated numerically.
namespace scree::test::well_posedness_tests {
namespace {

using Tensor = Mat<3, double>;
using Direction = Vec<3, double>;
constexpr double degree = std::numbers::pi / 180, infinite = std::numeric_limits<double>::infinity();

MuOfI<> beads(double mu_s, double mu_d, double I0) {
  return {.elastic = soft(), .grains = {5e-4}, .mu_s = mu_s, .mu_d = mu_d, .I0 = I0};
}
/// mu for which k_mu = k.
double mu_for(double k) { return 3 * k / std::sqrt(9 - 12 * k * k); }
/// The friction of a law taken as shear stress over pressure: mu in the place of k_mu, as the condition is printed.
template <class Law>
struct AsRatio {
  Law law;
  double grain_density = law.grain_density;
  double friction(double p, double gamma_dot, double d) const { return mu_for(law.friction(p, gamma_dot, d)); }
};
/// The slope of a uniform flow down an incline, degrees.
template <class Law>
double slope(Law const& law, double I) {
  return std::atan(friction_ratio_at(law, I)) / degree;
}

/// Simple shear of a law at an inertial number, u_x = gamma_dot y, and waves in it: velocity perturbations
/// exp(lambda t + i kappa n.x) with coefficients taken as constant, incompressible.
template <class Law>
struct ShearFlow {
  Law law;
  double p = 100, gamma_dot = 0;

  ShearFlow(Law const& of, double I) : law(of) {
    gamma_dot = I * std::sqrt(p / law.grain_density) / law.grains.diameter;
  }
  /// Stress in steady plastic flow, from the return mapping: the trial is far beyond yield, along the strain rate.
  Tensor stress(Tensor const& D, double pressure) const {
    double const shear_rate = std::sqrt(2 * squared_norm(D));
    Tensor const trial = 100 * pressure / shear_rate * D - pressure * Tensor::Identity();
    return law.admissible(trial, Point<>{.gamma_dot = shear_rate}, NoHistory{});
  }
  Tensor strain_rate() const {
    Tensor D = Tensor::Zero();
    D(0, 1) = D(1, 0) = gamma_dot / 2;
    return D;
  }
  /// Change of the stress by a change of the strain rate.
  Tensor change(Tensor const& by) const {
    double const step = 1e-6 * gamma_dot;
    return (stress(strain_rate() + step * by, p) - stress(strain_rate() - step * by, p)) / (2 * step);
  }
  Tensor change_by_pressure() const {
    double const step = 1e-6 * p;
    return (stress(strain_rate(), p + step) - stress(strain_rate(), p - step)) / (2 * step);
  }
  /// Largest growth rate (1/s) of waves along n, from the momentum balance: its component along n gives the pressure,
  /// the others the growth of both velocities across n.
  double growth(Direction const& n, double kappa) const {
    std::array<Direction, 2> e;
    e[0] = std::abs(n[2]) < 0.9 ? Direction(-n[1], n[0], 0) : Direction(0, -n[2], n[1]);
    e[0] /= e[0].norm();
    e[1] = cross(n, e[0]);
    Direction const by_pressure = change_by_pressure() * n;
    double M[2][2];
    for (int j = 0; j < 2; ++j) {
      Tensor const D = (n * e[j].transpose() + e[j] * n.transpose()) / 2;
      Direction const force = -kappa * kappa * (change(D) * n) - density() * gamma_dot * e[j][1] * Direction(1, 0, 0);
      double const pressure = -force.dot(n) / by_pressure.dot(n);  // times i kappa
      for (int i = 0; i < 2; ++i) M[i][j] = (force + pressure * by_pressure).dot(e[i]) / density();
    }
    double const mean = (M[0][0] + M[1][1]) / 2, squared = sq(M[0][0] - M[1][1]) / 4 + M[0][1] * M[1][0];
    return mean + (squared > 0 ? std::sqrt(squared) : 0);
  }
  /// The largest over directions that leave the plane by an angle (rad).
  double growth(double kappa, double out_of_plane) const {
    double largest = -infinite;
    for (int k = 0; k < 720; ++k) {
      double const t = std::numbers::pi * k / 720, c = std::cos(out_of_plane);
      largest = std::max(largest, growth({c * std::cos(t), c * std::sin(t), std::sin(out_of_plane)}, kappa));
    }
    return largest;
  }
  /// The wave number at which viscosity acts within 1e-3/gamma_dot.
  double short_waves() const {
    return std::sqrt(1e3 * density() * sq(gamma_dot) / (friction_ratio_at(law, inertial_number()) * p));
  }
  /// Whether waves grow the faster the shorter they are. The convection of the shear adds a growth of a few gamma_dot.
  bool is_unbounded() const {
    double const kappa = short_waves();
    return growth(10 * kappa, 0) > 10 * std::max(growth(kappa, 0), gamma_dot);
  }
  double inertial_number() const { return gamma_dot * law.grains.diameter / std::sqrt(p / law.grain_density); }
  double density() const { return law.density(); }
};

template <class Law>
bool is_unbounded(Law const& law, double I) {
  return ShearFlow<Law>(law, I).is_unbounded();
}
/// Whether a law is unbounded outside of its only band and bounded inside.
template <class Law>
void check_band(Law const& law) {
  auto const bands = well_posed_inertial_numbers(law);
  REQUIRE(bands.size() == 1);
  auto const [from, to] = bands[0];
  CAPTURE(from, to);
  CHECK(is_unbounded(law, from / 5));
  CHECK(is_unbounded(law, 0.95 * from));
  CHECK_FALSE(is_unbounded(law, 1.05 * from));
  CHECK_FALSE(is_unbounded(law, std::sqrt(from * to)));
  CHECK_FALSE(is_unbounded(law, 0.95 * to));
  CHECK(is_unbounded(law, 1.05 * to));
  CHECK(is_unbounded(law, 5 * to));
}

struct Row {
  MuOfI<> law;
  double from, to, lowest, highest;  // I, degrees
};
// Values of the table in docs/theory/laws.md.
std::vector<Row> const examples = {{beads(0.382, 0.682, 0.279), 0.01655, 0.8424, 19.91, 26.44},
                                   {beads(0.382, 0.6, 0.279), 0.02404, 0.8445, 19.93, 24.79},
                                   {beads(mu_for(0.382), mu_for(0.682), 0.279), 0.009957, 0.4836, 21.74, 31.35}};

}  // namespace

TEST_CASE("well-posedness: short waves are bounded within the band, and grow without bound outside of it") {
  for (Row const& row : examples) check_band(row.law);
  check_band(beads(0.342, 0.557, 0.069));
  check_band(beads(0.1, 0.9, 0.01));
}

TEST_CASE("well-posedness: waves out of the plane of the flow grow less than those in it") {
  for (double const I : {0.005, 2.0}) {
    ShearFlow const flow(beads(0.382, 0.682, 0.279), I);
    double before = flow.growth(flow.short_waves(), 0);
    for (double const angle : {20.0, 40.0, 60.0, 80.0}) {
      double const now = flow.growth(flow.short_waves(), angle * degree);
      CAPTURE(I, angle, before, now);
      CHECK(now < before);
      before = now;
    }
  }
}

TEST_CASE("well-posedness: C follows from the derivative of mu in closed form") {
  auto const law = beads(0.382, 0.682, 0.279);
  for (double const I : {1e-4, 1e-2, 0.1, 1.0, 100.0}) {
    double const mu = (law.mu_s * law.I0 + law.mu_d * I) / (law.I0 + I), k = friction_ratio(mu);
    double const slope_of_mu = (law.mu_d - law.mu_s) * law.I0 / sq(law.I0 + I);
    double const r = (1 - 4 * k * k / 3) * I * slope_of_mu / mu;
    CAPTURE(I);
    CHECK(relative(friction_ratio_at(law, I), k) < 1e-14);
    CHECK(std::abs(ill_posedness(law, I) - (sq(k * (1 - r / 2)) - 4 * r * (1 - r))) < 1e-9);
  }
}

TEST_CASE("well-posedness: bands of the parameters of the examples") {
  for (Row const& row : examples) {
    auto const bands = well_posed_inertial_numbers(row.law);
    REQUIRE(bands.size() == 1);
    auto const [from, to] = bands[0];
    CAPTURE(from, to, slope(row.law, from), slope(row.law, to));
    CHECK(relative(from, row.from) < 1e-3);
    CHECK(relative(to, row.to) < 1e-3);
    CHECK(std::abs(slope(row.law, from) - row.lowest) < 0.01);
    CHECK(std::abs(slope(row.law, to) - row.highest) < 0.01);
    CHECK(std::abs(ill_posedness(row.law, from)) < 1e-9);
    CHECK(std::abs(ill_posedness(row.law, to)) < 1e-9);
  }
}

TEST_CASE("well-posedness: with mu in the place of k_mu, the bands are those of the printed condition") {
  // The parameters of Jop et al. (2006), and those of Barker & Gray (2017).
  AsRatio<MuOfI<>> const glass{beads(0.382, 0.6438, 0.279)};
  auto const of_glass = well_posed_inertial_numbers(glass);
  REQUIRE(of_glass.size() == 1);
  CHECK(std::abs(slope(glass, of_glass[0].from) - 21.75) < 0.01);
  CHECK(std::abs(slope(glass, of_glass[0].to) - 30.08) < 0.01);
  auto const others = well_posed_inertial_numbers(AsRatio<MuOfI<>>{beads(0.342, 0.557, 0.069)});
  REQUIRE(others.size() == 1);
  CHECK(relative(others[0].from, 0.00397) < 1e-3);
  CHECK(relative(others[0].to, 0.2802) < 1e-3);
}

TEST_CASE("well-posedness: with mu_inf the band goes on to a larger I, and a small mu_inf gives a second one") {
  struct Case {
    double mu_inf, from, to, highest;
  };
  for (Case const& each : {Case{0.05, 0.01644, 16.52, 36.82}, Case{0.1, 0.01633, 8.734, 36.96}}) {
    RisingMuOfI<> const law{beads(0.382, 0.682, 0.279), each.mu_inf};
    check_band(law);
    auto const bands = well_posed_inertial_numbers(law);
    CAPTURE(each.mu_inf, bands[0].from, bands[0].to, slope(law, bands[0].to));
    CHECK(relative(bands[0].from, each.from) < 1e-3);
    CHECK(relative(bands[0].to, each.to) < 1e-3);
    CHECK(std::abs(slope(law, bands[0].to) - each.highest) < 0.01);
  }
  RisingMuOfI<> const barely{beads(0.382, 0.682, 0.279), 0.01};
  auto const found = well_posed_inertial_numbers(barely);
  REQUIRE(found.size() == 2);
  for (auto const& [from, to] : found) {
    CAPTURE(from, to);
    CHECK_FALSE(is_unbounded(barely, 1.05 * from));
    CHECK_FALSE(is_unbounded(barely, 0.95 * to));
    CHECK(is_unbounded(barely, 0.95 * from));
    CHECK(is_unbounded(barely, 1.05 * to));
  }
  CHECK(found[0].to < found[1].from);
}

TEST_CASE("well-posedness: a friction that rises too little has no band, one that starts at zero has no lower end") {
  CHECK(well_posed_inertial_numbers(beads(0.382, 0.382, 0.279)).empty());
  CHECK(well_posed_inertial_numbers(beads(0.6, 0.682, 0.279)).empty());
  for (double const I : {0.01, 0.3, 10.0}) CHECK(is_unbounded(beads(0.6, 0.682, 0.279), I));
  auto const without_yield = beads(0, 0.682, 0.279);
  auto const found = well_posed_inertial_numbers(without_yield);
  REQUIRE(found.size() == 1);
  CHECK(found[0].from == 0);
  CHECK_FALSE(is_unbounded(without_yield, 1e-3));
  CHECK(is_unbounded(without_yield, 1.05 * found[0].to));

  CHECK(is_never_well_posed(beads(0.6, 0.682, 0.279)));
  CHECK_FALSE(is_never_well_posed(without_yield));
  CHECK_FALSE(is_never_well_posed(beads(0, 0, 0.279)));
  CHECK_FALSE(is_never_well_posed(DruckerPrager{}));
  CHECK(is_never_well_posed(VolumeMemory<MuOfI<>>{beads(0.6, 0.682, 0.279)}));
}

}  // namespace scree::test::well_posedness_tests
