// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "closure.hpp"

#include <algorithm>

namespace shear_box::reference {

/// One end of an edge between two cells: its concentration and its V F.
struct EdgeEnd {
  double C;
  double percolation;
};

/// Flux between two cells of spacing h, at the mean shear rate, positive downwards (small grains percolate down):
///   D (C_up - C_low)/h + ((V F)_up + (V F)_low)/2
/// Central, and so second-order. A cell stays in [0, 1] if D >= h V A/2, because V F <= V A C and V F <= V A (1 - C): a
/// smaller D (cell Peclet number above 2/A) is raised to this value, which no longer happens once the cells are small
/// enough.
template <class Closure>
struct EdgeFlux {
  Problem<Closure> problem;
  double h;

  double lowest_diffusivity(double C) const { return 0.5 * h * problem.flux.amplitude * problem.closure.velocity(C); }

  double downwards(EdgeEnd upper, EdgeEnd lower) const {
    double const floor = std::max(lowest_diffusivity(upper.C), lowest_diffusivity(lower.C));
    double const D = std::max(problem.closure.diffusivity(0.5 * (upper.C + lower.C)), floor);
    return D / h * (upper.C - lower.C) + 0.5 * (upper.percolation + lower.percolation);
  }

  double sideways(double from, double to) const {
    return problem.closure.diffusivity(0.5 * (from + to)) / h * (from - to);
  }

  double largest_diffusivity() const {
    double D = 0.0;
    for (int i = 0; i <= 100; ++i)
      D = std::max({D, problem.closure.diffusivity(0.01 * i), lowest_diffusivity(0.01 * i)});
    return D;
  }
};

}  // namespace shear_box::reference
