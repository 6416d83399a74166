// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "charged_body.hpp"

#include <scree/neighbours/brute_force.hpp>
#include <scree/neighbours/verlet_list.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace scree::test::for_each_pair_tests {
using namespace fields;
namespace {

constexpr double spacing = 0.1, h = 1.5 * spacing;

template <class P>
Charged<P> sample(Points<P::dim> const& points = lattice<P::dim>(spacing, 0.2)) {
  return charged<P>(points, std::pow(spacing, P::dim));
}

template <class T>
bool same_bits(std::vector<T> const& a, std::vector<T> const& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

// All sums of one target over some sources by two plain loops in double. Charges are those of the sources, or those
// that a lens gives.
template <int Dim>
struct ByHand {
  Vec<Dim, double> force = Vec<Dim, double>::Zero();
  double potential = 0, heating = 0;
  int neighbours = 0;

  template <class SeenCharge>
  ByHand(Points<Dim> const& targets, std::size_t i, Points<Dim> const& sources, bool same, SeenCharge const& seen) {
    double const V = std::pow(spacing, Dim);
    auto const& xi = targets[i];
    KernelFunction<WendlandC2, Dim, double> const W(h);
    for (std::size_t j = 0; j < sources.size(); ++j) {
      Vec<Dim, double> const x = xi - sources[j];
      double const r = x.norm(), q = seen(xi, sources[j]);
      if (r >= 2 * h) continue;
      potential += q * W.value(r) / (1 + r / h);
      if (same && i == j) continue;
      force -= charge_at(xi) * q * V * V * W.slope_over_distance(r) * x;
      heating += (temperature_at(xi) + q) * r * r * W.slope_over_distance(r);
      ++neighbours;
    }
  }
};

template <class P>
Points<P::dim> rounded(Points<P::dim> const& points) {
  Points<P::dim> result;
  for (auto const& x : cast<typename P::real>(points)) result.push_back(x.template cast<double>());
  return result;
}

template <class P, class Body, class Exact>
void check_against(Body const& body, Exact const& by_hand) {
  auto const forces = body.to_host(force);
  auto const potentials = body.to_host(potential), heatings = body.to_host(heating);
  double error = 0, size_of_force = 0, size_of_heating = 0,
         size_of_potential = KernelFunction<WendlandC2, P::dim, double>(h).value(0);
  for (int i = 0; i < body.size(); ++i) {
    auto const k = static_cast<std::size_t>(i);
    ByHand<P::dim> const exact = by_hand(k);
    size_of_force = std::max(size_of_force, exact.force.norm());
    size_of_heating = std::max(size_of_heating, std::abs(exact.heating));
    error = std::max(error, std::abs(double(potentials[k]) - exact.potential) / size_of_potential);
  }
  for (int i = 0; i < body.size(); ++i) {
    auto const k = static_cast<std::size_t>(i);
    ByHand<P::dim> const exact = by_hand(k);
    error = std::max(error, (forces[k].template cast<double>() - exact.force).norm() / size_of_force);
    error = std::max(error, std::abs(double(heatings[k]) - exact.heating) / size_of_heating);
  }
  CHECK(error < ulps<P>(100));  // some 30 (2D) or 100 (3D) neighbours, each rounded a few times
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("fused terms are the sum of single terms, to the last bit", "", Policies) {
  using P = TestType;
  auto fused = sample<P>(), single = sample<P>();
  sum_over_itself(fused, h, Repulsion{}, Screening{}, Heat{});
  sum_over_itself(fused, h, RepulsionEffort{}, CountNeighbours{});
  sum_over_itself(single, h, Repulsion{});
  sum_over_itself(single, h, Screening{});
  sum_over_itself(single, h, Heat{});
  sum_over_itself(single, h, RepulsionEffort{});
  sum_over_itself(single, h, CountNeighbours{});
  CHECK(same_bits(fused.to_host(force), single.to_host(force)));
  CHECK(same_bits(fused.to_host(potential), single.to_host(potential)));
  CHECK(same_bits(fused.to_host(heating), single.to_host(heating)));
  CHECK(same_bits(fused.to_host(effort), single.to_host(effort)));
  CHECK(same_bits(fused.to_host(neighbours), single.to_host(neighbours)));
}

// The pairs of a term that takes long are found first, in parts where they are many.
template <class Term>
struct TakesLong : Term {
  static constexpr bool takes_packs = false;
  static constexpr bool is_long = true;
};
template <class Term>
struct WithoutPacks : Term {
  static constexpr bool takes_packs = false;
};
TEMPLATE_LIST_TEST_CASE("terms that take long have the same sums, to the last bit, also where particles crowd", "",
                        Policies) {
  using P = TestType;
  auto points = lattice<P::dim>(spacing, 0.2);
  Vec<P::dim, double> middle = Vec<P::dim, double>::Constant(0.5);
  for (int k = 0; k < 1500; ++k) {  // within the support of each other
    middle[0] += 1e-5;
    points.push_back(middle);
  }
  auto found_first = sample<P>(points), one_by_one = sample<P>(points);
  sum_over_itself(found_first, h, TakesLong<Repulsion>{}, TakesLong<Screening>{}, TakesLong<CountNeighbours>{});
  sum_over_itself(one_by_one, h, WithoutPacks<Repulsion>{}, WithoutPacks<Screening>{}, WithoutPacks<CountNeighbours>{});
  CHECK(found_first.to_host(neighbours).back() > 1500);
  CHECK(same_bits(found_first.to_host(neighbours), one_by_one.to_host(neighbours)));
  CHECK(same_bits(found_first.to_host(force), one_by_one.to_host(force)));
  CHECK(same_bits(found_first.to_host(potential), one_by_one.to_host(potential)));
}

TEMPLATE_LIST_TEST_CASE("a pair loop agrees with two plain loops", "", Policies) {
  using P = TestType;
  auto body = sample<P>();
  auto const x = rounded<P>(lattice<P::dim>(spacing, 0.2));
  sum_over_itself(body, h, Repulsion{}, Screening{}, Heat{});
  auto const seen = [](auto const&, auto const& xj) { return charge_at(xj); };
  check_against<P>(body, [&](std::size_t i) { return ByHand<P::dim>(x, i, x, true, seen); });
}

TEMPLATE_LIST_TEST_CASE("a pair loop does not care which search it gets", "", Policies) {
  using P = TestType;
  auto const run = []<class Search>(Search search) {
    auto body = sample<P>();
    search.update(owned_positions(body), all_positions(body));
    PairLoopOptions<P> const options{"scree::test::pairs", kernel_of<P>(h)};
    for_each_pair(options, body, from(body, search, Screening{}, CountNeighbours{}));
    return body;
  };
  auto const all = run(BruteForce<P>(2 * h)), cells = run(CellList<P>(2 * h)), list = run(VerletList<P>(2 * h));
  CHECK(all.to_host(neighbours) == cells.to_host(neighbours));
  CHECK(all.to_host(neighbours) == list.to_host(neighbours));
  // Orders of summation differ between all pairs and cells; a Verlet list has the order of its cells, which are wider.
  auto const a = all.to_host(potential), b = cells.to_host(potential), c = list.to_host(potential);
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference = std::max({difference, std::abs(double(a[i] - b[i])), std::abs(double(a[i] - c[i]))});
  CHECK(difference < ulps<P>(100) * double(*std::max_element(a.begin(), a.end())));
}

TEMPLATE_LIST_TEST_CASE("the particle itself counts for terms that ask for it, and other particles in its place always",
                        "", Policies) {
  using P = TestType;
  auto points = Points<P::dim>(3, Vec<P::dim, double>::Constant(0.5));
  points.push_back(Vec<P::dim, double>::Constant(0.9));
  auto body = sample<P>(points);
  sum_over_itself(body, h, CountNeighbours{});
  CHECK(body.to_host(neighbours) == std::vector<int>{2, 2, 2, 0});
  sum_over_itself(body, h, CountWithItself{});
  CHECK(body.to_host(neighbours) == std::vector<int>{3, 3, 3, 1});
  // In a fused loop with a term that includes the particle itself, other terms still exclude it.
  sum_over_itself(body, h, CountNeighbours{}, Screening{});
  CHECK(body.to_host(neighbours) == std::vector<int>{2, 2, 2, 0});
}

TEMPLATE_LIST_TEST_CASE("a particle at the end of the support or beyond is no neighbour", "", Policies) {
  using P = TestType;
  using real = typename P::real;
  double const support = double(kernel_of<P>(h).radius());
  Points<P::dim> points(3, Vec<P::dim, double>::Zero());
  points[1][0] = support;                                                            // exactly at the end
  points[2][1] = double(std::nextafter(real(support), real(0))) * (1 - ulps<P>(4));  // just within
  auto body = sample<P>(points);
  sum_over_itself(body, h, CountNeighbours{});
  CHECK(body.to_host(neighbours) == std::vector<int>{1, 0, 1});
}

TEMPLATE_LIST_TEST_CASE("sums are made anew, whatever the fields held", "", Policies) {
  using P = TestType;
  auto body = sample<P>();
  sum_over_itself(body, h, Screening{});
  auto const first = body.to_host(potential);
  sum_over_itself(body, h, Screening{});
  CHECK(same_bits(first, body.to_host(potential)));
}

TEMPLATE_LIST_TEST_CASE("sources may be two bodies, one of them seen through a lens", "", Policies) {
  using P = TestType;
  auto points = lattice<P::dim>(spacing, 0.2);
  auto const beyond = [](auto const& x) { return x[0] > 0.6; };
  Points<P::dim> inner, outer;
  std::remove_copy_if(points.begin(), points.end(), std::back_inserter(inner), beyond);
  std::copy_if(points.begin(), points.end(), std::back_inserter(outer), beyond);
  auto body = sample<P>(inner);
  // The other body has no charge: the lens provides it from its density.
  auto wall = body_of<P, Density>(outer, std::pow(spacing, P::dim));
  set(wall, density, [](auto const& x) { return density_at(x); });

  PairLoopOptions<P> const options{"scree::test::pairs", kernel_of<P>(h)};
  auto const near_body = cells_of(body, body, 2 * h), near_wall = cells_of(body, wall, 2 * h);
  for_each_pair(options, body, from(body, near_body, Repulsion{}, Screening{}, Heat{}),
                through(OppositeCharge{}, wall, near_wall, Repulsion{}, Screening{}, Heat{}));

  auto const x = rounded<P>(inner), xw = rounded<P>(outer);
  auto const own = [](auto const&, auto const& xj) { return charge_at(xj); };
  auto const opposite = [](auto const& xi, auto const& xj) { return -density_at(xj) - temperature_at(xi); };
  check_against<P>(body, [&](std::size_t i) {
    ByHand<P::dim> total(x, i, x, true, own);
    ByHand<P::dim> const of_wall(x, i, xw, false, opposite);
    total.force += of_wall.force;
    total.potential += of_wall.potential;
    total.heating += of_wall.heating;
    return total;
  });
}

namespace {
struct Nothing {};
/// Repulsion, in one byte.
struct RepulsionOfOneByte : Repulsion {
  Nothing nothing = {};
};
/// Screening, with a number.
struct ScreeningTimes {
  Nothing nothing = {};
  double factor;
  using reads = Screening::reads;
  using adds = Screening::adds;
  static constexpr bool takes_packs = true, includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using Real = std::remove_cvref_t<decltype(ij.W())>;
    sum[potential] += Real(factor) * (j[charge] * ij.W() / (1 + ij.r / ij.h()));
  }
};
}  // namespace

// nvcc 13 and the host compiler once disagreed on where the second source of such a loop is.
TEMPLATE_LIST_TEST_CASE("terms of one byte in front of terms with numbers are passed to the device as they are", "",
                        Policies) {
  using P = TestType;
  auto body = sample<P>();
  auto wall = body_of<P, Density>(lattice<P::dim>(spacing, 0.3), std::pow(spacing, P::dim));
  set(wall, density, [](auto const& x) { return density_at(x); });
  PairLoopOptions<P> const options{"scree::test::pairs", kernel_of<P>(h)};
  auto const near_body = cells_of(body, body, 2 * h), near_wall = cells_of(body, wall, 2 * h);
  for_each_pair(options, body, from(body, near_body, Repulsion{}, Screening{}),
                through(OppositeCharge{}, wall, near_wall, Repulsion{}, Screening{}));
  auto const forces = body.to_host(force);
  auto const potentials = body.to_host(potential);
  static_assert(sizeof(RepulsionOfOneByte) == 1);
  for_each_pair(options, body, from(body, near_body, RepulsionOfOneByte{}, ScreeningTimes{.factor = 1}),
                through(OppositeCharge{}, wall, near_wall, RepulsionOfOneByte{}, ScreeningTimes{.factor = 1}));
  CHECK(same_bits(forces, body.to_host(force)));
  CHECK(same_bits(potentials, body.to_host(potential)));
}

TEMPLATE_LIST_TEST_CASE("sums are zero where a condition does not hold, and right where it does", "", Policies) {
  using P = TestType;
  auto body = sample<P>(), everywhere = sample<P>();
  body.fill(potential, 99);
  sum_over_itself(everywhere, h, Screening{});
  PairLoopOptions<P, LeftHalf> const options{"scree::test::pairs", kernel_of<P>(h), {}, {}};
  auto const search = cells_of(body, body, 2 * h);
  for_each_pair(options, body, from(body, search, Screening{}));
  auto expected = everywhere.to_host(potential);
  auto const x = body.to_host(position);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!(x[i][0] < 0.5f)) expected[i] = 0;
  CHECK(same_bits(body.to_host(potential), expected));
}

TEMPLATE_LIST_TEST_CASE("a function of the sums is stored in their place", "", Policies) {
  using P = TestType;
  using real = typename P::real;
  auto reference = sample<P>();
  sum_over_itself(reference, h, Screening{});
  // The sums have no field: they exist in registers only.
  auto body = body_of<P, Charge, Temperature>(lattice<P::dim>(spacing, 0.2), 1);
  set(body, charge, [](auto const& x) { return charge_at(x); });
  sum_over_itself_then(body, h, Glow{3}, Screening{});
  auto const potentials = reference.to_host(potential), charges = body.to_host(charge),
             glow = body.to_host(temperature);
  double error = 0;
  for (std::size_t i = 0; i < glow.size(); ++i) {
    real const expected = real(3) * (potentials[i] + charges[i]);
    error = std::max(error, std::abs(double(glow[i] - expected)) / std::abs(double(expected)));
  }
  CHECK(error < ulps<P>(8));
}

TEMPLATE_LIST_TEST_CASE("ghosts are sources and never targets", "", Policies) {
  using P = TestType;
  auto const points = lattice<P::dim>(spacing, 0.2);
  auto whole = sample<P>(points);
  sum_over_itself(whole, h, Screening{}, CountNeighbours{});
  // The same particles, with the last third as ghosts.
  int const n = whole.size(), owned = n - n / 3;
  auto body = sample<P>(points);
  body.resize(owned, n - owned);
  body.fill(neighbours, -7);
  sum_over_itself(body, h, Screening{}, CountNeighbours{});
  auto sums = values_of(body[neighbours]);
  auto const expected = whole.to_host(neighbours);
  CHECK(std::equal(sums.begin(), sums.begin() + owned, expected.begin()));
  CHECK(std::all_of(sums.begin() + owned, sums.end(), [](int count) { return count == -7; }));
  auto const potentials = whole.to_host(potential);
  CHECK(same_bits(body.to_host(potential), {potentials.begin(), potentials.begin() + owned}));
}

TEMPLATE_LIST_TEST_CASE("sums of an antisymmetric term cancel to round-off", "", Policies) {
  using P = TestType;
  auto body = sample<P>();
  sum_over_itself(body, h, Repulsion{}, RepulsionEffort{});
  Vec<P::dim, double> total = Vec<P::dim, double>::Zero();
  double largest_total = 0;
  for (auto const& f : body.to_host(force)) total += f.template cast<double>();
  for (auto const e : body.to_host(effort)) largest_total += double(e);
  // Each of n neighbours is rounded when it is added: n/2 ulps of the sum of magnitudes at most, n <= 130.
  CHECK(total.norm() < ulps<P>(65) * largest_total);
  CHECK(largest_total > 0.1);
}

namespace {
template <class P>
std::vector<double> everything_of() {
  auto body = sample<P>();
  sum_over_itself(body, h, Repulsion{}, Screening{}, Heat{});
  std::vector<double> all;
  for (auto const& f : body.to_host(force)) all.insert(all.end(), f.data(), f.data() + P::dim);
  for (auto const p : body.to_host(potential)) all.push_back(double(p));
  for (auto const q : body.to_host(heating)) all.push_back(double(q));
  return all;
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("host and device agree, and the number of threads does not show", "", Policies) {
  using P = TestType;
  auto const result = everything_of<P>();
  auto const host = everything_of<OnSpace<P, Kokkos::DefaultHostExecutionSpace>>();
  REQUIRE(result.size() == host.size());
  double difference = 0, largest = 0;
  for (std::size_t k = 0; k < host.size(); ++k) {
    difference = std::max(difference, std::abs(result[k] - host[k]));
    largest = std::max(largest, std::abs(host[k]));
  }
  CHECK(difference < ulps<P>(100) * largest);
  CHECK(result == everything_of<P>());  // repeated, to the last bit
#ifdef KOKKOS_ENABLE_SERIAL
  CHECK(host == everything_of<OnSpace<P, Kokkos::Serial>>());  // ctest gives the host space two threads
#endif
}

TEMPLATE_LIST_TEST_CASE("a loop over no particles does nothing", "", Policies) {
  using P = TestType;
  auto body = sample<P>(Points<P::dim>{});
  sum_over_itself(body, h, Repulsion{}, Screening{});
  CHECK(body.to_host(force).empty());
}

}  // namespace scree::test::for_each_pair_tests
