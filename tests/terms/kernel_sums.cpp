// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/terms/kernel_sums.hpp>

#include <support/bodies.hpp>
#include <support/lattice_sums.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

namespace scree::test::kernel_sums_tests {
using namespace fields;

struct Sand {};
struct Box3 {};

namespace {
template <class P>
auto with_sums(Points<P::dim> const& points) {
  auto body = body_of<P, KernelSum<Sand>, KernelGradient<Sand>>(points, std::pow(0.1, P::dim));
  sum_over_itself(body, 0.15, KernelSums<Sand>{});
  return body;
}
}  // namespace

TEMPLATE_LIST_TEST_CASE("kernel sums on a lattice are those of the lattice, without a gradient", "", Policies) {
  using P = TestType;
  auto const body = with_sums<P>(lattice<P::dim>(0.1));
  double const expected = LatticeSums<P::dim>(1.5).value;
  if (P::dim == 2) CHECK(std::abs(expected - 1.00514) < 5e-6);  // derived in kernels/wendland_c2.cpp
  auto const inside = [](auto const& x) { return deep_inside<P::dim>(x, 0.26); };
  CHECK(largest_error(
            body, kernel_sum<Sand>, 1, [&](auto const&) { return expected; }, inside) < ulps<P>(100));
  CHECK(largest_error(
            body, kernel_gradient<Sand>, 10, [](auto const& x) { return (0 * x).eval(); }, inside) < ulps<P>(100));
}

TEMPLATE_LIST_TEST_CASE("the kernel gradient at a face points into the body", "", Policies) {
  using P = TestType;
  auto const body = with_sums<P>(lattice<P::dim>(0.1));
  auto const x = body.to_host(position);
  auto const gradients = body.to_host(kernel_gradient<Sand>);
  auto const sums = body.to_host(kernel_sum<Sand>);
  int faces = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    Vec<P::dim, double> at = x[i].template cast<double>();
    if (at[0] > 0.06) continue;
    at[0] = 0.5;
    if (!deep_inside<P::dim>(at, 0.26)) continue;
    ++faces;
    CHECK(double(gradients[i][0]) > 1);  // 1/h = 6.7 is its scale
    CHECK(std::abs(double(gradients[i].norm() - gradients[i][0])) < 1e-4);
    CHECK(double(sums[i]) < 0.8);
  }
  CHECK(faces > 0);
}

TEMPLATE_LIST_TEST_CASE("the kernel sum of a lone particle is its own share", "", Policies) {
  using P = TestType;
  auto const body = with_sums<P>({Vec<P::dim, double>::Constant(0.5)});
  double const own = std::pow(0.1, P::dim) * KernelFunction<WendlandC2, P::dim, double>(0.15).value(0);
  CHECK(std::abs(double(body.to_host(kernel_sum<Sand>)[0]) - own) < ulps<P>(8));
}

TEST_CASE("sums over different bodies are different fields") {
  STATIC_CHECK_FALSE(std::is_same_v<KernelSum<Sand>, KernelSum<Box3>>);
  STATIC_CHECK(OneOf<KernelSum<Sand>, adds_of<KernelSums<Sand>>>);
}

TEST_CASE("a unit vector has length one, or zero where there is no direction") {
  using vector = Vec<3, double>;
  vector const x(3, 0, -4);
  CHECK((math::unit_vector(x) - vector(0.6, 0, -0.8)).norm() < 1e-15);
  CHECK(math::unit_vector(vector(vector::Zero())) == vector::Zero());
  CHECK(math::unit_vector(x, 5.0) == vector::Zero());
}

}  // namespace scree::test::kernel_sums_tests
