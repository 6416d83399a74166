// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/symmetric.hpp>

#include <support/points.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <Eigen/Dense>
#include <limits>

namespace scree::test::symmetric_tests {

// Solves a tridiagonal system of unit rows for every right-hand side, to test the solver on the device.
template <class P>
struct SolveThere {
  ArraySpan<P, Vec<3, typename P::real>> x;
  SCREE_FN void operator()(int i) const {
    using real = typename P::real;
    Mat<3, real> A = Mat<3, real>::Identity() * real(2);
    A(1, 0) = A(2, 1) = real(-1);  // only the lower triangle is read
    Vec<3, real> b = Vec<3, real>::Zero();
    b[0] = real(4 * i);
    Vec<3, real> solution = Vec<3, real>::Zero();
    if (solve_positive_definite<3, real>(A, b, real(1e-6), solution)) x(i) = solution;
  }
};

namespace {

template <int N>
void check_random_solves() {
  std::mt19937_64 random(N);
  auto const number = [&] { return 2 * std::ldexp(double(random() >> 11), -53) - 1; };
  for (int trial = 0; trial < 50; ++trial) {
    Mat<N, double> B;
    Vec<N, double> b;
    for (int i = 0; i < N; ++i) {
      b[i] = number();
      for (int j = 0; j < N; ++j) B(i, j) = number();
    }
    Mat<N, double> const A = B * B.transpose() + 0.1 * Mat<N, double>::Identity();
    Mat<N, double> lower = A;
    lower.template triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
    Vec<N, double> x = Vec<N, double>::Zero();
    REQUIRE(solve_positive_definite<N, double>(lower, b, 1e-12, x));
    Vec<N, double> const expected = A.ldlt().solve(b);
    // The condition number of A is below N^2/0.1.
    CHECK((x - expected).norm() < 1e-12 * expected.norm());
  }
}

template <int N>
bool refuses(Mat<N, double> const& A) {
  Vec<N, double> const before = Vec<N, double>::Constant(42);
  Vec<N, double> x = before;
  return !solve_positive_definite<N, double>(A, Vec<N, double>(Vec<N, double>::Ones()), 1e-10, x) && x == before;
}

}  // namespace

TEST_CASE("a positive definite system is solved as Eigen solves it, from its lower triangle") {
  check_random_solves<1>();
  check_random_solves<3>();
  check_random_solves<6>();
}

TEST_CASE("a system that is not positive definite is refused and nothing is written") {
  Vec<3, double> const a(1, 2, -1), b(0.5, 0, 1);
  Mat<3, double> const rank_one = a * a.transpose(), rank_two = rank_one + b * b.transpose();
  CHECK(refuses<3>(rank_one));
  CHECK(refuses<3>(rank_two));
  CHECK(refuses<3>(Mat<3, double>::Zero()));
  CHECK(refuses<3>(-Mat<3, double>::Identity()));
  Mat<3, double> indefinite = Mat<3, double>::Identity();
  indefinite(1, 0) = indefinite(0, 1) = 2;
  CHECK(refuses<3>(indefinite));
  Mat<3, double> not_finite = Mat<3, double>::Identity();
  not_finite(1, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK(refuses<3>(not_finite));
  CHECK_FALSE(refuses<3>(rank_two + 1e-3 * Mat<3, double>::Identity()));
}

TEMPLATE_LIST_TEST_CASE("systems are solved on the device", "", Policies) {
  using P = TestType;
  Array<P, Vec<3, typename P::real>> const x(typename P::space(), "x", 10);
  for_each_index(typename P::space(), "scree::test::solve", 0, 10, SolveThere<P>{x});
  auto const solutions = values_of(x);
  // [2 -1 0; -1 2 -1; 0 -1 2] x = (4 k, 0, 0): x = k (3, 2, 1).
  for (int k = 0; k < 10; ++k)
    CHECK((solutions[static_cast<std::size_t>(k)].template cast<double>() - k * Vec<3, double>(3, 2, 1)).norm() <
          ulps<P>(100));
}

TEST_CASE("the dot product of Mandel vectors is the double contraction") {
  // (x (x) x) : (y (x) y) = (x . y)^2 and I : (x (x) x) = |x|^2, I : I = dim.
  Vec<2, double> const x2(0.3, -1.1), y2(0.7, 0.2);
  Vec<3, double> const x3(0.3, -1.1, 0.6), y3(0.7, 0.2, -0.9);
  CHECK(std::abs(square_of(x2).dot(square_of(y2)) - sq(x2.dot(y2))) < 1e-15);
  CHECK(std::abs(square_of(x3).dot(square_of(y3)) - sq(x3.dot(y3))) < 1e-15);
  CHECK(std::abs(symmetric_identity<2, double>().dot(square_of(x2)) - x2.squaredNorm()) < 1e-15);
  CHECK(std::abs(symmetric_identity<3, double>().dot(square_of(x3)) - x3.squaredNorm()) < 1e-15);
  CHECK(symmetric_identity<3, double>().squaredNorm() == 3);
}

}  // namespace scree::test::symmetric_tests
