// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/system/periodic.hpp>

#include <support/bodies.hpp>

#include <scree/terms/kernel_sums.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace scree::test::periodic_tests {
using namespace fields;

struct Here {};

namespace {

constexpr double spacing = 0.1, h = 1.25 * spacing, reach = 2 * h;

template <class P>
using Periodic = BodyOf<P, Concentration, KernelSum<Here>, KernelGradient<Here>>;

template <class P>
Periodic<P> sample(Points<P::dim> const& points) {
  return body_of<P, Concentration, KernelSum<Here>, KernelGradient<Here>>(points, std::pow(spacing, P::dim));
}

template <int Dim>
std::vector<Period> all_axes() {
  std::vector<Period> periods;
  for (int axis = 0; axis < Dim; ++axis) periods.push_back({axis, 0, 1});
  return periods;
}

// An image as integers that can be sorted and compared: position in 1e-5 m, and the mark of its origin.
template <int Dim>
using Image = std::array<long, Dim + 1>;
template <int Dim>
Image<Dim> image(Vec<Dim, double> const& x, double mark) {
  Image<Dim> result{};
  for (int axis = 0; axis < Dim; ++axis) result[static_cast<std::size_t>(axis)] = std::lround(1e5 * x[axis]);
  result[Dim] = std::lround(mark);
  return result;
}

// By hand: every particle shifted by every combination of periods, where the result is within reach of the box.
template <int Dim>
std::vector<Image<Dim>> images_by_hand(Points<Dim> const& points, std::vector<Period> const& periods) {
  std::vector<Image<Dim>> result;
  int combinations = 1;
  for (std::size_t k = 0; k < periods.size(); ++k) combinations *= 3;
  for (std::size_t j = 0; j < points.size(); ++j)
    for (int combination = 1; combination < combinations; ++combination) {
      auto x = points[j];
      bool near = true;
      int rest = combination;
      for (auto const& [axis, low, high] : periods) {
        x[axis] += (rest % 3 == 2 ? -1 : rest % 3) * (high - low);
        near = near && x[axis] >= low - reach && x[axis] < high + reach;
        rest /= 3;
      }
      if (near) result.push_back(image<Dim>(x, double(j)));
    }
  std::sort(result.begin(), result.end());
  return result;
}

template <class P>
std::vector<Image<P::dim>> ghosts_of(Periodic<P> const& body) {
  auto const x = values_of(body[position]);
  auto const marks = values_of(body[concentration]);
  std::vector<Image<P::dim>> result;
  for (auto i = static_cast<std::size_t>(body.size()); i < x.size(); ++i)
    result.push_back(image<P::dim>(x[i].template cast<double>(), double(marks[i])));
  std::sort(result.begin(), result.end());
  return result;
}

// Coordinates that are exact in float, none of them at a distance `reach` from a side.
template <int Dim>
Points<Dim> scattered(int count, unsigned seed) {
  auto points = random_points<Dim>(count, 0, 1, seed);
  for (auto& x : points)
    for (int axis = 0; axis < Dim; ++axis) x[axis] = (std::floor(x[axis] * 1024) + 0.5) / 1024;
  return points;
}

template <class Body>
void mark(Body& body) {
  std::vector<typename Body::policy::real> marks;
  for (int i = 0; i < body.size(); ++i) marks.push_back(typename Body::policy::real(i));
  body.from_host(concentration, marks);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("ghosts are all images within reach, corners included", "", Policies) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto periods = all_axes<dim>();
  for (; !periods.empty(); periods.pop_back()) {
    PeriodicImages<P> images(periods, reach);
    auto body = sample<P>({});
    // Numbers that grow and shrink: earlier images must leave no trace.
    for (int const count : {40, 300, 80, 1, 0, 200}) {
      auto const points = scattered<dim>(count, static_cast<unsigned>(count));
      body.resize(count);
      body.from_host(position, cast<typename P::real>(points));
      mark(body);
      for (int repetition = 0; repetition < 2; ++repetition) {
        images.create(body);
        images.refresh(body, body.numbers_of(Fields<Concentration>{}));
        INFO(count << " particles, " << periods.size() << " periods");
        CHECK(body.size() == count);
        CHECK(ghosts_of<P>(body) == images_by_hand<dim>(points, periods));
      }
    }
  }
}

TEMPLATE_LIST_TEST_CASE("ghosts follow the fields of their origins", "", Policies) {
  using P = TestType;
  auto body = sample<P>(scattered<P::dim>(60, 3));
  PeriodicImages<P> images(all_axes<P::dim>(), reach);
  images.create(body);
  mark(body);
  images.refresh(body, body.numbers_of(Fields<Concentration>{}));
  auto const before = ghosts_of<P>(body);
  set(body, concentration, [](auto const&) { return 5; });
  CHECK(ghosts_of<P>(body) == before);
  images.refresh(body, body.numbers_of(Fields<Concentration>{}));
  for (auto const& ghost : ghosts_of<P>(body)) CHECK(ghost[P::dim] == 5);
}

template <int K>
struct Marked : Scalar<"mark", "1"> {};
template <class P, int... K>
void check_many(std::integer_sequence<int, K...>) {
  using All = Fields<Identity, Marked<K>..., Position>;
  Particles<P, All> body;
  auto const points = scattered<P::dim>(30, 5);
  body.resize(30);
  body.from_host(position, cast<typename P::real>(points));
  (body.from_host(Marked<K>{}, std::vector<typename P::real>(30, typename P::real(K))), ...);
  std::vector<int> numbers(30);
  std::iota(numbers.begin(), numbers.end(), 0);
  body.from_host(identity, numbers);
  PeriodicImages<P> images(all_axes<P::dim>(), reach);
  images.create(body);
  REQUIRE(body.ghosts() > 0);
  auto const placed = values_of(body[position]);
  images.refresh(body, column_numbers<All>(All{}));
  CHECK(values_of(body[position]) == placed);
  auto const origins = values_of(body[identity]);
  for (std::size_t k = 30; k < origins.size(); ++k) {
    auto const moved = (placed[k] - placed[std::size_t(origins[k])]).eval();
    CHECK(double((moved - moved.array().round().matrix()).norm()) < 1e-6);  // by whole periods
    CHECK(double(moved.norm()) > 0.5);
  }
  auto const check = [](auto const& values, int mark) {
    for (auto const& value : values) CHECK(double(value) == mark);
  };
  (check(values_of(body[Marked<K>{}]), K), ...);
}
TEMPLATE_LIST_TEST_CASE("ghosts carry any number of fields", "", Policies) {
  check_many<TestType>(std::make_integer_sequence<int, 37>());
}

TEMPLATE_LIST_TEST_CASE("a lattice that repeats along all axes has no boundary", "", Policies) {
  using P = TestType;
  auto body = sample<P>(lattice<P::dim>(spacing));
  PeriodicImages<P> images(all_axes<P::dim>(), reach);
  images.create(body);
  images.refresh(body, body.numbers_of(Fields<Volume>{}));
  sum_over_itself(body, h, KernelSums<Here>{});
  auto const sums = body.to_host(kernel_sum<Here>);
  auto const [least, most] = std::minmax_element(sums.begin(), sums.end());
  CHECK(double(*most - *least) < ulps<P>(50));
  CHECK(std::abs(double(*most) - 1) < 0.02);
  CHECK(largest_error(body, kernel_gradient<Here>, 1 / h, [](auto const& x) { return (0 * x).eval(); }) < ulps<P>(100));
}

TEMPLATE_LIST_TEST_CASE("wrapping brings particles back by whole periods", "", Policies) {
  using P = TestType;
  constexpr int dim = P::dim;
  Points<dim> points;
  for (double const x : {-2.25, -0.25, 0.0, 0.5, 0.9375, 1.0, 1.25, 7.5})
    points.push_back(Vec<dim, double>::Constant(x));
  auto body = sample<P>(points);
  PeriodicImages<P> const images({{0, 0, 1}, {dim - 1, -0.5, 1.5}}, reach);
  images.settle(body);
  auto const x = body.to_host(position);
  for (std::size_t k = 0; k < x.size(); ++k) {
    INFO("from " << points[k][0]);
    CHECK(double(x[k][0]) == points[k][0] - std::floor(points[k][0]));
    CHECK(double(x[k][dim - 1]) == points[k][0] - 2 * std::floor((points[k][0] + 0.5) / 2));
    if (dim == 3) CHECK(double(x[k][1]) == points[k][0]);
  }
}

TEMPLATE_LIST_TEST_CASE("the place at rest of a wall is wrapped with the wall", "", Policies) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto body = body_of<P, RestPosition>({Vec<dim, double>::Constant(1.25), Vec<dim, double>::Constant(0.75)}, 1);
  set(body, rest_position, [](auto const& x) { return (x - Vec<dim, double>::Constant(0.5)).eval(); });
  PeriodicImages<P>({{0, 0, 1}}, reach).settle(body);
  auto const x = body.to_host(position), rest = body.to_host(rest_position);
  CHECK(double(x[0][0]) == 0.25);
  CHECK(double(rest[0][0]) == -0.25);
  CHECK(double(rest[0][1]) == 0.75);
  CHECK(double(x[1][0]) == 0.75);
  CHECK(double(rest[1][0]) == 0.25);
}

