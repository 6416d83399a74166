// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../kernels/kernel.hpp"

namespace scree {

/// The geometry of a pair of particles and the kernel: everything that a term may need besides fields.
template <class P>
class Pair {
 public:
  using real = typename P::real;
  using vector = Vec<P::dim, real>;

  vector x;  ///< x_i - x_j, m
  real r;    ///< |x|, m; zero for the pair of a particle with itself

  /// Takes x_i - x_j (m), the distance of the two particles (m) and the kernel.
  SCREE_FN Pair(vector const& x_ij, real distance, kernel_of<P> const& kernel)
      : x(x_ij), r(distance), kernel_(kernel) {}

  /// Returns the smoothing length, m.
  SCREE_FN real h() const { return kernel_.h(); }
  /// Returns the radius of the support, m.
  SCREE_FN real support() const { return kernel_.radius(); }
  /// Returns W(r), 1/m^dim.
  SCREE_FN real W() const { return kernel_.value(r); }
  /// Returns W at another distance (m) within the support, 1/m^dim.
  SCREE_FN real W_at(real distance) const { return kernel_.value(distance); }
  /// Returns (dW/dr)/r (1/m^(dim + 2)), which is never positive.
  SCREE_FN real slope() const { return kernel_.slope_over_distance(r); }
  /// Returns the gradient of W with respect to x_i (1/m^(dim + 1)), which points from i towards j.
  SCREE_FN vector gradW() const { return slope() * x; }

 private:
  kernel_of<P> const& kernel_;
};

}  // namespace scree
