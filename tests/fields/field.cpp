// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/fields/field.hpp>
#include <scree/fields/standard.hpp>

#include <catch2/catch_test_macros.hpp>

#include <set>
#include <string>
#include <type_traits>

namespace scree::test::field_tests {
using namespace fields;
namespace {

struct Warmth : Scalar<"warmth", "K"> {};
struct NotEmpty : Scalar<"warmth", "K"> {
  int member = 0;
};
struct NoUnit {
  static constexpr std::string_view name = "nothing";
  template <int Dim, class Real>
  using value = Real;
};
struct Float2 {
  static constexpr int dim = 2;
  using real = float;
};

template <class F, class Value>
constexpr bool has_value_in_3d = std::is_same_v<typename F::template value<3, double>, Value>;

}  // namespace

TEST_CASE("a field knows its name and unit") {
  CHECK(Warmth::name == "warmth");
  CHECK(Warmth::unit == "K");
  CHECK(Previous<Warmth>::name == "warmth");
  CHECK(Previous<Warmth>::unit == "K");
}

TEST_CASE("the values of fields follow the dimension and the precision") {
  STATIC_CHECK(has_value_in_3d<Warmth, double>);
  STATIC_CHECK(has_value_in_3d<Vector<"v", "1">, Vec<3, double>>);
  STATIC_CHECK(has_value_in_3d<Tensor<"t", "1">, Mat<3, double>>);
  STATIC_CHECK(has_value_in_3d<Symmetric<"s", "1">, Vec<6, double>>);
  STATIC_CHECK(has_value_in_3d<Symmetric3<"s", "1">, Vec<6, double>>);
  STATIC_CHECK(has_value_in_3d<SymmetricOperator<"o", "1">, Mat<6, double>>);
  STATIC_CHECK(has_value_in_3d<Integer<"i", "1">, int>);
  STATIC_CHECK(has_value_in_3d<Previous<Warmth>, double>);
  STATIC_CHECK(std::is_same_v<value_t<Float2, Symmetric3<"t", "1">>, Vec<4, float>>);
  STATIC_CHECK(std::is_same_v<value_t<Float2, Vector<"v", "1">>, Vec<2, float>>);
}

TEST_CASE("a field is empty and has a name, a unit and a value") {
  STATIC_CHECK(Field<Warmth>);
  STATIC_CHECK(Field<Previous<Warmth>>);
  STATIC_CHECK_FALSE(Field<NotEmpty>);
  STATIC_CHECK_FALSE(Field<NoUnit>);
  STATIC_CHECK_FALSE(Field<int>);
}

TEST_CASE("standard fields have different names, as output needs") {
  // Inserted one by one: nvcc 13 sets all elements of a braced list of static members to the last one.
  std::set<std::string> names;
  auto const add = [&](auto field) { names.emplace(decltype(field)::name); };
  add(velocity), add(position), add(mass), add(density), add(volume), add(concentration_rate), add(concentration);
  add(shear_rate), add(identity), add(acceleration), add(stress), add(stress_rate), add(rest_position);
  CHECK(names.size() == 13);
}

}  // namespace scree::test::field_tests
