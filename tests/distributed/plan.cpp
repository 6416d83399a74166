// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/distributed/exchange.hpp>
#include <scree/distributed/run_on_threads.hpp>
#include <scree/fields/particles.hpp>

#include <support/backends.hpp>
#include <support/policies.hpp>

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <atomic>

namespace scree::test::plan_tests {
using namespace fields;
namespace {

template <int K>
struct Number : Scalar<"number", "1"> {};
using Many = Fields<Position, Identity, Velocity, Number<0>, Number<1>, Number<2>, Number<3>, Number<4>, Number<5>,
                    Number<6>, Number<7>, Number<8>, Number<9>, Number<10>, Number<11>, Number<12>, Number<13>, Stress>;

/// Sends particle j to rank (j + k) % ranks for k = 0 to 1, with a shift that tells which.
template <class P>
struct ToTwo {
  int rank, ranks, first;
  Span<int> numbers;
  ArraySpan<P, Vec<P::dim, typename P::real>> shifts;
  SCREE_FN void operator()(int j, int& count, bool last) const {
    for (int k = 0; k < 2; ++k) {
      if ((j + k) % ranks != rank) continue;
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
auto particles_of(typename P::space const& space, int rank, int count) {
  Particles<P, Many> body(space, count);
  std::vector<int> numbers;
  std::vector<value_t<P, Position>> places;
  std::vector<typename P::real> values;
  for (int j = 0; j < count; ++j) {
    numbers.push_back(100 * rank + j);
    places.push_back(Vec<P::dim, typename P::real>::Constant(typename P::real(100 * rank + j)));
    values.push_back(typename P::real(100 * rank + j) / 2);
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
  int const ranks = 3;
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
    auto const size_of = [](int rank) { return 5 + 3 * rank; };
    auto body = particles_of<P>(space, team.rank(), size_of(team.rank()));
    Plan<P> plan;
    for (int repeated = 0; repeated < 2; ++repeated)
      plan.make(space, team, body.size(), [&](int rank, int first, Span<int> const& numbers, auto const& shifts) {
        return ToTwo<P>{rank, ranks, first, numbers, shifts};
      });
    Exchange<P> exchange;
    auto const columns = column_numbers<Many>(Many{});
    std::vector<Shipment<P>> const all = {{plan, body, columns}};
    exchange.send(team, all);
    int const owned = body.size();
    body.resize(owned, plan.receiving());
    exchange.receive(all);
    auto const numbers = values_of(body[identity]);
    auto const places = values_of(body[position]);
    auto const values = values_of(body[Number<13>{}]);
    std::size_t k = std::size_t(owned);
    for (int from = 0; from < ranks; ++from)
      for (int j = 0; j < size_of(from); ++j)
        for (int twice = 0; twice < 2; ++twice) {
          if ((j + twice) % ranks != team.rank()) continue;
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

TEMPLATE_LIST_TEST_CASE("an exchange of several bodies sends one message to each rank", "", Policies) {
  using P = TestType;
  using Space = typename P::space;
  std::atomic<int> wrong = 0, seen = 0;
  int const ranks = 3;
  run_on_threads<Space>(ranks, [&](Team<Space> const& team, Space const& space) {
    int const here = team.rank();
    // Rank 1 has nothing of the second body, and nothing of the third travels from rank 2 to rank 0.
    auto const size_of = [](int rank, int body) {
      return body == 1 && rank == 1 ? 0 : body == 2 && rank == 2 ? 1 : 7 + 2 * rank + body;
    };
    std::vector<Particles<P, Many>> bodies;
    std::vector<Plan<P>> plans(3);
    for (int b = 0; b < 3; ++b) {
      bodies.push_back(particles_of<P>(space, here, size_of(here, b)));
      plans[std::size_t(b)].make(space, team, size_of(here, b),
                                 [&](int rank, int first, Span<int> const& numbers, auto const& shifts) {
                                   return ToTwo<P>{(rank + b) % ranks, ranks, first, numbers, shifts};
                                 });
    }
    std::vector<Shipment<P>> const all = {
        {plans[0], bodies[0], column_numbers<Many>(Many{})},
        {plans[1], bodies[1], column_numbers<Many>(Fields<Identity>{})},
        {plans[2], bodies[2], column_numbers<Many>(Fields<Number<13>, Identity, Position>{})}};
    Exchange<P> exchange;
    Traffic const before = team.traffic();
    exchange.send(team, all);
    if (team.traffic().exchanges - before.exchanges != 1) ++wrong;
    if (team.traffic().messages - before.messages != ranks - 1) ++wrong;
    std::int64_t bytes = 0;  // to others
    for (auto const& each : all)
      bytes += 4 * each.words *
               (each.plan->sending() - each.plan->sent()[std::size_t(here) + 1] + each.plan->sent()[std::size_t(here)]);
    if (team.traffic().bytes - before.bytes != bytes) ++wrong;

    std::vector<int> owned;
    for (std::size_t b = 0; b < 3; ++b) {
      owned.push_back(bodies[b].size());
      bodies[b].resize(owned[b], plans[b].receiving());
    }
    exchange.receive(all);
    for (int b = 0; b < 3; ++b) {
      auto const& body = bodies[std::size_t(b)];
      auto const numbers = values_of(body[identity]);
      auto const places = values_of(body[position]);
      auto const values = values_of(body[Number<13>{}]);
      auto k = std::size_t(owned[std::size_t(b)]);
      for (int from = 0; from < ranks; ++from)
        for (int j = 0; j < size_of(from, b); ++j)
          for (int twice = 0; twice < 2; ++twice) {
            if ((j + twice) % ranks != (here + b) % ranks) continue;
            int const number = 100 * from + j;
            bool const right =
                numbers[k] == number && (b == 1 || (places[k][0] == typename P::real(number + twice + 1) &&
                                                    values[k] == typename P::real(number) / 2));
            if (!right) ++wrong;
            ++k, ++seen;
          }
      if (k != numbers.size()) ++wrong;
    }
  });
  CHECK(wrong == 0);
  CHECK(seen == 2 * (7 + 9 + 11 + 8 + 0 + 12 + 9 + 11 + 1));
}

TEST_CASE("messages may have more bytes than an int counts", "") {
  std::int64_t const million = 1'000'000;
  auto const starts = scree::detail::in_bytes({0, 1500 * million, 2000 * million}, 40);
  CHECK(starts == std::vector<std::int64_t>{0, 240'000 * million, 320'000 * million});
  Messages const messages{nullptr, starts};
  CHECK(messages.size_for(0) == 240'000 * million);
  CHECK(messages.size_for(1) == 80'000 * million);
}

}  // namespace scree::test::plan_tests
