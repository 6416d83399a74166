// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/core/symmetric.hpp>
#include <scree/fields/standard.hpp>
#include <scree/io/in_space.hpp>
#include <scree/terms/gradient.hpp>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <vector>

// VTK stores vectors as x, y, z, symmetric tensors as xx, yy, zz, xy, yz, xz and others row by row.
namespace scree::test::in_space_tests {
using namespace fields;
namespace {

struct Moment : Symmetric<"moment", "m^2"> {};
struct Deformation : Tensor<"deformation", "1"> {};
struct Operator : SymmetricOperator<"operator", "1"> {};

template <int Dim, class F, class Value>
auto numbers(F, Value const& value) {
  auto const all = in_space<Dim, F>(value);
  CHECK(all.size() == std::size_t(components_in_space<F>));
  return std::vector(all.begin(), all.end());
}

}  // namespace

TEST_CASE("values in three dimensions keep their axes") {
  using Numbers = std::vector<double>;
  CHECK(numbers<3>(concentration, 0.25) == Numbers{0.25});
  CHECK(numbers<3>(identity, 7) == std::vector<std::int32_t>{7});
  CHECK(numbers<3>(velocity, Vec<3, double>(1, 2, 3)) == Numbers{1, 2, 3});
  Mat<3, double> full;
  full << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  CHECK(numbers<3>(Deformation{}, full) == Numbers{1, 2, 3, 4, 5, 6, 7, 8, 9});
  // 11, 22, 33, 12, 13, 23
  Vec<6, double> packed;
  packed << 11, 22, 33, 12, 13, 23;
  CHECK(numbers<3>(stress, packed) == Numbers{11, 22, 33, 12, 23, 13});
}

TEST_CASE("a plane is the plane y = 0, and upwards is z") {
  using Numbers = std::vector<double>;
  CHECK(numbers<2>(concentration, 0.25) == Numbers{0.25});
  CHECK(numbers<2>(velocity, Vec<2, double>(1, 2)) == Numbers{1, 0, 2});
  CHECK(numbers<2>(gradient<Concentration>, Vec<2, double>(1, 2)) == Numbers{1, 0, 2});
  Mat<2, double> full;
  full << 11, 12, 21, 22;
  CHECK(numbers<2>(Deformation{}, full) == Numbers{11, 0, 12, 0, 0, 0, 21, 0, 22});
  // 11, 22, 33 out of the plane, 12
  CHECK(numbers<2>(stress, Vec<4, double>(11, 22, 33, 12)) == Numbers{11, 33, 22, 0, 0, 12});
  CHECK(numbers<2>(stress, Vec<4, float>(11, 22, 33, 12)) == std::vector<float>{11, 33, 22, 0, 0, 12});
}

TEST_CASE("a symmetric tensor in Mandel's notation loses its factors") {
  auto const in_plane = numbers<2>(Moment{}, square_of(Vec<2, double>(2, 3)));
  auto const expected = std::vector<double>{4, 0, 9, 0, 0, 6};
  for (std::size_t k = 0; k < 6; ++k) CHECK(in_plane[k] == Catch::Approx(expected[k]));
  auto const in_3d = numbers<3>(Moment{}, square_of(Vec<3, double>(2, 3, 5)));
  auto const expected_3d = std::vector<double>{4, 9, 25, 6, 15, 10};
  for (std::size_t k = 0; k < 6; ++k) CHECK(in_3d[k] == Catch::Approx(expected_3d[k]));
}

TEST_CASE("an operator on tensors has no array") { STATIC_CHECK(components_in_space<Operator> == 0); }

}  // namespace scree::test::in_space_tests
