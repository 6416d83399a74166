// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "well_posedness.hpp"

#include <cmath>

namespace scree {

SCREE_BODY std::vector<InertialNumbers> detail::ranges_below_zero(std::function<double(double)> const& ill_posedness) {
  // Returns the inertial number between `ill` and `well` at which a law becomes well-posed.
  auto const neutral = [&](double ill, double well) {
    for (int halving = 0; halving < 40; ++halving) {
      double const middle = std::sqrt(ill * well);
      (ill_posedness(middle) < 0 ? well : ill) = middle;
    }
    return std::sqrt(ill * well);
  };
  constexpr int per_decade = 64, decades = 14;
  std::vector<InertialNumbers> found;
  bool was_well = false;
  double before = 0;
  for (int n = 0; n <= decades * per_decade; ++n) {
    double const I = 1e-8 * std::pow(10.0, double(n) / per_decade);
    bool const is_well = ill_posedness(I) < 0;
    if (is_well && !was_well) found.push_back({.from = n == 0 ? 0 : neutral(before, I)});
    if (!is_well && was_well) found.back().to = neutral(I, before);
    was_well = is_well, before = I;
  }
  return found;
}

}  // namespace scree
