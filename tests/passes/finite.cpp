// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/passes/finite.hpp>

#include <support/points.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

namespace scree::test::finite_tests {
using namespace fields;

struct Strain : Tensor<"strain", "1"> {};
struct Count : Integer<"count", "1"> {};

namespace {

using Evolved = Fields<Position, Velocity, Stress, Concentration, Strain, Count>;
template <class P>
using Body = Particles<P, Merge<Fields<Identity, Density>, Evolved>>;

template <class P>
Body<P> body_of_nine() {
  Body<P> body(9);
  std::vector<Vec<P::dim, typename P::real>> points;
  for (int k = 0; k < 9; ++k) points.push_back(Vec<P::dim, typename P::real>::Constant(typename P::real(k)));
  body.from_host(position, points);
  body.from_host(identity, std::vector<int>{10, 11, 12, 13, 14, 15, 16, 17, 18});
  return body;
}
/// Sets the last component of one particle's value.
template <class P, Field F>
void inject(Body<P>& body, F field, int i, typename P::real bad) {
  auto values = body.to_host(field);
  auto& value = values[static_cast<std::size_t>(i)];
  if constexpr (std::is_arithmetic_v<value_t<P, F>>)
    value = bad;
  else
    value.data()[value.size() - 1] = bad;
  body.from_host(field, values);
}
template <class Body>
std::string complaint(Body const& body) {
  try {
    check_finite(body, Evolved{}, 120);
  } catch (std::runtime_error const& error) {
    return error.what();
  }
  return "";
}

template <class P, Field F>
void check_named(F field, typename P::real bad) {
  INFO(F::name << " " << bad);
  auto body = body_of_nine<P>();
  inject(body, field, 7, bad);
  inject(body, field, 3, bad);
  using Catch::Matchers::ContainsSubstring;
  CHECK_THAT(complaint(body), ContainsSubstring("scree: particle 13 is not finite after step 120 at (3, "));
  CHECK_THAT(complaint(body), ContainsSubstring(": " + std::string(F::name) + " = "));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("the first particle that is not finite is named", "", Policies) {
  using P = TestType;
  using real = typename P::real;
  CHECK(complaint(body_of_nine<P>()) == "");
  auto const infinity = std::numeric_limits<real>::infinity(), nan = std::numeric_limits<real>::quiet_NaN();
  for (real const bad : {nan, infinity, -infinity}) {
    check_named<P>(position, bad);
    check_named<P>(velocity, bad);
    check_named<P>(stress, bad);
    check_named<P>(concentration, bad);
    check_named<P>(Strain{}, bad);
  }
}

TEST_CASE("the message has all fields of the particle that are not finite, with their units") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto body = body_of_nine<P>();
  inject(body, velocity, 8, std::numeric_limits<double>::infinity());
  inject(body, concentration, 8, std::numeric_limits<double>::infinity());
  CHECK(complaint(body) ==
        "scree: particle 18 is not finite after step 120 at (8, 8) m: velocity = (0, inf) m/s, concentration = inf 1");
}

TEST_CASE("fields that are not asked for, ghosts and empty bodies do not stop a run") {
  using P = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
  auto body = body_of_nine<P>();
  inject(body, density, 2, std::numeric_limits<double>::quiet_NaN());
  CHECK(complaint(body) == "");
  body.resize(9, 3);
  copy_into(body[concentration].part(9, 12), std::vector<double>(3, std::numeric_limits<double>::quiet_NaN()));
  CHECK(complaint(body) == "");
  check_finite(body, Fields<>{}, 0);
  CHECK(complaint(Body<P>()) == "");
}

}  // namespace scree::test::finite_tests
