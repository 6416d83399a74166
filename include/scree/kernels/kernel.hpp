// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/types.hpp"

#include <concepts>

namespace scree {

/// The shape of a smoothing kernel as a function of the dimensionless distance q = r/h:
///   support          the radius of the support in units of h
///   w(q)             the shape, for 0 <= q <= support
///   dw_over_q(q)     (dw/dq)/q, finite at q = 0, so that a gradient needs no division by the distance
///   sigma<Dim>()     the normalisation constant with which W(r, h) = sigma / h^Dim w(r/h) integrates to one
///   takes_packs      optional: whether the functions accept packs of several numbers, see core/pack.hpp
///   name             optional: the name of the kernel in snapshots, instead of the class name with its namespaces
///                    and arguments. A run continues from a snapshot only with a kernel of the same name
template <class K>
concept SmoothingKernel = requires(double q, float p) {
  { K::support } -> std::convertible_to<double>;
  { K::w(q) } -> std::same_as<double>;
  { K::w(p) } -> std::same_as<float>;
  { K::dw_over_q(q) } -> std::same_as<double>;
  { K::dw_over_q(p) } -> std::same_as<float>;
  { K::template sigma<1>() } -> std::convertible_to<double>;
  { K::template sigma<2>() } -> std::convertible_to<double>;
  { K::template sigma<3>() } -> std::convertible_to<double>;
};

/// A kernel with smoothing length h (m) in Dim dimensions. The distances passed to its functions must lie within the
/// support.
template <SmoothingKernel K, int Dim, class Real>
class KernelFunction {
 public:
  /// Makes a kernel with the smoothing length h, m.
  explicit KernelFunction(double h)
      : h_(Real(h)),
        inverse_h_(Real(1 / h)),
        value_factor_(Real(K::template sigma<Dim>() / math::power<Dim>(h))),
        gradient_factor_(Real(K::template sigma<Dim>() / math::power<Dim + 2>(h))) {}

  /// Converts a kernel from another number type.
  template <class Other>
  explicit KernelFunction(KernelFunction<K, Dim, Other> const& other)
      : h_(other.h_),
        inverse_h_(other.inverse_h_),
        value_factor_(other.value_factor_),
        gradient_factor_(other.gradient_factor_) {}

  /// Returns the smoothing length, m.
  SCREE_FN Real h() const { return h_; }
  /// Returns the radius of the support, m.
  SCREE_FN Real radius() const { return Real(K::support) * h_; }
  /// Returns W(r), 1/m^Dim.
  SCREE_FN Real value(Real r) const { return value_factor_ * K::w(r * inverse_h_); }
  /// Returns (dW/dr)/r, 1/m^(Dim + 2). Multiplied by $x_{ij}$, this is the gradient of W with respect to x_i.
  SCREE_FN Real slope_over_distance(Real r) const { return gradient_factor_ * K::dw_over_q(r * inverse_h_); }

 private:
  template <SmoothingKernel, int, class>
  friend class KernelFunction;

  Real h_, inverse_h_, value_factor_, gradient_factor_;
};

/// The kernel function of a policy.
template <class P>
using kernel_of = KernelFunction<typename P::kernel, P::dim, typename P::real>;

/// Returns $\sum V W$ over an infinite cubic lattice with a lattice point at the centre of the kernel; the sum is close
/// to 1.
template <SmoothingKernel K, int Dim, class Real>
double kernel_sum_of_lattice(KernelFunction<K, Dim, Real> const& kernel, double spacing) {
  int const reach = static_cast<int>(double(kernel.radius()) / spacing) + 1;
  int const depth = Dim == 3 ? reach : 0;
  double sum = 0;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y)
      for (int z = -depth; z <= depth; ++z) {
        auto const r = Real(spacing * std::sqrt(double(x * x + y * y + z * z)));
        if (r < kernel.radius()) sum += double(kernel.value(r));
      }
  return sum * math::power<Dim>(spacing);
}

/// Returns h times the integral of W over a line (2D) or plane (3D) through its centre, computed by the midpoint rule.
/// The result is the largest value of $\lvert h \sum V \nabla W\rvert$ at a plane surface.
template <SmoothingKernel K, int Dim, class Real>
double surface_asymmetry(KernelFunction<K, Dim, Real> const& kernel) {
  static_assert(Dim == 2 || Dim == 3);
  constexpr int intervals = 1000;
  double const width = double(kernel.radius()) / intervals;
  double sum = 0;
  for (int k = 0; k < intervals; ++k) {
    double const r = (k + 0.5) * width;
    sum += double(kernel.value(Real(r))) * (Dim == 2 ? 2 : 6.28318530717958648 * r) * width;
  }
  return double(kernel.h()) * sum;
}

namespace detail {
/// Returns the normalisation constant for Dim dimensions.
template <int Dim>
constexpr double by_dimension(double one, double two, double three) {
  static_assert(Dim >= 1 && Dim <= 3);
  return Dim == 1 ? one : Dim == 2 ? two : three;
}
}  // namespace detail

}  // namespace scree
