// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/segregation/constant_closure.hpp>
#include <scree/segregation/hybrid.hpp>

#include <support/formulations.hpp>
#include <support/lattice_sums.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

namespace scree::test::hybrid_tests {
using namespace fields;
namespace {

using Physics = HybridSegregation<ConstantClosure>;

// Q = V F is the flux through a layer of uniform C inside; M, close to one, its factor from the kernel on a lattice.
double const V = 0.3;
template <int Dim>
double moment() {
  return -LatticeSums<Dim>(1.5).moment;
}

// With uniform C all gradients vanish and only the sources remain: 2 Q ghat . sum V gradW over the missing material,
// which is -2 Q ghat . sum over the material that is there. Within the lower half of the bed pairs of material cancel,
// so it gathers the contribution of pairs across the middle, -2 Q ghat . sum_{i below} sum_{j above} V_i V_j gradW. For
// a layer without side walls that is Q M per area: a vertical distance m occurs between m pairs of rows, and sum_{m >
// 0} 2 Q m dr V dW/dz(m) = Q sum_{all} z V dW/dz = -Q M. Next to a side wall it is less, because pairs are missing.
template <int Dim>
double across_middle(Points<Dim> const& material, double spacing, double middle) {
  KernelFunction<WendlandC2, Dim, double> const W(1.5 * spacing);
  double sum = 0;
  for (auto const& below : material)
    for (auto const& above : material) {
      if (below[Dim - 1] > middle || above[Dim - 1] < middle) continue;
      double const r = (below - above).norm();
      if (r < W.radius()) sum += 2 * (below[Dim - 1] - above[Dim - 1]) * W.slope_over_distance(r);
    }
  return sum * sq(std::pow(spacing, Dim));
}
template <class S>
void check_sources(S& solver, double middle, double expected) {
  constexpr int dim = S::policy::dim;
  double const one_volume = std::pow(solver.settings().spacing, dim);
  auto const rates = rates_of(solver);
  auto const x = solver.material().to_host(position);
  double lower = 0, upper = 0, magnitude = 0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    (double(x[i][dim - 1]) < middle ? lower : upper) += one_volume * rates[i];
    magnitude += one_volume * std::abs(rates[i]);
  }
  double const close = 50 * double(std::numeric_limits<typename S::policy::real>::epsilon()) * magnitude;
  CHECK(std::abs(lower - expected) < close);
  CHECK(std::abs(upper + expected) < close);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the hybrid scheme changes nothing where all grains are of one size", "", Policies) {
  using P = TestType;
  auto bed = open_bed<P::dim>(Vec<P::dim, double>::Constant(0.8), 0.1);
  jitter(bed.material, 0.02, 3);
  auto solver = solver_of<Formulated<P, Physics>>(bed, 0.1, {{.velocity = V, .diffusivity = 0.03}, {}});
  for (double const C : {0.0, 1.0}) {
    set_field(solver, concentration, [&](auto const&) { return C; });
    CHECK(largest_of(rates_of(solver)) == 0);
  }
}

TEMPLATE_LIST_TEST_CASE("the hybrid scheme is of second order inside, but for the moment of the kernel", "",
                        DoublePolicies) {
  using P = TestType;
  constexpr int z = P::dim - 1;
  double const D = 0.1;
  auto const flux = SegregationFlux::asymmetric();
  auto const error = [&](double spacing) {
    auto const bed = open_bed<P::dim>(Vec<P::dim, double>::Ones(), spacing);
    auto solver = solver_of<Formulated<P, Physics>>(bed, spacing, {{.velocity = V, .diffusivity = D}, flux});
    set_field(solver, concentration, [&](auto const& x) { return 0.5 + 0.3 * std::sin(2 * x[0] - x[z]); });
    auto const rates = rates_of(solver);
    double largest = 0;
    for (std::size_t i = 0; i < rates.size(); ++i) {
      auto const& x = bed.material[i];
      if (!deep_inside<P::dim>(x, 0.36)) continue;
      double const phase = 2 * x[0] - x[z], C = 0.5 + 0.3 * std::sin(phase);
      // dC/dt = -ghat . grad(V F) + D lap C with ghat = -e_z; both sums carry the factor M.
      double const exact = V * flux.slope(C) * -0.3 * std::cos(phase) - D * 5 * 0.3 * std::sin(phase);
      largest = std::max(largest, std::abs(rates[i] / moment<P::dim>() - exact));
    }
    return largest;
  };
  double const coarse = error(1.0 / 16), fine = error(1.0 / 32), order = std::log2(coarse / fine);
  INFO("errors " << coarse << " and " << fine << ", order " << order);
  CHECK(order > 1.8);
  CHECK(fine < 0.01);
}

TEMPLATE_LIST_TEST_CASE("a floor gathers and a free surface gives off what segregation carries", "", DoublePolicies) {
  using P = TestType;
  if constexpr (P::dim == 2) {
    auto solver = solver_of<Formulated<P, Physics>>(layer({1, 1}, 0.1), 0.1, {{.velocity = V, .diffusivity = 0.03}, {}},
                                                    {}, {{.axis = 0, .low = 0, .high = 1}});
    set_field(solver, concentration, [](auto const&) { return 0.5; });
    check_sources(solver, 0.5, V / 4 * moment<2>());
  }
}

TEMPLATE_LIST_TEST_CASE("sources of walls and free surface add up in corners", "", Policies) {
  using P = TestType;
  Vec<P::dim, double> size = Vec<P::dim, double>::Constant(0.8);
  size[P::dim - 1] = 1;
  auto const bed = open_bed<P::dim>(size, 0.1);
  auto const flux = SegregationFlux::asymmetric();
  auto solver = solver_of<Formulated<P, Physics>>(bed, 0.1, {{.velocity = V, .diffusivity = 0.03}, flux});
  set_field(solver, concentration, [](auto const&) { return 0.25; });
  double const Q = V * flux.value(0.25), share = across_middle<P::dim>(bed.material, 0.1, 0.5);
  check_sources(solver, 0.5, Q * share);
  // Side walls affect only the layer whose pairs they cut off: a support on either side.
  double const area = std::pow(0.8, P::dim - 1), inner = std::pow(0.2, P::dim - 1);
  CHECK(share < area * moment<P::dim>());
  CHECK(share > inner * moment<P::dim>());
}

TEST_CASE("what the hybrid scheme creates in a layer vanishes with the spacing") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  // C linear in height: the gradients of floor and free surface are one-sided, the rest telescopes.
  auto const created = [](double spacing) {
    auto solver =
        solver_of<Formulated<P, Physics>>(layer({1, 1}, spacing), spacing, {{.velocity = V, .diffusivity = 0.01}, {}},
                                          {}, {{.axis = 0, .low = 0, .high = 1}});
    set_field(solver, concentration, [](auto const& x) { return 0.3 + 0.3 * x[1]; });
    return sum_of(rates_of(solver)) * sq(spacing);
  };
  double const coarse = created(0.1), fine = created(0.05), finer = created(0.025);
  INFO(coarse << ", " << fine << ", " << finer << " of " << V * 0.24);
  CHECK(std::abs(coarse) < 0.05 * V * 0.24);
  CHECK(std::abs(fine) < 0.6 * std::abs(coarse));
  CHECK(std::abs(finer) < 0.6 * std::abs(fine));
}

}  // namespace scree::test::hybrid_tests
