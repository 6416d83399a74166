// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <support/bodies.hpp>

#include <scree/pairs/for_each_particle.hpp>

#include <random>

// Disordered bodies for terms of the momentum balance.
namespace scree::test {

/// Sets a field of owned particles from numbers between -1 and 1.
template <class Body, Field F, class Function>
void set_random(Body& body, F field, unsigned seed, Function const& function) {
  using P = typename Body::policy;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  auto const one = [&] { return uniform(random); };
  std::vector<value_t<P, F>> values;
  for (int i = 0; i < body.size(); ++i) values.push_back(as_value<P, F>(function(one)));
  body.from_host(field, values);
}
/// A number of random entries, times a scale.
template <int N>
auto random_entries(double scale) {
  return [scale](auto const& one) {
    Vec<N, double> v;
    for (int a = 0; a < N; ++a) v[a] = scale * one();
    return v;
  };
}

/// A strongly disordered body with particles of different mass and density.
template <class P, class... Fs>
auto disordered() {
  using namespace fields;
  auto body = body_of<P, Density, Velocity, Stress, Acceleration, Fs...>(lattice<P::dim>(0.125, 0.4), 1);
  set_random(body, volume, 1, [](auto const& one) { return std::pow(0.125, P::dim) * (1 + 0.3 * one()); });
  set_random(body, density, 2, [](auto const& one) { return 1000 * (1 + 0.2 * one()); });
  set_random(body, velocity, 3, random_entries<P::dim>(1));
  set_random(body, stress, 4, random_entries<symmetric3_size<P::dim>>(1e3));
  return body;
}

/// Sums over all particles: the total of m a and of m |a| (N), and of m u . a (W).
struct Balance {
  double force = 0, forces = 0, power = 0;
};
template <class Body>
Balance balance_of(Body const& body) {
  using namespace fields;
  constexpr int dim = Body::policy::dim;
  auto const V = body.to_host(volume), rho = body.to_host(density);
  auto const u = body.to_host(velocity), a = body.to_host(acceleration);
  Vec<dim, double> total = Vec<dim, double>::Zero();
  Balance balance;
  for (std::size_t i = 0; i < V.size(); ++i) {
    Vec<dim, double> const force = double(V[i]) * double(rho[i]) * a[i].template cast<double>();
    total += force;
    balance.forces += force.norm();
    balance.power += force.dot(u[i].template cast<double>());
  }
  balance.force = total.norm();
  return balance;
}

}  // namespace scree::test
