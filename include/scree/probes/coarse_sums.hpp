// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/finite.hpp"
#include "../core/fixed_point.hpp"
#include "../core/loop.hpp"
#include "../fields/columns.hpp"
#include "../fields/particles.hpp"
#include "../kernels/kernel.hpp"
#include "../system/periodic.hpp"
#include "coarse_grid.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// Sums over particles at the points of a grid: each particle contributes to the points within its support. The sums are
// integers, so the order of summation does not matter.
namespace scree::detail {

/// The points of a grid on the device.
template <int Dim>
struct GridPoints {
  double low[Dim], cell[Dim], period[Dim];  // m; `low`: first point; `period`: 0 if there is none
  int number[Dim];

  GridPoints(CoarseGrid<Dim> const& grid, std::vector<Period> const& periods) {
    auto const numbers = grid.cells();
    for (int axis = 0; axis < Dim; ++axis) {
      low[axis] = grid.box.low[axis] + grid.cell[axis] / 2;
      cell[axis] = grid.cell[axis];
      number[axis] = numbers[std::size_t(axis)];
      period[axis] = 0;
    }
    for (Period const& each : periods) period[each.axis] = each.high - each.low;
  }

  /// Calls f(point, offset) for each point within `reach` (m) of x, or of a periodic image of x, along each axis.
  /// `offset` is the vector (m) from the point to x or its image.
  template <class F>
  SCREE_FN void for_each_near(Vec<Dim, double> const& x, double reach, F const& f) const {
    Vec<Dim, double> image = x;
    visit<Dim - 1>(x, reach, image, 0, f);
  }

 private:
  template <int Axis, class F>
  SCREE_FN void visit(Vec<Dim, double> const& x, double reach, Vec<Dim, double>& offset, int point, F const& f) const {
    double const last = low[Axis] + (number[Axis] - 1) * cell[Axis], L = period[Axis];
    int const from = L > 0 ? int(Kokkos::ceil((low[Axis] - reach - x[Axis]) / L)) : 0;
    int const to = L > 0 ? int(Kokkos::floor((last + reach - x[Axis]) / L)) : 0;
    for (int shift = from; shift <= to; ++shift) {
      double const place = x[Axis] + shift * L;
      double const first_near = Kokkos::ceil((place - reach - low[Axis]) / cell[Axis]);
      double const last_near = Kokkos::floor((place + reach - low[Axis]) / cell[Axis]);
      int const end = int(Kokkos::fmin(last_near, double(number[Axis] - 1)));
      for (int k = int(Kokkos::fmax(first_near, 0.0)); k <= end; ++k) {
        offset[Axis] = place - (low[Axis] + k * cell[Axis]);
        if constexpr (Axis == 0)
          f(point * number[0] + k, offset);
        else
          visit<Axis - 1>(x, reach, offset, point * number[Axis] + k, f);
      }
    }
  }
};

/// The value 1 for each particle.
struct One {
  static constexpr int components = 1;
  SCREE_FN double operator()(int, int) const { return 1; }
};
template <class Value>
constexpr int components_of() {
  if constexpr (std::is_arithmetic_v<Value>)
    return 1;
  else
    return int(Value::SizeAtCompileTime);
}
/// The components of the value of a particle.
template <class Element, class Value>
struct ValuesOf {
  static constexpr int components = components_of<Value>();
  Span<Element> values;
  SCREE_FN double operator()(int i, int component) const {
    if constexpr (std::is_arithmetic_v<Value>)
      return double(values(i));
    else
      return double(value_of(values(i)).data()[component]);
  }
};

/// A reducer for the largest magnitude of a component; infinity if a component is NaN.
template <class Read>
struct LargestComponent {
  struct value_type {
    double largest;
  };
  Read read;
  SCREE_FN void init(value_type& found) const { found.largest = 0; }
  SCREE_FN void join(value_type& found, value_type const& other) const {
    found.largest = Kokkos::max(found.largest, other.largest);
  }
  SCREE_FN void operator()(int i, value_type& found) const {
    for (int c = 0; c < Read::components; ++c)
      found.largest = Kokkos::max(found.largest, or_infinity(Kokkos::abs(read(i, c))));
  }
};

/// Returns the number of monomials of y up to a degree, in the order 1, y_0, y_1, ..., y_0 y_0, y_0 y_1, ....
template <int Dim>
constexpr int monomials_up_to(int degree) {
  return degree == 0 ? 1 : degree == 1 ? 1 + Dim : 1 + Dim + symmetric_size<Dim>;
}

/// A kernel that adds w X y^m of each particle to the points around it, for all components of X and the monomials y^m
/// up to a degree. Here w is V W, and y is the offset divided by the support.
template <class P, class Read, int Degree>
struct AddToPoints {
  static constexpr int dim = P::dim, monomials = monomials_up_to<dim>(Degree), count = Read::components * monomials;
  GridPoints<dim> points;
  KernelFunction<typename P::kernel, dim, double> kernel;
  Column<P, Position> x;
  Column<P, Volume> volume;
  Read read;
  FixedPoint unit;
  Span<std::int64_t> sums;

