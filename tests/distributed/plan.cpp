// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/distributed/exchange.hpp>
#include <scree/distributed/run_on_parts.hpp>
#include <scree/fields/particles.hpp>

#include <support/backends.hpp>
#include <support/policies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <atomic>

namespace scree::test {
using namespace fields;
namespace {

template <int K>
struct Number : Scalar<"number", "1"> {};
using Many = Fields<Position, Identity, Velocity, Number<0>, Number<1>, Number<2>, Number<3>, Number<4>, Number<5>,
                    Number<6>, Number<7>, Number<8>, Number<9>, Number<10>, Number<11>, Number<12>, Number<13>, Stress>;

/// Sends particle j to part (j + k) % parts for k = 0 to 1, with a shift that tells which.
template <class P>
struct ToTwo {
  int part, parts, first;
  Span<int> numbers;
  ArraySpan<P, Vec<P::dim, typename P::real>> shifts;
  SCREE_FN void operator()(int j, int& count, bool last) const {
    for (int k = 0; k < 2; ++k) {
      if ((j + k) % parts != part) continue;
      if (last && first + count < numbers.size()) {
        auto shift = zero<Vec<P::dim, typename P::real>>();
        shift[0] = typename P::real(k + 1);
        numbers(first + count) = j, shifts(first + count) = shift;
      }
      ++count;
    }
  }
};
template <class P>
auto particles_of(typename P::space const& space, int part, int count) {
  Particles<P, Many> body(space, count);
  std::vector<int> numbers;
  std::vector<value_t<P, Position>> places;
  std::vector<typename P::real> values;
  for (int j = 0; j < count; ++j) {
    numbers.push_back(100 * part + j);
    places.push_back(Vec<P::dim, typename P::real>::Constant(typename P::real(100 * part + j)));
    values.push_back(typename P::real(100 * part + j) / 2);
  }
  body.from_host(identity, numbers);
  body.from_host(position, places);
  body.from_host(Number<13>{}, values);
  return body;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("an exchange brings the listed fields of the planned particles", "", Policies) {
  using P = TestType;
  using Space = typename P::space;
  std::atomic<int> wrong = 0, seen = 0;
  int const parts = 3;
  run_on_parts<Space>(parts, [&](Team<Space> const& team, Space const& space) {
    auto const size_of = [](int part) { return 5 + 3 * part; };
    auto body = particles_of<P>(space, team.part(), size_of(team.part()));
    Plan<P> plan;
    for (int repeated = 0; repeated < 2; ++repeated)
      plan.make(space, team, body.size(), [&](int part, int first, Span<int> const& numbers, auto const& shifts) {
        return ToTwo<P>{part, parts, first, numbers, shifts};
      });
    Exchange<P> exchange;
    auto const columns = column_numbers<Many>(Many{});
    exchange.send(team, plan, body, columns);
    int const owned = body.size();
    body.resize(owned, plan.receiving());
    exchange.receive(plan, body, columns, owned);
    auto const numbers = values_of(body[identity]);
    auto const places = values_of(body[position]);
    auto const values = values_of(body[Number<13>{}]);
    std::size_t k = std::size_t(owned);
    for (int from = 0; from < parts; ++from)
      for (int j = 0; j < size_of(from); ++j)
        for (int twice = 0; twice < 2; ++twice) {
          if ((j + twice) % parts != team.part()) continue;
          int const number = 100 * from + j;
          bool const right = numbers[k] == number && places[k][0] == typename P::real(number + twice + 1) &&
                             places[k][1] == typename P::real(number) && values[k] == typename P::real(number) / 2;
          if (!right) ++wrong;
          ++k, ++seen;
        }
    if (k != numbers.size()) ++wrong;
    if (plan.everywhere() != 2 * (size_of(0) + size_of(1) + size_of(2))) ++wrong;
  });
  CHECK(wrong == 0);
  CHECK(seen == 2 * (5 + 8 + 11));
}

TEST_CASE("messages may have more bytes than an int counts", "") {
  std::int64_t const million = 1'000'000;
  auto const starts = scree::detail::in_bytes({0, 1500 * million, 2000 * million}, 40);
  CHECK(starts == std::vector<std::int64_t>{0, 240'000 * million, 320'000 * million});
  Messages const messages{nullptr, starts};
  CHECK(messages.size_for(0) == 240'000 * million);
  CHECK(messages.size_for(1) == 80'000 * million);
}

}  // namespace scree::test
