// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "element.hpp"
#include "hochstetten.hpp"

#include <scree/laws/drucker_prager.hpp>
#include <scree/laws/mu_of_i.hpp>
#include <scree/laws/tension_cutoff.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <limits>

namespace scree::test::tension_cutoff_tests {
namespace {

using Cut = TensionCutoff<DruckerPrager>;
static_assert(ConstitutiveLaw<Cut> && ConstitutiveLaw<TensionCutoff<Elastic>>);
// Without the cut-off, tension ends at p = -50 Pa.
Cut const law{{soft(), {.friction = 0.4, .cohesion = 20, .dilatancy = 0.1}}, 5};
double const K = soft().bulk_modulus(), G = soft().shear_modulus();

struct State {
  double p, tau;
};
// The result for a trial of pure shear and pressure.
template <class Law>
State end_of(Law const& any, State const& trial) {
  Mat<3, double> sigma = -trial.p * Mat<3, double>::Identity();
  sigma(0, 1) = sigma(1, 0) = trial.tau;
  auto const end = any.admissible(sigma, Point<>{}, NoHistory{});
  CHECK(std::abs(end(0, 1)) == std::abs(equivalent_shear_stress(deviator_of(end))));
  return {pressure_of(end), end(0, 1)};
}
void check_end(State const& trial, State const& expected) {
  State const end = end_of(law, trial);
  CAPTURE(trial.p, trial.tau, end.p, end.tau);
  CHECK(std::abs(end.p - expected.p) < 1e-12);
  CHECK(std::abs(end.tau - expected.tau) < 1e-12);
}

}  // namespace

TEST_CASE("tension cut-off: pressure is limited and the deviator kept within the yield surface") {
  check_end({-4, 10}, {-4, 10});      // admissible
  check_end({-30, 0}, {-5, 0});       // opens
  check_end({-30, 6}, {-5, 6});       // opens under shear within the strength at the cut-off and of the law alone
  check_end({-30, 15}, {-5, 15});     // ... not within that of the law alone
  check_end({-30, 40}, {-5, 18});     // ends in the corner, tau = 20 - 0.4 * 5
  check_end({-1e6, 40}, {-5, 18});    // ... from far beyond the tip of the cone
  check_end({-1e6, -40}, {-5, -18});  // ... with the sign of the shear
}

TEST_CASE("tension cut-off: where dilatancy alone brings the pressure up, the law is left alone") {
  State const trial{-6, 60}, alone = end_of(DruckerPrager(law), trial), cut = end_of(law, trial);
  CHECK(alone.p > -5);
  CHECK(cut.p == alone.p);
  CHECK(cut.tau == alone.tau);
  // In the corner neither multiplier is negative: volume opened = (p - p_trial)/K - k_psi (tau_trial - tau)/G.
  for (double const tau : {18.1, 25.0, 35.0, 45.0, 60.0}) {
    State const from{-10, tau}, to = end_of(law, from);
    double const opened = (to.p - from.p) / K - 0.1 * (from.tau - to.tau) / G;
    CAPTURE(tau, opened * K, to.p);
    CHECK(opened > -1e-17);
    CHECK(std::abs(to.tau - 0.4 * to.p - 20) < 1e-12);
  }
}

TEST_CASE("tension cut-off: it lands at once, and a cohesionless law is not changed") {
  State const corner = end_of(law, {-30, 40}), again = end_of(law, corner);
  CHECK(std::abs(again.p - corner.p) < 1e-14);
  CHECK(std::abs(again.tau - corner.tau) < 1e-13);
  TensionCutoff<MuOfI<>> const granular{{.elastic = soft(), .grains = {1e-3}}, 0};
  Point<> const moving{10, 0, 0};
  for (double const p : {-5.0, 0.0, 5.0}) {
    Mat<3, double> sigma = -p * Mat<3, double>::Identity();
    sigma(0, 1) = sigma(1, 0) = 4;
    CHECK(granular.admissible(sigma, moving, NoHistory{}) == granular.MuOfI<>::admissible(sigma, moving, NoHistory{}));
  }
}

TEST_CASE("tension cut-off: an elastic material keeps its deviator, and a NaN is not hidden") {
  TensionCutoff<Elastic> const glue{soft(), 2};
  State const end = end_of(glue, {-30, 6});
  CHECK(end.p == -2);
  CHECK(end.tau == 6);
  Mat<3, double> sigma = Mat<3, double>::Identity();
  sigma(0, 1) = sigma(1, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK(glue.admissible(sigma, Point<>{}, NoHistory{}).hasNaN());
  CHECK(law.admissible(sigma, Point<>{}, NoHistory{}).isZero(0));
}

TEST_CASE("tension cut-off: an element is torn apart at its tensile strength") {
  Element<Cut, 3> element{law};
  element.set_pressure(20);
  Mat<3, double> const apart = Mat<3, double>::Identity();
  element.shear_on(apart, 0.01, 500);
  CHECK(relative(element.p(), -5) < 1e-12);
  CHECK(element.tau() < 1e-12);
  element.shear_on(simple_shear<3>(1) + apart, 0.02, 500);
  CHECK(relative(element.p(), -5) < 1e-12);
  CHECK(relative(element.tau(), 18) < 1e-12);
  CHECK(relative(law.shear_strength(-5.0, element.point), 18) < 1e-14);
  CHECK(law.shear_strength(-5.1, element.point) == 0);
}

TEST_CASE("tension cut-off: the stiffness of the state and the rates of the history are those of the law inside") {
  struct Hardening : Hypoplastic {
    double shear_strength(double p, OfVoids const&) const { return p; }
  };
  using Limited = TensionCutoff<Hardening>;
  static_assert(StiffnessOfState<Limited> && EvolvesHistory<Limited> && !ConstantStiffness<Limited>);
  Limited const limited{{hochstetten()}};
  StressTensor<double> const sigma = Vec<3, double>(-1e4, -2e4, -1e4).asDiagonal(), L = compression(0.2);
  OfVoids const point{0.7};
  CHECK(limited.bulk_modulus(sigma, point) == limited.Hypoplastic::bulk_modulus(sigma, point));
  CHECK(limited.sound_speed(sigma, point) == limited.Hypoplastic::sound_speed(sigma, point));
  CHECK(limited.stress_rate(sigma, L, point) == limited.Hypoplastic::stress_rate(sigma, L, point));
  OfVoids rate;
  limited.history_rate(sigma, L, point, rate);
  CHECK(relative(rate.value, -1.7 * 0.6) < 1e-14);
  CHECK((limited.admissible(sigma, point, rate) - sigma).norm() < 1e-12 * sigma.norm());
}

}  // namespace scree::test::tension_cutoff_tests
