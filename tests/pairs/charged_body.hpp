// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "sample_terms.hpp"

#include <support/bodies.hpp>

#include <cmath>

// A body with all fields that the sample terms read and write; the fields they read vary from particle to particle.
namespace scree::test {

template <class P>
using Charged = BodyOf<P, Charge, Temperature, Density, Force, Effort, Potential, Heating, Neighbours>;

double charge_at(auto const& x) { return 1 + 0.5 * std::sin(7 * x[0] + 3 * x[1]); }
double temperature_at(auto const& x) { return 2 - x[0] * x[1]; }
double density_at(auto const& x) { return 1 + x[1]; }

/// From the present positions.
template <class Body>
void charge_up(Body& body) {
  set(body, charge, [](auto const& x) { return charge_at(x); });
  set(body, temperature, [](auto const& x) { return temperature_at(x); });
  set(body, fields::density, [](auto const& x) { return density_at(x); });
}

template <class P>
Charged<P> charged(Points<P::dim> const& points, double volume_of_each) {
  auto body =
      body_of<P, Charge, Temperature, Density, Force, Effort, Potential, Heating, Neighbours>(points, volume_of_each);
  charge_up(body);
  return body;
}

}  // namespace scree::test
