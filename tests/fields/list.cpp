// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/fields/list.hpp>
#include <scree/fields/standard.hpp>

#include <catch2/catch_test_macros.hpp>

#include <type_traits>

namespace scree::test::list_tests {
namespace {

using A = Mass;
using B = Density;
using C = Volume;

struct Model {
  using reads = Fields<A>;
  using adds = Fields<B, C>;
};

}  // namespace

TEST_CASE("lists merge in the order of first appearance, without repetition") {
  STATIC_CHECK(std::is_same_v<Merge<>, Fields<>>);
  STATIC_CHECK(std::is_same_v<Merge<Fields<B, A, B>>, Fields<B, A>>);
  STATIC_CHECK(std::is_same_v<Merge<Fields<A, B>, Fields<C, A>>, Fields<A, B, C>>);
  STATIC_CHECK(std::is_same_v<Merge<Fields<>, Fields<C>, Fields<>, Fields<A, C>>, Fields<C, A>>);
}

TEST_CASE("fields are taken out of a list") {
  STATIC_CHECK(std::is_same_v<Without<Fields<A, B, C>, Fields<B>>, Fields<A, C>>);
  STATIC_CHECK(std::is_same_v<Without<Fields<A>, Fields<A, C>>, Fields<>>);
  STATIC_CHECK(std::is_same_v<Without<Fields<A, B>, Fields<>>, Fields<A, B>>);
}

TEST_CASE("a field is found in a list") {
  STATIC_CHECK(OneOf<A, Fields<B, A>>);
  STATIC_CHECK_FALSE(OneOf<C, Fields<B, A>>);
  STATIC_CHECK_FALSE(OneOf<C, Fields<>>);
  STATIC_CHECK(scree::detail::intersects<Fields<A, B>, Fields<C, B>>);
  STATIC_CHECK_FALSE(scree::detail::intersects<Fields<A, B>, Fields<C>>);
  STATIC_CHECK_FALSE(scree::detail::intersects<Fields<>, Fields<C>>);
}

TEST_CASE("lists that a model does not name are empty") {
  STATIC_CHECK(std::is_same_v<reads_of<Model>, Fields<A>>);
  STATIC_CHECK(std::is_same_v<adds_of<Model>, Fields<B, C>>);
  STATIC_CHECK(std::is_same_v<reads_i_of<Model>, Fields<>>);
  STATIC_CHECK(std::is_same_v<writes_of<Model>, Fields<>>);
  STATIC_CHECK(std::is_same_v<provides_of<Model>, Fields<>>);
}

}  // namespace scree::test::list_tests
