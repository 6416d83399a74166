// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/pack.hpp>
#include <scree/core/root.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

namespace scree::test::pack_tests {
using namespace math;
#ifdef SCREE_HAS_PACKS

namespace {

// Exact in both precisions; neither argument is the smaller one in all lanes.
template <class Real>
Real first(int lane) {
  return Real(lane % 2 == 0 ? 1.75 : -2.5) + Real(0.25) * Real(lane);
}
template <class Real>
Real second(int lane) {
  return Real(0.5) + Real(0.375) * Real(lane);
}

/// Whether a function of two packs gives in each lane the result for two numbers, within some units in the last place:
/// a compiler may contract products and sums in one and not in the other.
template <class Real, class Function>
bool lane_by_lane(Function const& function, int units = 0) {
  auto const x = Pack<Real>::of(first<Real>), y = Pack<Real>::of(second<Real>);
  auto const result = function(x, y);
  bool same = true;
  for (int lane = 0; lane < Pack<Real>::size; ++lane) {
    Real const expected = function(first<Real>(lane), second<Real>(lane));
    Real const tolerance = Real(units) * std::numeric_limits<Real>::epsilon() * std::abs(expected);
    same = same && std::abs(result[lane] - expected) <= tolerance;
  }
  return same;
}

}  // namespace

TEMPLATE_TEST_CASE("a pack computes in each lane what a number does", "", float, double) {
  using Real = TestType;
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return x + y; }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return x - y; }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return x * y; }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return x / y; }));
  CHECK(lane_by_lane<Real>([](auto x, auto) { return -x; }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return min(x, y); }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return max(x, y); }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return select(x < y, x, 2 * y); }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return select(x > y, x, 2 * y); }));
  CHECK(lane_by_lane<Real>([](auto x, auto) { return select(x <= 1.75, x, 2 * x); }));
  CHECK(lane_by_lane<Real>([](auto x, auto) { return select(x >= 1.75, x, 2 * x); }));
  CHECK(lane_by_lane<Real>([](auto, auto y) { return root(y); }));
  CHECK(lane_by_lane<Real>(
      [](auto x, auto) {
        using std::exp;
        return exp(x);
      },
      2));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return quotient(x, y); }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return ratio(x, -y); }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return smaller(x, y); }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return magnitude(x - y); }));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return x += y, x *= 3, x -= y, x /= 2; }, 4));
  CHECK(lane_by_lane<Real>([](auto x, auto y) { return 2 * x + y / 3 - power<3>(1 - y); }, 8));
}

TEMPLATE_TEST_CASE("numbers of any precision stand for themselves in all lanes", "", float, double) {
  using Real = TestType;
  Pack<Real> const tenth = 0.1;
  for (int lane = 0; lane < Pack<Real>::size; ++lane) CHECK(tenth[lane] == Real(0.1));
}

TEST_CASE("the numbers in a pack have a type") {
  STATIC_CHECK(std::is_same_v<number_in<Pack<float>>, float>);
  STATIC_CHECK(std::is_same_v<number_in<double>, double>);
}

TEMPLATE_TEST_CASE("the first lanes of a pack are added up", "", float, double) {
  using Real = TestType;
  auto const x = Pack<Real>::of([](int lane) { return Real(1 << lane); });
  for (int count = 0; count <= Pack<Real>::size; ++count) CHECK(x.sum(count) == Real((1 << count) - 1));
}

TEMPLATE_TEST_CASE("small vectors and matrices may be of packs", "", float, double) {
  using Real = TestType;
  CHECK(lane_by_lane<Real>(
      [](auto x, auto y) {
        using Number = decltype(x);
        Vec<3, Number> a, b;
        a << x, y, 2 * x;
        b << y, -y, x * y;
        Mat<3, Number> const both = x * (a + b) * b.transpose() / 2;
        return a.dot(both * b) + both.trace() + a.squaredNorm() + zero<Vec<3, Number>>()[1];
      },
      20));
}

TEMPLATE_TEST_CASE("minimum and maximum of packs pass on what is not a number as those of numbers do", "", float,
                   double) {
  using Real = TestType;
  Real const nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK(std::isnan(min(Real(1), nan)));
  CHECK(std::isnan(max(Real(1), nan)));
  CHECK(min(nan, Real(1)) == 1);
  CHECK(max(nan, Real(1)) == 1);
  using P = Pack<Real>;
  for (int lane = 0; lane < P::size; ++lane) {
    CHECK(std::isnan(min(P(1), P(nan))[lane]));
    CHECK(std::isnan(max(P(1), P(nan))[lane]));
    CHECK(min(P(nan), P(1))[lane] == 1);
    CHECK(max(P(nan), P(1))[lane] == 1);
  }
}

namespace {
template <class T>
concept Branching = requires(T x) {
  x < x ? 1 : 0;
};
template <class T>
concept Comparable = requires(T x) {
  x == x;
};
}  // namespace

TEST_CASE("a pack cannot be asked how large it is") {
  STATIC_CHECK(Branching<double>);
  STATIC_CHECK(!Branching<Pack<double>>);
  STATIC_CHECK(!Comparable<Pack<double>>);
  STATIC_CHECK(!std::is_convertible_v<Pack<double>, bool>);
  STATIC_CHECK(!std::is_convertible_v<Pack<double>, double>);
}

#endif
}  // namespace scree::test::pack_tests
