// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "charged_body.hpp"

#include <scree/boundaries/mirror_lens.hpp>
#include <scree/granular/granular.hpp>
#include <scree/granular/stress_filter.hpp>
#include <scree/neighbours/brute_force.hpp>
#include <scree/segregation/conservative.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

// On a GPU, which has no packs, both sides of a comparison are pair by pair.
namespace scree::test::in_packs_tests {
using namespace fields;
namespace {

constexpr double h = 0.5;

/// A term or lens that does not take packs.
template <class Term>
struct Single : Term {
  static constexpr bool takes_packs = false;
};

/// Adds the size of its numbers.
struct SizeOfNumbers {
  using reads = Fields<Charge>;
  using adds = Fields<Potential>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const&, IJ const&, S& sum) const {
    using Real = typename IJ::real;
    sum[potential] += Real(int(sizeof(Real)));
  }
};

/// The given number of particles within reach of each other.
template <class P>
Charged<P> crowd(int count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<> coordinate(0, h);  // the diagonal of this cube is shorter than the support
  Points<P::dim> points(static_cast<std::size_t>(count));
  for (auto& x : points)
    for (int axis = 0; axis < P::dim; ++axis) x[axis] = coordinate(random);
  return charged<P>(points, 0.7);
}

template <class P>
BruteForce<P> all_of(Charged<P> const& sources) {
  BruteForce<P> search(2 * h);
  search.update(all_positions(sources), all_positions(sources));
  return search;
}

template <class P, class... Terms>
void sum_all(Charged<P>& body, Terms const&... terms) {
  PairLoopOptions<P> const options{"scree::test::pairs", kernel_of<P>(h)};
  auto const search = all_of<P>(body);
  for_each_pair(options, body, from(body, search, terms...));
}

/// Largest difference of a field between two bodies, over its largest value.
template <class P, Field F>
double difference(Charged<P> const& a, Charged<P> const& b, F field) {
  auto const of_a = a.to_host(field), of_b = b.to_host(field);
  auto const size = [](value_t<P, F> const& x) {
    if constexpr (std::is_arithmetic_v<value_t<P, F>>)
      return std::abs(double(x));
    else
      return double(x.norm());
  };
  double most = 0, largest = 0;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    double const apart = size(of_a[i] - of_b[i]);
    if (!(apart <= most)) most = apart;  // a NaN is kept
    largest = std::max(largest, size(of_b[i]));
  }
  return largest > 0 ? most / largest : most;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("sums in packs are those pair by pair, for any number of neighbours", "", Policies) {
  using P = TestType;
  auto counts = std::vector<int>{128, 129, 130, 140, 257, 258, 400};  // around multiples of the capacity of one call
  for (int count = 1; count <= 75; ++count) counts.push_back(count);
  for (int const count : counts) {
    INFO(count << " particles");
    auto packs = crowd<P>(count), singles = crowd<P>(count);
    sum_all(packs, Repulsion{}, Screening{}, Heat{});
    sum_all(singles, Single<Repulsion>{}, Single<Screening>{}, Single<Heat>{});
    // Repulsion cancels to a part of the sum of magnitudes.
    CHECK(difference(packs, singles, force) < ulps<P>(200));
    CHECK(difference(packs, singles, potential) < ulps<P>(30));
    CHECK(difference(packs, singles, heating) < ulps<P>(30));
  }
}

TEMPLATE_LIST_TEST_CASE("candidates beyond the support do not show in packs", "", Policies) {
  using P = TestType;
  // Lanes of a GPU share the candidates, so the candidates do affect the last digits there.
  if constexpr (!runs_on_host<P>) return;
  auto near = crowd<P>(50), all = crowd<P>(100);
  // Every other particle belongs to the first body; the rest is far from it.
  auto const x = near.to_host(position);
  auto mixed = all.to_host(position);
  for (std::size_t k = 0; k < mixed.size(); ++k) {
    mixed[k] = x[k / 2];
    if (k % 2 == 1) mixed[k][0] += 10;
  }
  all.from_host(position, mixed);
  charge_up(all);
  sum_all(near, Repulsion{}, Screening{});
  sum_all(all, Repulsion{}, Screening{});
  auto const forces = near.to_host(force), forces_of_all = all.to_host(force);
  auto const potentials = near.to_host(potential), potentials_of_all = all.to_host(potential);
  bool same = true;
  for (std::size_t k = 0; k < forces.size(); ++k)
    same = same && forces[k] == forces_of_all[2 * k] && potentials[k] == potentials_of_all[2 * k];
  CHECK(same);
}

TEMPLATE_LIST_TEST_CASE("a lens shows packs what it shows single pairs", "", Policies) {
  using P = TestType;
  auto packs = crowd<P>(43), singles = crowd<P>(43);
  auto const others = crowd<P>(37, 2);
  PairLoopOptions<P> const options{"scree::test::pairs", kernel_of<P>(h)};
  auto const search = all_of<P>(others);
  for_each_pair(options, packs, through(OppositeCharge{}, others, search, Heat{}));
  for_each_pair(options, singles, through(Single<OppositeCharge>{}, others, search, Heat{}));
  CHECK(difference(packs, singles, heating) < ulps<P>(30));
}

TEMPLATE_LIST_TEST_CASE("terms that take packs get them, unless one summed with them or the lens does not", "",
                        Policies) {
  using P = TestType;
  using real = typename P::real;
  auto body = crowd<P>(50);
  auto const expected = [](std::size_t size) { return std::vector<real>(50, real(49 * size)); };
  std::size_t size = sizeof(real);
  if constexpr (has_packs && runs_on_host<P>) size = sizeof(Pack<real>);
  // A pack adds its size in each lane.
  sum_all(body, SizeOfNumbers{});
  CHECK(body.to_host(potential) == expected(size));
  sum_all(body, SizeOfNumbers{}, Heat{}, Repulsion{});
  CHECK(body.to_host(potential) == expected(size));
  sum_all(body, SizeOfNumbers{}, CountNeighbours{});
  CHECK(body.to_host(potential) == expected(sizeof(real)));
  CHECK(body.to_host(neighbours) == std::vector<int>(50, 49));
  PairLoopOptions<P> const options{"scree::test::pairs", kernel_of<P>(h)};
  for_each_pair(options, body, through(Single<OppositeCharge>{}, body, all_of<P>(body), SizeOfNumbers{}));
  CHECK(body.to_host(potential) == expected(sizeof(real)));
}

TEMPLATE_LIST_TEST_CASE("a position that is not a number shows in the sums", "", Policies) {
  using P = TestType;
  auto body = crowd<P>(20);
  auto x = body.to_host(position);
  x[7][0] = std::numeric_limits<typename P::real>::quiet_NaN();
  body.from_host(position, x);
  sum_all(body, Screening{});
  for (auto const sum : body.to_host(potential)) CHECK(std::isnan(sum));
}

TEST_CASE("the sums of the granular and of the segregation models take packs") {
  STATIC_CHECK(takes_packs<WendlandC2>);
  STATIC_CHECK(takes_packs<AsIs>);
  STATIC_CHECK(takes_packs<adami::Seen>);
  STATIC_CHECK(takes_packs<adami::Weights>);
  STATIC_CHECK(takes_packs<adami::Weighted<Stress>>);
  STATIC_CHECK(takes_packs<VelocityGradientSum>);
  STATIC_CHECK(takes_packs<FirstMomentSum>);
  STATIC_CHECK(takes_packs<NumberDensitySum>);
  STATIC_CHECK(takes_packs<StressDivergence<>>);
  STATIC_CHECK(takes_packs<ArtificialViscosity<DensityOfParticle>>);
  STATIC_CHECK(takes_packs<linear_filter::Sums>);
  STATIC_CHECK(takes_packs<pair_weights::DisorderSums>);
  STATIC_CHECK(takes_packs<pair_weights::FourthMomentSum>);
  STATIC_CHECK(takes_packs<PairTransport>);
  STATIC_CHECK(takes_packs<MirrorLens<UniformDensity>>);
}

}  // namespace scree::test::in_packs_tests
