// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "granular.hpp"

#include <scree/integrators/symplectic_euler.hpp>
#include <scree/openings/regions.hpp>
#include <scree/setup/setup.hpp>

#include <cmath>
#include <vector>

// Sand in 3D with default models, for cases that take minutes on a GPU.
namespace scree::test::sand3d {

using X = Vec<3, double>;

struct Sand : Formulation<3> {
  using physics = Granular<>;
  using integrator = SymplecticEuler;
};

/// Points for which a condition holds.
template <class Condition>
std::vector<X> kept(std::vector<X> points, Condition const& condition) {
  std::erase_if(points, [&](X const& x) { return !condition(x); });
  return points;
}

/// The slope of a straight line through points, by least squares.
inline double slope_of(std::vector<double> const& x, std::vector<double> const& y) {
  double n = double(x.size()), a = 0, b = 0, aa = 0, ab = 0;
  for (std::size_t k = 0; k < x.size(); ++k) a += x[k], b += y[k], aa += x[k] * x[k], ab += x[k] * y[k];
  return (n * ab - a * b) / (n * aa - a * a);
}
/// The exponent of a power law through points.
inline double exponent(std::vector<double> x, std::vector<double> y) {
  for (auto* const all : {&x, &y})
    for (double& value : *all) value = std::log(value);
  return slope_of(x, y);
}

}  // namespace scree::test::sand3d
