// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/segregation/conservative.hpp>
#include <scree/segregation/constant_closure.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <random>

namespace scree::test::conservative_tests {
using namespace fields;
namespace {

using Physics = ConservativeSegregation<ConstantClosure>;

template <int Dim>
Vec<Dim, double> small_box() {
  Vec<Dim, double> size = Vec<Dim, double>::Constant(0.6);
  size[Dim - 1] = 1;
  return size;
}

/// The concentration with a given potential, by bisection.
double concentration_at(SegregationFlux const& flux, double potential) {
  double low = 0, high = 1;
  for (int step = 0; step < 80; ++step) {
    double const middle = (low + high) / 2;
    (flux.potential(middle) < potential ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Numbers in [0, 1], two fifths of them at the ends.
std::vector<double> random_concentrations(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) {
    double const number = std::ldexp(double(random() >> 11), -53);
    values.push_back(std::clamp(1.7 * number - 0.35, 0.0, 1.0));
  }
  return values;
}

template <class S>
void set_concentrations(S& solver, std::vector<double> const& values) {
  std::size_t next = 0;
  set_field(solver, concentration, [&](auto const&) { return values[next++]; });
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the conservative scheme creates and destroys nothing", "", Policies) {
  using P = TestType;
  using F = Formulated<P, Physics>;
  auto bed = open_bed<P::dim>(small_box<P::dim>(), 0.1);
  jitter(bed.material, 0.02, 3);
  for (auto const& flux : {SegregationFlux::symmetric(), SegregationFlux::asymmetric()}) {
    auto solver = solver_of<F>(bed, 0.1, {{.velocity = 2, .diffusivity = 0.03}, flux});
    set_concentrations(solver, random_concentrations(bed.material.size(), 5));
    auto const rates = rates_of(solver);
    double magnitude = 0;
    for (double const rate : rates) magnitude += std::abs(rate);
    // All volumes are equal. Each pair cancels to the last digit; only the rounding of about 30 terms per sum remains,
    // of either sign.
    CHECK(magnitude > 1);
    CHECK(std::abs(sum_of(rates)) < ulps<P>(16) * magnitude);
  }
}

TEMPLATE_LIST_TEST_CASE("a pair in equilibrium exchanges nothing, beside walls and in corners too", "",
                        DoublePolicies) {
  using P = TestType;
  using F = Formulated<P, Physics>;
  constexpr int z = P::dim - 1;
  // Pe = V H/D = 5: one over two spacings (the weights vanish at three) keeps differences of the potential below 2.3/2,
  // so that neither the donor bound of the flux nor rounding interferes.
  double const V = 0.1, D = 0.02;
  auto bed = open_bed<P::dim>(small_box<P::dim>(), 0.1);
  for (double const disorder : {0.0, 0.02}) {
    jitter(bed.material, disorder, 8);
    for (auto const& flux : {SegregationFlux::symmetric(), SegregationFlux::asymmetric()}) {
      auto solver = solver_of<F>(bed, 0.1, {{.velocity = V, .diffusivity = D}, flux});
      // D dC/dz = -V F: theta falls with height by V/D.
      set_field(solver, concentration,
                [&](auto const& x) { return concentration_at(flux, flux.potential(0.5) - V / D * (x[z] - 0.5)); });
      // Relative to the scale of either part alone, D/dr^2 times a difference of one tenth. Errors: of theta (about 5)
      // in units in the last place, some 30 pairs.
      double const scale = D / sq(0.1) * 0.1;
      CHECK(largest_of(rates_of(solver)) < ulps<P>(2000) * scale);

      // Upside down it is no equilibrium: both parts add.
      set_field(solver, concentration,
                [&](auto const& x) { return concentration_at(flux, flux.potential(0.5) + V / D * (x[z] - 0.5)); });
      CHECK(largest_of(rates_of(solver)) > 0.5 * scale);
    }
  }
}

TEST_CASE("the symmetric equilibrium is the logistic profile") {
  // theta = log(C/(1 - C)) for F = C (1 - C), so C = 1/(1 + exp(Pe (z/H - 1/2))).
  for (double const s : {-7.0, -1.0, 0.0, 0.3, 4.0})
    CHECK(std::abs(concentration_at(SegregationFlux::symmetric(), -s) - 1 / (1 + std::exp(s))) < 1e-14);
}

TEMPLATE_LIST_TEST_CASE("nothing happens where all grains are of one size", "", Policies) {
  using P = TestType;
  auto bed = open_bed<P::dim>(small_box<P::dim>(), 0.1);
  jitter(bed.material, 0.02, 3);
  auto solver = solver_of<Formulated<P, Physics>>(bed, 0.1, {{.velocity = 2, .diffusivity = 0.03}, {}});
  for (double const C : {0.0, 1.0}) {
    set_field(solver, concentration, [&](auto const&) { return C; });
    CHECK(largest_of(rates_of(solver)) == 0);
  }
}

TEMPLATE_LIST_TEST_CASE("concentrations stay within [0, 1] at a large cell Peclet number", "", DoublePolicies) {
  using P = TestType;
  double const dr = P::dim == 2 ? 0.05 : 0.1, V = 1, D = V * dr / 20;
  Vec<P::dim, double> size = Vec<P::dim, double>::Constant(4 * dr);
  size[P::dim - 1] = 1;
  auto bed = open_bed<P::dim>(size, dr);
  for (double const disorder : {0.0, 0.1}) {
    jitter(bed.material, disorder * dr, 4);
    for (auto const& flux : {SegregationFlux::symmetric(), SegregationFlux::asymmetric()}) {
      auto solver = solver_of<Formulated<P, Physics>>(bed, dr, {{.velocity = V, .diffusivity = D}, flux});
      set_field(solver, concentration, [](auto const& x) { return x[P::dim - 1] > 0.5 ? 1 : 0; });
      double const before = sum_of(concentrations_of(solver));
      // Grains segregate within a few H/V.
      double worst = 0;
      for (int k = 0; k < (P::dim == 2 ? 800 : 300); ++k) {
        solver.step(1);
        worst = std::max(worst, outside_of_range(concentrations_of(solver)));
      }
      auto const C = concentrations_of(solver);
      INFO("after " << solver.time() << " s");
      CHECK(worst == 0);
      CHECK(std::abs(sum_of(C) - before) < 1e-13 * before);
      CHECK(C.front() > 0.5);  // small grains have reached the bottom
      CHECK(C.back() < 0.5);
    }
  }
}

TEMPLATE_LIST_TEST_CASE("small grains above large ones start to fall without diffusion, sorted ones rest", "",
                        Policies) {
  using P = TestType;
  [[maybe_unused]] constexpr int z = P::dim - 1;  // GCC 12 does not see that a lambda uses it
  auto const bed = open_bed<P::dim>(small_box<P::dim>(), 0.1);
  auto solver = solver_of<Formulated<P, Physics>>(bed, 0.1, {{.velocity = 1, .diffusivity = 0}, {}});
  set_field(solver, concentration, [](auto const& x) { return x[z] > 0.5 ? 1 : 0; });
  CHECK(largest_of(rates_of(solver)) > 1);  // F = 1/4 through the interface, over a spacing of 0.1
  set_field(solver, concentration, [](auto const& x) { return x[z] < 0.5 ? 1 : 0; });
  CHECK(largest_of(rates_of(solver)) == 0);
}

TEMPLATE_LIST_TEST_CASE("the conservative scheme is of second order inside", "", DoublePolicies) {
  using P = TestType;
  constexpr int z = P::dim - 1;
  double const V = 0.3, D = 0.1;
  auto const flux = SegregationFlux::asymmetric();
  auto const error = [&](double spacing) {
    Bed<P::dim> const bed{lattice<P::dim>(spacing), {}};
    auto solver = solver_of<Formulated<P, Physics>>(bed, spacing, {{.velocity = V, .diffusivity = D}, flux});
    set_field(solver, concentration, [&](auto const& x) { return 0.5 + 0.3 * std::sin(2 * x[0] - x[z]); });
    auto const rates = rates_of(solver);
    double largest = 0;
    for (std::size_t i = 0; i < rates.size(); ++i) {
      auto const& x = bed.material[i];
      if (!deep_inside<P::dim>(x, 0.36)) continue;
      double const phase = 2 * x[0] - x[z], C = 0.5 + 0.3 * std::sin(phase);
      // dC/dt = -ghat . grad(V F) + D lap C with ghat = -e_z.
      double const exact = V * flux.slope(C) * -0.3 * std::cos(phase) - D * 5 * 0.3 * std::sin(phase);
      largest = std::max(largest, std::abs(rates[i] - exact));
    }
    return largest;
  };
  double const coarse = error(1.0 / 16), fine = error(1.0 / 32), order = std::log2(coarse / fine);
  INFO("errors " << coarse << " and " << fine << ", order " << order);
  CHECK(order > 1.8);
  CHECK(fine < 0.01);
}

TEMPLATE_LIST_TEST_CASE("grains that stand apart exchange nothing and stay finite", "", Policies) {
  using P = TestType;
  Points<P::dim> points(3, Vec<P::dim, double>::Zero());
  points[1][0] = 10;
  points[2][0] = 10.05;  // half a spacing from the second
  auto solver = solver_of<Formulated<P, Physics>>({points, {}}, 0.1, {{.velocity = 2, .diffusivity = 0.03}, {}});
  set_field(solver, concentration, [](auto const& x) { return x[0] > 10.02 ? 0.9 : 0.2; });
  auto const rates = rates_of(solver);
  CHECK(rates[0] == 0);
  CHECK(rates[1] > 0);
  CHECK(rates[2] == -rates[1]);
  CHECK(std::isfinite(rates[1]));
}

}  // namespace scree::test::conservative_tests