  SCREE_FN void operator()(int i) const {
    auto const here = value_of(x(i));
    Vec<dim, double> place;
    for (int axis = 0; axis < dim; ++axis) place[axis] = double(here[axis]);
    double const R = kernel.radius(), V = double(volume(i));
    points.for_each_near(place, R, [&](int point, Vec<dim, double> const& offset) {
      double const r = norm(offset);
      if (!(r < R)) return;
      double const w = V * kernel.value(r);
      double y[monomials];
      y[0] = 1;
      if constexpr (Degree > 0)
        for (int a = 0; a < dim; ++a) y[1 + a] = offset[a] / R;
      if constexpr (Degree > 1) {
        int k = 1 + dim;
        for (int a = 0; a < dim; ++a)
          for (int b = a; b < dim; ++b) y[k++] = y[1 + a] * y[1 + b];
      }
      std::int64_t* const to = &sums(point * count);
      for (int c = 0; c < Read::components; ++c)
        for (int m = 0; m < monomials; ++m)
          Kokkos::atomic_add(to + c * monomials + m, unit.whole(w * read(i, c) * y[m]));
    });
  }
};

/// The sums at the points of a grid over the particles of all ranks, in the order of points, then components, then
/// monomials.
template <class P>
class CoarseSums {
 public:
  template <class S>
  CoarseSums(S const& solver, CoarseGrid<P::dim> const& grid)
      : points_(grid, solver.settings().periods),
        kernel_(grid.width > 0 ? grid.width : solver.resolution().smoothing_length),
        size_(grid.size()),
        largest_weight_(largest(solver,
                                ValuesOf<std::remove_reference_t<decltype(*solver.material().column(Volume{}).data())>,
                                         typename P::real>{solver.material().column(Volume{})},
                                "volume") *
                        kernel_.value(0)) {
    for (Period const& period : solver.settings().periods)
      check_setting(2 * kernel_.radius() <= period.high - period.low, "width (m) of a coarse grid", kernel_.h(),
                    "so small that two supports fit into each period");
  }

  template <int Degree, class S, class Read>
  std::vector<double> of(S const& solver, Read const& read, char const* name) const {
    using Add = AddToPoints<P, Read, Degree>;
    auto const& body = solver.material();
    FixedPoint const unit(largest_weight_ * largest(solver, read, name), double(solver.whole().size()));
    std::size_t const count = size_ * std::size_t(Add::count);
    checked_count(count);
    Array<P, std::int64_t> const sums(body.space(), "scree::coarse_sums", count);
    for_each_index(body.space(), "scree::coarse_sums", 0, body.size(),
                   Add{points_, kernel_, body.column(Position{}), body.column(Volume{}), read, unit, sums});
    std::vector<double> values;
    values.reserve(count);
    for (std::int64_t const sum : solver.whole().sum(scree::values_of(sums))) values.push_back(unit.value(sum));
    return values;
  }
  double support() const { return kernel_.radius(); }

 private:
  template <class S, class Read>
  static double largest(S const& solver, Read const& read, char const* name) {
    auto const& body = solver.material();
    double const here =
        reduce(body.space(), "scree::largest_component", body.size(), LargestComponent<Read>{read}).largest;
    double const found = solver.whole().largest(here);
    if (!std::isfinite(found))
      throw std::runtime_error("scree: " + std::string(name) + " cannot be coarse-grained: a value is not finite");
    return found;
  }

  GridPoints<P::dim> points_;
  KernelFunction<typename P::kernel, P::dim, double> kernel_;
  std::size_t size_;
  double largest_weight_;
};

}  // namespace scree::detail
