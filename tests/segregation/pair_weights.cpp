// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/segregation/pair_weights.hpp>

#include <support/formulations.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <numbers>

namespace scree::test::pair_weights_tests {
using namespace fields;

/// sum_j V_j w_ij x (x) x with the weights of pairs.
struct MomentOfPairs : Symmetric<"second moment of the pair weights", "1"> {};
inline constexpr MomentOfPairs moment_of_pairs{};
/// sum_j V_j w_ij x (x) x with weights from A_i alone instead of (A_i + A_j)/2.
struct OwnMoment : Symmetric<"second moment of the own weights", "1"> {};
inline constexpr OwnMoment own_moment{};
/// sum_j V_j f_ij x and sum_j V_j f_ij c_ij x.
struct DipoleBefore : Vector<"dipole before the odd correction", "m"> {};
inline constexpr DipoleBefore dipole_before{};
struct DipoleAfter : Vector<"dipole after the odd correction", "m"> {};
inline constexpr DipoleAfter dipole_after{};
/// Numbers of neighbours whose weight is not a positive number, or differs when seen from the other side.
struct NotPositive : Integer<"weights that are not positive", "1"> {};
inline constexpr NotPositive not_positive{};
struct NotSymmetric : Integer<"weights that are not symmetric", "1"> {};
inline constexpr NotSymmetric not_symmetric{};

struct ProbeWeights {
  using reads = Fields<Volume, OddCorrection, EvenCorrection>;
  using adds = Fields<MomentOfPairs, OwnMoment, DipoleBefore, DipoleAfter, NotPositive, NotSymmetric>;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    auto const w = pair_weights::weight(i, j, ij);
    auto const f = j[volume] * pair_weights::shape(ij), c = pair_weights::odd_factor(i, j, ij);
    auto const xx = square_of(ij.x);
    IJ ji = ij;
    ji.x = -ij.x;
    sum[moment_of_pairs] += j[volume] * w * xx;
    sum[own_moment] += f * c * i[even_correction].dot(xx) / sq(ij.r) * xx;
    sum[dipole_before] += f * ij.x;
    sum[dipole_after] += f * c * ij.x;
    // Beyond 0.99 of the support the weight may be rounded to zero.
    sum[not_positive] += int(!(w > 0) && ij.r < typename IJ::real(0.99) * ij.support());
    // Equal up to rounding: a compiler may contract the two evaluations in different ways.
    auto const other = pair_weights::weight(j, i, ji);
    sum[not_symmetric] += int(Kokkos::abs(w - other) > 16 * Kokkos::Experimental::epsilon_v<typename IJ::real> * w);
  }
};

struct WeightsOnly {
  using evolves = Fields<>;
  auto passes(Resolution const& resolution) const {
    return std::tuple_cat(pair_weights::passes(resolution),
                          std::tuple(pair_pass<Material>("probe", over<Material>(ProbeWeights{}))));
  }
};

