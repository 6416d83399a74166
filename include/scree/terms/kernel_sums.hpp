// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

namespace scree {

/// The kernel sum $\sum_j V_j W_{ij}$ over one body, including the particle itself if it belongs to that body; 1 if the
/// support is full.
template <class Body>
struct KernelSum : Labelled<"kernel sum", "1"> {
  template <int Dim, class Real>
  using value = Real;
};

/// The gradient $\sum_j V_j \nabla W_{ij}$ over one body, which points towards the particles of that body; 0 if the
/// support is full.
template <class Body>
struct KernelGradient : Labelled<"kernel gradient", "1/m"> {
  template <int Dim, class Real>
  using value = Vec<Dim, Real>;
};

namespace fields {
template <class Body>
inline constexpr KernelSum<Body> kernel_sum{};
template <class Body>
inline constexpr KernelGradient<Body> kernel_gradient{};
}  // namespace fields

/// The sums for the kernel sum and its gradient over one body.
template <class Body>
struct KernelSums {
  using reads = Fields<Volume>;
  using adds = Fields<KernelSum<Body>, KernelGradient<Body>>;
  static constexpr bool takes_packs = true;
  static constexpr bool includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    sum[kernel_sum<Body>] += j[volume] * ij.W();
    sum[kernel_gradient<Body>] += j[volume] * ij.gradW();
  }
};

namespace math {
/// Returns x/|x|, or zero if |x| is at most `least`.
template <class X>
SCREE_FN X unit_vector(X const& x, typename X::Scalar least = 0) {
  auto const length = norm(x);
  if (!(length > least)) return zero<X>();
  return x / length;
}
}  // namespace math

}  // namespace scree
