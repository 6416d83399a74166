// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/granular/stress_filter.hpp>

#include <terms/mechanics.hpp>

#include <catch2/catch_message.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>

namespace scree::test::stress_filter_tests {
using namespace fields;

namespace {

using OnHost = Policy<2, double, Kokkos::DefaultHostExecutionSpace>;
using Solid = Policy<3, float, Kokkos::DefaultHostExecutionSpace>;
using Some = std::tuple<OnHost, Solid>;
constexpr Smoothed<Stress> smoothed{};
double const dr = 0.125;

template <class P>
using Body = BodyOf<P, Stress, Smoothed<Stress>, Yielding>;

/// Filtered in proportion to the yielding, relative to the yielding from which the filter acts fully.
template <class P, class Function>
Body<P> linearly_filtered(Points<P::dim> const& points, Function const& f, double yielded = 1) {
  auto body = body_of<P, Stress, Smoothed<Stress>, Yielding>(points, std::pow(dr, P::dim));
  set(body, stress, f);
  body.fill(yielding, typename P::real(yielded * LinearFilter{}.full_at));
  sum_over_itself_then(body, 1.5 * dr, linear_filter::Fit{LinearFilter{}.full_at}, linear_filter::Sums{});
  return body;
}
template <class P, class Function>
Body<P> shepard_filtered(Points<P::dim> const& points, Function const& f) {
  auto body = body_of<P, Stress, Smoothed<Stress>, Yielding>(points, std::pow(dr, P::dim));
  set(body, stress, f);
  sum_over_itself_then(body, 1.5 * dr, ShepardMean<Stress>{}, ShepardSums<Stress>{});
  return body;
}

/// A jittered lattice with a slanted corner cut off.
template <int Dim>
Points<Dim> cut_lattice() {
  auto points = lattice<Dim>(dr, 0.3, 3);
  std::erase_if(points, [](auto const& x) { return x[0] + 0.4 * x[Dim - 1] > 1.1; });
  return points;
}
/// Another slope for each entry.
template <int Dim>
auto linear() {
  return [](Vec<Dim, double> const& x) {
    Vec<symmetric3_size<Dim>, double> sigma;
    for (int a = 0; a < sigma.size(); ++a) sigma[a] = 0.3 + a + (1 - 0.4 * a) * x[0] + (0.2 * a - 2) * x[Dim - 1];
    return sigma;
  };
}
/// 1 and -1 alternately.
double sign_at(Vec<2, double> const& x) {
  return (std::lround(x[0] / dr - 0.5) + std::lround(x[1] / dr - 0.5)) % 2 == 0 ? 1 : -1;
}
Vec<4, double> checkerboard(Vec<2, double> const& x) { return sign_at(x) * Vec<4, double>::Ones(); }

}  // namespace

TEMPLATE_LIST_TEST_CASE("the linear filter leaves linear stress alone on any set of neighbours", "", Some) {
  using P = TestType;
  auto const body = linearly_filtered<P>(cut_lattice<P::dim>(), linear<P::dim>());
  double const error = largest_error(body, smoothed, 10, linear<P::dim>());  // entries of up to 10
  INFO("error " << error);
  CHECK(error < ulps<P>(300));
}

TEMPLATE_LIST_TEST_CASE("the linear filter acts by as much as the material has yielded", "", Some) {
  using P = TestType;
  constexpr int dim = P::dim;
  auto const wild = [](auto const& x) {
    return (Vec<symmetric3_size<dim>, double>::Ones() * std::sin(40 * x[0])).eval();
  };
  auto const by = [&](double yielded) {
    return linearly_filtered<P>(cut_lattice<dim>(), wild, yielded).to_host(smoothed);
  };
  auto const none = by(0), some = by(0.25), all = by(1), more = by(7);
  CHECK(all == more);
  double error = 0, change = 0;
  for (std::size_t i = 0; i < none.size(); ++i) {
    error = std::max(error, double((some[i] - (none[i] + (all[i] - none[i]) / 4)).norm()));
    change = std::max(change, double((all[i] - none[i]).norm()));
  }
  CHECK(none == linearly_filtered<P>(cut_lattice<dim>(), wild).to_host(stress));
  CHECK(error < ulps<P>(8));
  CHECK(change > 0.5);
}

TEMPLATE_LIST_TEST_CASE("the Shepard filter leaves constant stress alone, and takes load off the lowest row", "",
                        Some) {
  using P = TestType;
  constexpr int dim = P::dim, size = symmetric3_size<dim>;
  auto const constant = [](auto const&) { return (2.5 * Vec<size, double>::Ones()).eval(); };
  CHECK(largest_error(shepard_filtered<P>(cut_lattice<dim>(), constant), smoothed, 1, constant) < ulps<P>(40));
  // A lattice with a lower end: the weighted mean height of the neighbours of its lowest row, by hand.
  KernelFunction<WendlandC2, dim, double> const W(1.5);
  double weights = 0, heights = 0;
  for (int a = -3; a <= 3; ++a)
    for (int b = dim == 3 ? -3 : 0; b <= (dim == 3 ? 3 : 0); ++b)
      for (int c = 0; c <= 3; ++c)
        if (double const r = std::sqrt(double(a * a + b * b + c * c)); r < W.radius())
          weights += W.value(r), heights += c * W.value(r);
  double const rise = dr * heights / weights;  // 0.36 dr in 2D
  CHECK(rise > 0.35 * dr);
  auto const load = [](Vec<dim, double> const& x) { return ((x[dim - 1] - 1) * Vec<size, double>::Ones()).eval(); };
  auto const less = [&](Vec<dim, double> const& x) { return (load(x).array() + rise).matrix().eval(); };
  auto const lowest = [](Vec<dim, double> const& x) {
    return x[dim - 1] < dr && (x.head(dim - 1).array() > 3 * dr).all() && (x.head(dim - 1).array() < 1 - 3 * dr).all();
  };
  CHECK(largest_error(shepard_filtered<P>(lattice<dim>(dr), load), smoothed, 1, less, lowest) < ulps<P>(40));
  CHECK(largest_error(linearly_filtered<P>(lattice<dim>(dr), load), smoothed, 1, load, lowest) < ulps<P>(100));
}

TEMPLATE_LIST_TEST_CASE("particles whose neighbours fit no plane keep their stress", "", Some) {
  using P = TestType;
  constexpr int dim = P::dim;
  using X = Vec<dim, double>;
  X along = X::Zero();
  along[0] = dr;
  // A single particle; a pair; a row; in 3D all of them in a plane.
  Points<dim> points{X::Constant(-5), X::Constant(5), X::Constant(5) + along};
  for (int k = 0; k < 5; ++k) points.push_back(0.8 * k * along);
  for (int k = 0; dim == 3 && k < 16; ++k)
    points.push_back(X::Constant(9) + (k % 4) * along + (k / 4) * dr * X::UnitY());
  auto const wild = [](X const& x) { return (Vec<symmetric3_size<dim>, double>::Ones() * std::sin(40 * x[0])).eval(); };
  auto const body = linearly_filtered<P>(points, wild);
  CHECK(body.to_host(smoothed) == body.to_host(stress));
  CHECK(body.to_host(stress)[0] != body.to_host(stress)[1]);
}

TEST_CASE("both filters damp differences between neighbours") {
  auto const points = lattice<2>(dr);
  auto const zero_stress = [](auto const&) { return Vec<4, double>(0, 0, 0, 0); };
  auto const inside = [](auto const& x) { return deep_inside<2>(x, 3 * dr); };
  auto const by_mean = shepard_filtered<OnHost>(points, checkerboard);
  auto const by_fit = linearly_filtered<OnHost>(points, checkerboard);
  KernelFunction<WendlandC2, 2, double> const W(1.5);
  double weights = 0, waves = 0;
  for (int a = -3; a <= 3; ++a)
    for (int b = -3; b <= 3; ++b)
      if (double const r = std::hypot(a, b); r < W.radius())
        weights += W.value(r), waves += ((a + b) % 2 == 0 ? 1 : -1) * W.value(r);
  auto const damped = [&](auto const& x) { return (waves / weights * checkerboard(x)).eval(); };
  CHECK(std::abs(waves / weights) < 0.03);
  CHECK(largest_error(by_mean, smoothed, 1, damped, inside) < 1e-14);
  CHECK(largest_error(by_fit, smoothed, 1, damped, inside) < 1e-14);
  // At the edges; 2 is the norm of (1, 1, 1, 1). The fit, which extrapolates from the inside, does less in the corners.
  INFO(largest_error(by_mean, smoothed, 2, zero_stress) << " " << largest_error(by_fit, smoothed, 2, zero_stress));
  CHECK(largest_error(by_mean, smoothed, 2, zero_stress) < 0.17);
  CHECK(largest_error(by_fit, smoothed, 2, zero_stress) < 0.55);
}

}  // namespace scree::test::stress_filter_tests
