// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../fields/standard.hpp"
#include "../pairs/term.hpp"

namespace scree {

/// $\sum_j V_j W_{ij}$ over one body, the particle itself included if it belongs to that body; 1 where the support is
/// full.
template <class Body>
struct KernelSum : Labelled<"kernel sum", "1"> {
  template <int Dim, class Real>
  using value = Real;
};

/// $\sum_j V_j \nabla W_{ij}$ over one body: points towards that body's particles; 0 where the support is full.
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

/// The kernel sum and its gradient over one body.
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
/// x/|x|, or zero where |x| is at most `least`.
template <class X>
SCREE_FN X unit_vector(X const& x, typename X::Scalar least = 0) {
  auto const length = norm(x);
  if (!(length > least)) return zero<X>();
  return x / length;
}
}  // namespace math

}  // namespace scree