TEMPLATE_LIST_TEST_CASE("a period shorter than two supports, or of no axis, is refused", "", Policies) {
  using P = TestType;
  CHECK_NOTHROW(PeriodicImages<P>({{0, 0, 2 * reach}}, reach));
  CHECK_NOTHROW(PeriodicImages<P>({{0, 0, 2 * reach}}, reach, 0.2 * reach));
  CHECK_NOTHROW(PeriodicImages<P>({{0, -0.009, 0.009}}, 2 * 1.5 * 0.003));  // 2 times 1.5 times 0.003 is above 0.009
  CHECK_THROWS_AS(PeriodicImages<P>({{0, 0, 1.99 * reach}}, reach), std::invalid_argument);
  CHECK_THROWS_AS(PeriodicImages<P>({{0, 1, 0}}, reach), std::invalid_argument);
  CHECK_THROWS_AS(PeriodicImages<P>({{P::dim, 0, 1}}, reach), std::invalid_argument);
  CHECK_THROWS_AS(PeriodicImages<P>({{-1, 0, 1}}, reach), std::invalid_argument);
  CHECK_THROWS_AS(PeriodicImages<P>({{0, 0, std::nan("")}}, reach), std::invalid_argument);
}

TEMPLATE_LIST_TEST_CASE("without periods there are no ghosts", "", Policies) {
  using P = TestType;
  auto body = sample<P>(scattered<P::dim>(20, 1));
  PeriodicImages<P> images({}, reach);
  images.settle(body);
  images.create(body);
  images.refresh(body, body.numbers_of(Fields<Concentration>{}));
  CHECK(body.ghosts() == 0);
}

}  // namespace scree::test::periodic_tests
