// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <scree/kernels/wendland_c2.hpp>

#include <cmath>

namespace scree::test {

/// Sums over a cubic lattice of spacing 1 with particles of volume 1, for a smoothing length h.
template <int Dim>
struct LatticeSums {
  double value = 0;      // sum W
  double moment = 0;     // sum x_a dW/dx_a, of one axis
  double laplacian = 0;  // -1/2 of the double-sum Laplacian of x_a^2: sum x_a dW/dx_a r^2/(r^2 + h^2/100)

  explicit LatticeSums(double h) {
    KernelFunction<WendlandC2, Dim, double> const W(h);
    int const reach = static_cast<int>(std::ceil(W.radius()));
    for (int a = -reach; a <= reach; ++a)
      for (int b = -reach; b <= reach; ++b)
        for (int c = Dim == 3 ? -reach : 0; c <= (Dim == 3 ? reach : 0); ++c) {
          double const squared = a * a + b * b + c * c, r = std::sqrt(squared);
          if (r >= W.radius()) continue;
          value += W.value(r);
          moment += a * a * W.slope_over_distance(r);
          laplacian += a * a * W.slope_over_distance(r) * squared / (squared + h * h / 100);
        }
  }
};

}  // namespace scree::test
