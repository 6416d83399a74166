// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "points.hpp"

#include <scree/fields/particles.hpp>
#include <scree/neighbours/cell_list.hpp>
#include <scree/pairs/for_each_pair.hpp>

#include <cmath>
#include <type_traits>

// Bodies for tests of loops and terms.
namespace scree::test {

/// A body with a position, a volume and the given fields.
template <class P, class... Fs>
using BodyOf = Particles<P, Merge<Fields<Position, Volume>, Fields<Fs...>>>;

template <class P, class... Fs>
BodyOf<P, Fs...> body_of(Points<P::dim> const& points, double volume_of_each) {
  using namespace fields;
  BodyOf<P, Fs...> body(static_cast<int>(points.size()));
  body.from_host(position, cast<typename P::real>(points));
  body.fill(volume, typename P::real(volume_of_each));
  return body;
}

/// A value given in double as the value of a field.
template <class P, Field F, class X>
value_t<P, F> as_value(X const& x) {
  if constexpr (std::is_arithmetic_v<X>)
    return static_cast<value_t<P, F>>(x);
  else
    return x.template cast<typename P::real>();
}

/// Sets a field of owned particles from a function of the position, evaluated in double at the rounded position.
template <class Body, Field F, class Function>
void set(Body& body, F field, Function const& function) {
  using P = typename Body::policy;
  std::vector<value_t<P, F>> values;
  for (auto const& x : body.to_host(fields::position)) {
    Vec<P::dim, double> const exact = x.template cast<double>();
    values.push_back(as_value<P, F>(function(exact)));
  }
  body.from_host(field, values);
}

template <class Body>
Positions<typename Body::policy> all_positions(Body const& body) {
  return body[fields::position];
}
template <class Body>
Positions<typename Body::policy> owned_positions(Body const& body) {
  return body[fields::position].part(0, body.size());
}

/// Cells around the sources, for a support of the given radius (m).
template <class Targets, class Sources>
CellList<typename Targets::policy> cells_of(Targets const& targets, Sources const& sources, double radius) {
  CellList<typename Targets::policy> search(radius);
  search.update(owned_positions(targets), all_positions(sources));
  return search;
}

/// Sums terms over one body with itself as neighbours, with a smoothing length (m).
template <class Body, class... Terms>
void sum_over_itself(Body& body, double h, Terms const&... terms) {
  using P = typename Body::policy;
  PairLoopOptions<P> const options{"scree::test::pairs", kernel_of<P>(h)};
  auto const search = cells_of(body, body, options.kernel.radius());
  for_each_pair(options, body, from(body, search, terms...));
}
/// Sums terms over one body with itself as neighbours, and calls `then` with the sums of each particle.
template <class Body, class Then, class... Terms>
void sum_over_itself_then(Body& body, double h, Then const& then, Terms const&... terms) {
  using P = typename Body::policy;
  PairLoopOptions<P, Everywhere, Then> const options{"scree::test::pairs", kernel_of<P>(h), {}, then};
  auto const search = cells_of(body, body, options.kernel.radius());
  for_each_pair(options, body, from(body, search, terms...));
}

/// Largest error of a field of owned particles against a function of the position where keep(x), relative to `scale`.
template <class Body, Field F, class Function, class Keep>
double largest_error(Body const& body, F field, double scale, Function const& exact, Keep const& keep) {
  auto const x = body.to_host(fields::position);
  auto const values = body.to_host(field);
  double error = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    Vec<Body::policy::dim, double> const at = x[i].template cast<double>();
    if (!keep(at)) continue;
    double difference;
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(values[i])>>)
      difference = std::abs(double(values[i]) - exact(at));
    else
      difference = (values[i].template cast<double>() - exact(at)).norm();
    if (!(difference <= error)) error = difference;  // a NaN is kept
  }
  return error / scale;
}
template <class Body, Field F, class Function>
double largest_error(Body const& body, F field, double scale, Function const& exact) {
  return largest_error(body, field, scale, exact, [](auto const&) { return true; });
}

}  // namespace scree::test
