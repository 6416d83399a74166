// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/symmetric.hpp"
#include "coarse_sums.hpp"
#include "sample.hpp"

#include <limits>
#include <type_traits>
#include <utility>

namespace scree {
namespace detail {

template <class P, Field F>
using CoarseValue = Doubled<typename host_value<P, F>::type>;
template <class P, Field F>
struct CoarseSlot {
  std::vector<CoarseValue<P, F>> values;
};

}  // namespace detail

/// Fields at the points of a grid, see coarse_grained(). `found[velocity][k]` is the velocity at the k-th point of
/// `found.grid.points()`.
template <class P, class List>
struct CoarseGrained;
template <class P, class... Fs>
struct CoarseGrained<P, Fields<Fs...>> : detail::CoarseSlot<P, Fs>... {
  CoarseGrid<P::dim> grid;
  double time = 0;             ///< s
  std::vector<double> weight;  ///< $\sum_j V_j W_j$: about 1 inside the material, 1/2 at a plane surface, 0 far away

  /// Returns the values of a field, which are NaN at points of weight 0.
  template <Field F>
  std::vector<detail::CoarseValue<P, F>> const& operator[](F) const {
    static_assert((std::is_same_v<F, Fs> || ...), "this field was not coarse-grained");
    return static_cast<detail::CoarseSlot<P, F> const&>(*this).values;
  }
  template <Field F>
  std::vector<detail::CoarseValue<P, F>>& operator[](F) {
    return static_cast<detail::CoarseSlot<P, F>&>(*this).values;
  }
};

namespace detail {

/// Returns the value at a point from the sums of w X y^m, component by component, and the moments of w.
template <int Dim, class Value>
Value value_at_point(double const* sums, double const* moments, bool linear) {
  Value value = zero_of<Value>();
  if (!(moments[0] > 0)) return nan_of<Value>();
  constexpr int N = Dim + 1;
  constexpr int components = components_of<Value>();
  Mat<N, double> M;
  int k = N;
  for (int a = 0; a < N; ++a) M(0, a) = M(a, 0) = moments[a];
  for (int a = 1; a < N; ++a)
    for (int b = a; b < N; ++b) M(a, b) = M(b, a) = moments[k++];
  // A single row or plane of particles does not determine how the field varies across it; the variance of the offsets
  // in that direction is then below (0.05 supports)^2.
  double const least = 3e-3;
  for (int c = 0; c < components; ++c) {
    double const* const of_component = sums + c * (linear ? N : 1);
    double found = of_component[0] / moments[0];
    if (linear) {
      Small<double, N, 1> b, fit;
      for (int a = 0; a < N; ++a) b[a] = of_component[a];
      if (solve_positive_definite<N, double, 1>(M, b, least, fit)) found = fit[0];
    }
    if constexpr (std::is_arithmetic_v<Value>)
      value = found;
    else
      value.data()[c] = found;
  }
  return value;
}

/// Returns the values of a field on the device: the column of the particles or, for a derived field, values computed on
/// the host.
template <Field F, class S>
auto device_values(S const& solver) {
  auto const& body = solver.material();
  using Body = std::remove_cvref_t<decltype(body)>;
  static_assert(carries<F, Body>,
                "the material does not carry this field: a field is carried if a pass reads or writes it; for output "
                "alone, name a pass that writes it in `diagnostics`");
  if constexpr (DerivedField<F>) {
    using Value = typename host_value<typename S::policy, F>::type;
    Array<typename Body::policy, Value> const values(body.space(), "scree::derived_field", std::size_t(body.size()));
    copy_into(values, host_values<F>(body, solver.resolution()));
    return values;
  } else {
    return body[F{}];
  }
}

template <Field F, class S, class P>
auto coarse_values(S const& solver, CoarseGrid<S::policy::dim> const& grid, CoarseSums<P> const& sums,
                   std::vector<double> const& moments) {
  constexpr int dim = S::policy::dim;
  using Value = CoarseValue<typename S::policy, F>;
  static_assert(!holds_integers<F>, "the values of this field are integers, which have no mean");
  auto const values = device_values<F>(solver);
  using Element = std::remove_reference_t<decltype(*values.data())>;
  ValuesOf<Element, typename host_value<typename S::policy, F>::type> const read{values.span()};
  std::string const name(F::name);
  auto const found =
      grid.linear ? sums.template of<1>(solver, read, name.c_str()) : sums.template of<0>(solver, read, name.c_str());
  constexpr std::size_t of_moments = monomials_up_to<dim>(2);
  std::size_t const of_field = found.size() / grid.size();
  std::vector<Value> all;
  all.reserve(grid.size());
  for (std::size_t k = 0; k < grid.size(); ++k)
    all.push_back(
        value_at_point<dim, Value>(found.data() + k * of_field, moments.data() + k * of_moments, grid.linear));
  return all;
}

}  // namespace detail

/// Returns fields of the material at the points of a grid, averaged with the kernel:
/// $X = \sum_j X_j V_j W_j/\sum_j V_j W_j$ over the particles within the support, with the `width` of the grid as the
/// smoothing length (Shepard 1968). This mean is exact for constant fields, even at walls and surfaces, and of first
/// order there. With `linear`, the default, X is the value at the point of the linear function that best fits the X_j
/// with the weights $V_j W_j$. This fit is exact for linear fields everywhere, even for disordered particles. The fit
/// may exceed the range of the X_j, and it extrapolates at points beyond the surface, where `weight` is below 1/2. If
/// the particles form a single row, X is the mean.
///
/// Walls do not contribute; periodic images do. A field may be a derived field, such as `pressure`; results of passes
/// belong to the last step, as for mean_at(). Computed on the device, with work proportional to the number of particles
/// times the number of points within a support, and bitwise identical on any number of ranks (WholeBody). Throws
/// std::invalid_argument as CoarseGrid::check() does, and std::runtime_error if a value is not finite.
template <class S, class... Fs>
auto coarse_grained(S const& solver, CoarseGrid<S::policy::dim> const& grid, Fields<Fs...>) {
  using Particles = std::remove_cvref_t<decltype(solver.material())>;
  ProfilingRegion const region("scree::coarse_grained");
  grid.check(solver.resolution().spacing);
  detail::CoarseSums<typename Particles::policy> const sums(solver, grid);
  auto const moments = sums.template of<2>(solver, detail::One{}, "weight");
  CoarseGrained<typename S::policy, Fields<Fs...>> found;
  found.grid = grid;
  found.time = solver.time();
  std::size_t const of_each = moments.size() / grid.size();
  for (std::size_t k = 0; k < grid.size(); ++k) found.weight.push_back(moments[k * of_each]);
  ((found[Fs{}] = detail::coarse_values<Fs>(solver, grid, sums, moments)), ...);
  return found;
}

/// Returns the mean across an axis, weighted by `weight`, on a grid with one cell along this axis. The mean across the
/// width of a three-dimensional channel is a plane; the mean across two axes is a profile. The `weight` of the result
/// is the mean of the weights, that is, the filled share of the width. Throws std::invalid_argument if there is no such
/// axis.
template <class P, class... Fs>
CoarseGrained<P, Fields<Fs...>> averaged_across(int axis, CoarseGrained<P, Fields<Fs...>> const& found) {
  check_setting(axis >= 0 && axis < P::dim, "the axis of a mean", axis, "an axis of space, counted from 0");
  auto const numbers = found.grid.cells();
  std::size_t below = 1;  // stride of the points along the axis
  for (int a = 0; a < axis; ++a) below *= std::size_t(numbers[std::size_t(a)]);
  auto const along = std::size_t(numbers[std::size_t(axis)]);
  CoarseGrained<P, Fields<Fs...>> mean;
  mean.grid = found.grid, mean.time = found.time;
  mean.grid.box.high[axis] = found.grid.box.low[axis] + double(along) * found.grid.cell[axis];
  mean.grid.cell[axis] = mean.grid.box.high[axis] - mean.grid.box.low[axis];
  for (std::size_t k = 0; k < mean.grid.size(); ++k) {
    std::size_t const first = k / below * below * along + k % below;
    double weight = 0;
    for (std::size_t n = 0; n < along; ++n) weight += found.weight[first + n * below];
    mean.weight.push_back(weight / double(along));
    auto const add = [&]<Field F>(F field) {
      auto value = detail::zero_of<detail::CoarseValue<P, F>>();
      for (std::size_t n = 0; n < along; ++n)
        if (double const w = found.weight[first + n * below]; w > 0) value += found[field][first + n * below] * w;
      if (weight > 0)
        value /= weight;
      else
        value = detail::nan_of<detail::CoarseValue<P, F>>();
      mean[field].push_back(value);
    };
    (add(Fs{}), ...);
  }
  return mean;
}

}  // namespace scree
