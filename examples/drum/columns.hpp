// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "state.hpp"

#include <scree/fields/standard.hpp>
#include <scree/segregation/flux.hpp>
#include <scree/terms/gravity.hpp>

#include <vector>

namespace drum {

/// Values of fields as the numbers of a State: compiled once, in columns.cpp, for all models.
template <int Dim, class Real>
struct Columns {
  using vector = scree::Vec<Dim, Real>;
  using stress = typename scree::Stress::template value<Dim, Real>;

  static std::vector<double> doubles(std::vector<Real> const& values);
  /// One component of vectors; axis 0 is x, 1 y (empty in 2D), 2 z.
  static std::vector<double> component(std::vector<vector> const& vectors, int axis);
  /// xx, yy, zz, xy, yz, xz of each particle.
  static std::vector<double> stresses(std::vector<stress> const& given);
  /// The parts of dC/dt of figures 28 and 29: -F ghat . grad V, -V F' ghat . grad C and what remains of the rate of C,
  /// diffusion with the sources of the boundary.
  static void add_rates(State& state, std::vector<vector> const& grad_C, std::vector<vector> const& grad_V,
                        std::vector<Real> const& rate, scree::SegregationFlux const& flux,
                        scree::GravityDirection const& down);
};

}  // namespace drum