namespace {

template <class P>
auto probed(Bed<P::dim> const& bed, double spacing) {
  auto solver = solver_of<Formulated<P, WeightsOnly>>(bed, spacing);
  solver.update_rates();
  return solver;
}

/// Largest |moment - I| of the particles that are kept.
template <class S, Field F, class Keep>
double off_identity(S const& solver, F field, Keep const& keep) {
  auto const x = solver.material().to_host(position);
  auto const moments = solver.material().to_host(field);
  auto const identity = symmetric_identity<S::policy::dim, typename S::policy::real>();
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (keep(x[i].template cast<double>().eval())) worst = std::max(worst, double((moments[i] - identity).norm()));
  return worst;
}

template <class S>
void check_positive_and_symmetric(S const& solver) {
  int bad = 0, uneven = 0;
  for (int const count : solver.material().to_host(not_positive)) bad += count;
  for (int const count : solver.material().to_host(not_symmetric)) uneven += count;
  CHECK(bad == 0);
  CHECK(uneven == 0);
  double worst = 0;
  for (auto const& A : solver.material().to_host(even_correction)) {
    bool const finite = std::isfinite(double(A.norm()));
    worst = std::max(worst, finite ? 0.0 : 1.0);
  }
  CHECK(worst == 0);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("each particle's own weights have the identity as second moment", "", Policies) {
  using P = TestType;
  // Twice a support, for the particle and for its neighbours' corrections.
  auto const inside = [](auto const& x) { return deep_inside<P::dim>(x, 0.32); };
  auto const solver = probed<P>({lattice<P::dim>(0.1, 0.1), {}}, 0.1);
  CHECK(off_identity(solver, own_moment, inside) < ulps<P>(200));
  // Pairs average A: on the lattice, where all A are equal, nothing changes.
  auto const regular = probed<P>({lattice<P::dim>(0.05), {}}, 0.05);
  auto const deeper = [](auto const& x) { return deep_inside<P::dim>(x, 0.32); };
  CHECK(off_identity(regular, moment_of_pairs, deeper) < ulps<P>(200));
  // With 10 % of disorder A varies by about that between neighbours.
  CHECK(off_identity(solver, moment_of_pairs, inside) < 0.1);
  CHECK(off_identity(solver, moment_of_pairs, inside) > ulps<P>(1000));
}

TEMPLATE_LIST_TEST_CASE("along straight walls the weights keep the second moment", "", DoublePolicies) {
  using P = TestType;
  auto const bed = open_bed<P::dim>(Vec<P::dim, double>::Ones(), 0.1);
  auto const solver = probed<P>(bed, 0.1);
  // A half space of neighbours spans all symmetric tensors, so that A_i is still exact.
  auto const beside_floor = [](auto const& x) {
    bool central = x[P::dim - 1] < 0.1;
    for (int axis = 0; axis < P::dim - 1; ++axis) central = central && std::abs(x[axis] - 0.5) < 0.16;
    return central;
  };
  CHECK(off_identity(solver, own_moment, beside_floor) < 1e-12);
}

TEMPLATE_LIST_TEST_CASE("weights are positive, finite and the same from both sides", "", Policies) {
  using P = TestType;
  for (double const disorder : {0.0, 0.1, 0.3}) {
    auto bed = open_bed<P::dim>(Vec<P::dim, double>::Constant(0.6), 0.1);
    jitter(bed.material, disorder * 0.1, 5);
    check_positive_and_symmetric(probed<P>(bed, 0.1));
  }
  // A single particle, two, three in a corner, a line of five, and a cloud of random ones.
  Bed<P::dim> few{random_points<P::dim>(30, 5, 5.4, 2), {}};
  auto const add = [&](double x, double y) {
    few.material.push_back(Vec<P::dim, double>::Zero());
    few.material.back()[0] = x;
    few.material.back()[1] = y;
  };
  add(0, 0);
  add(1, 0), add(1.1, 0.02);
  add(2, 0), add(2.1, 0), add(2, 0.1);
  for (int k = 0; k < 5; ++k) add(3 + 0.1 * k, 0);
  check_positive_and_symmetric(probed<P>(few, 0.1));
}

TEMPLATE_LIST_TEST_CASE("the odd correction lowers the dipole of a disordered lattice threefold", "", DoublePolicies) {
  using P = TestType;
  auto const solver = probed<P>({lattice<P::dim>(0.0625, 0.1), {}}, 0.0625);
  auto const x = solver.material().to_host(position);
  auto const before = solver.material().to_host(dipole_before), after = solver.material().to_host(dipole_after);
  double squares_before = 0, squares_after = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!deep_inside<P::dim>(x[i], 0.38)) continue;  // two supports
    squares_before += before[i].squaredNorm();
    squares_after += after[i].squaredNorm();
  }
  // A damped step leaves one fifth of a slowly varying dipole, and a little of that of the neighbours.
  INFO("by a factor of " << std::sqrt(squares_before / squares_after));
  CHECK(std::sqrt(squares_before / squares_after) > 3);
}

TEMPLATE_LIST_TEST_CASE("a regular lattice gets no odd correction, nor does a particle on the free surface", "",
                        DoublePolicies) {
  using P = TestType;
  auto bed = open_bed<P::dim>(Vec<P::dim, double>::Ones(), 0.1);
  auto const regular = probed<P>(bed, 0.1).material().to_host(odd_correction);
  jitter(bed.material, 0.01, 4);
  auto const disordered = probed<P>(bed, 0.1).material().to_host(odd_correction);
  double largest = 0, on_surface = 0, inside = 0;
  for (std::size_t i = 0; i < regular.size(); ++i) {
    double const height = bed.material[i][P::dim - 1];
    // In units of 1/h. Walls fill the supports on all sides except above.
    if (height < 0.68) largest = std::max(largest, 0.15 * regular[i].norm());
    if (height < 0.68) inside = std::max(inside, 0.15 * disordered[i].norm());
    if (height > 0.92) on_surface = std::max(on_surface, disordered[i].norm());
  }
  CHECK(largest < 1e-12);
  CHECK(inside > 0.01);
  CHECK(on_surface == 0);
}

TEST_CASE("the trace of a full support is the integral of f r^2") {
  using std::numbers::pi;
  // int_0^R (1 - r/R)^4 r^2 2 pi r dr = 2 pi R^4 B(4, 5) = 2 pi R^4 3! 4!/8!, and with 4 pi r^2: 4 pi R^5 B(5, 5) = 4!
  // 4!/9!.
  double const R = 1.7;
  CHECK(std::abs(pair_weights::full_trace<2>(R) - 2 * pi * std::pow(R, 4) * 6 * 24 / 40320) < 1e-12);
  CHECK(std::abs(pair_weights::full_trace<3>(R) - 4 * pi * std::pow(R, 5) * 24 * 24 / 362880) < 1e-12);
}

}  // namespace scree::test::pair_weights_tests
