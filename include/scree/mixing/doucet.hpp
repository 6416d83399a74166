// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/principal.hpp"
#include "../pairs/for_each_particle.hpp"
#include "../passes/sums.hpp"
#include "kinds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace scree {

/// The position of a particle when mark_start() was called; zero for particles that were added later. A formulation
/// needs `using carries = Fields<StartPosition>`.
struct StartPosition : Vector<"start position", "m"> {
  static constexpr bool may_stay_zero = true;
};

namespace fields {
inline constexpr StartPosition start_position{};
}  // namespace fields

/// The correlation between the current and the initial positions of particles.
template <int Dim>
struct DoucetIndex {
  double index = std::numeric_limits<double>::quiet_NaN();      ///< 1: as at the start, 0: no correlation
  double published = std::numeric_limits<double>::quiet_NaN();  ///< the published index, for untransformed coordinates
  Vec<Dim, double> direction = zero<Vec<Dim, double>>();        ///< unit vector of the largest correlation
  Mat<Dim, double> correlations = zero<Mat<Dim, double>>();     ///< of each current with each initial coordinate
  double share = 0;  ///< share of the current volume that was present at the mark
};

namespace detail {

/// Whether a particle was present at the mark. True for a position that is not finite, so that the sum is rejected.
template <class X>
SCREE_FN bool was_marked(X const& start) {
  for (int a = 0; a < X::RowsAtCompileTime; ++a)
    if (!(start[a] == 0)) return true;
  return false;
}
/// An update that stores the position of a particle. At the origin, the first coordinate becomes the smallest number
/// above zero, because zero means "not marked".
struct TakeStart {
  using reads = Fields<Position>;
  using writes = Fields<StartPosition>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    auto x = i[fields::position];
    using Real = std::remove_cvref_t<decltype(x[0])>;
    if (!was_marked(x)) x[0] = Kokkos::Experimental::norm_min_v<Real>;
    out[fields::start_position] = x;
  }
};

/// The contributions of a particle to sums: V, V x and V x_0 if the particle was present at the mark; otherwise V, in a
/// sum of its own.
template <int Dim>
struct StartMeans {
  static constexpr int count = 2 + 2 * Dim;
  using reads = Fields<Volume, Position, StartPosition>;
  template <class I>
  SCREE_FN Vec<count, double> operator()(I const& i) const {
    using namespace fields;
    Vec<count, double> terms;
    double const V = was_marked(i[start_position]) ? double(i[volume]) : 0;
    terms[0] = V, terms[1 + 2 * Dim] = V > 0 ? 0 : double(i[volume]);
    for (int a = 0; a < Dim; ++a) {
      terms[1 + a] = V * double(i[position][a]);
      terms[1 + Dim + a] = V * double(i[start_position][a]);
    }
    return terms;
  }
};
/// V times the products of the deviations of all coordinates from their means, x before x_0: the upper triangle, row by
/// row.
template <int Dim>
struct StartProducts {
  static constexpr int count = Dim * (2 * Dim + 1);
  using reads = Fields<Volume, Position, StartPosition>;
  Vec<2 * Dim, double> mean;
  template <class I>
  SCREE_FN Vec<count, double> operator()(I const& i) const {
    using namespace fields;
    Vec<2 * Dim, double> away;
    for (int a = 0; a < Dim; ++a) {
      away[a] = double(i[position][a]) - mean[a];
      away[Dim + a] = double(i[start_position][a]) - mean[Dim + a];
    }
    double const V = was_marked(i[start_position]) ? double(i[volume]) : 0;
    Vec<count, double> terms;
    int k = 0;
    for (int a = 0; a < 2 * Dim; ++a)
      for (int b = a; b < 2 * Dim; ++b) terms[k++] = V * away[a] * away[b];
    return terms;
  }
};

/// Returns the largest eigenvalue of C C^T and its eigenvector.
inline std::pair<double, Vec<3, double>> largest_of_square(Mat<3, double> const& C) {
  auto const found = principal<double>((C * transposed(C)).eval());
  int most = 0;
  for (int a = 1; a < 3; ++a)
    if (found.values[a] > found.values[most]) most = a;
  return {found.values[most], Vec<3, double>(found.axes(0, most), found.axes(1, most), found.axes(2, most))};
}
/// Returns the inverse square root of a covariance matrix; zero for principal axes without variance, apart from
/// rounding errors.
inline Mat<3, double> inverse_root(Mat<3, double> const& covariances) {
  auto const found = principal(covariances);
  double const largest = std::max({found.values[0], found.values[1], found.values[2]});
  auto root = zero<Mat<3, double>>();
  for (int k = 0; k < 3; ++k) {
    if (!(found.values[k] > 1e-10 * largest)) continue;
    Vec<3, double> const axis(found.axes(0, k), found.axes(1, k), found.axes(2, k));
    root += outer(axis / std::sqrt(found.values[k]), axis);
  }
  return root;
}
/// Returns the correlations: covariances divided by the square roots of the variances; zero if a variance is zero.
inline Mat<3, double> correlations_of(Mat<3, double> const& covariances, Mat<3, double> const& of_rows,
                                      Mat<3, double> const& of_columns) {
  auto found = zero<Mat<3, double>>();
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      if (double const scale = std::sqrt(of_rows(a, a) * of_columns(b, b)); scale > 0)
        found(a, b) = covariances(a, b) / scale;
  return found;
}

template <class S>
constexpr bool explain_start() {
  constexpr bool carried = OneOf<StartPosition, typename material_of<S>::fields>;
  static_assert(carried,
                "the material does not carry where its particles were at the start: the formulation needs "
                "`using carries = Fields<StartPosition>`");
  return carried;
}

}  // namespace detail

/// Stores the current positions of the particles as the mark for doucet_index(). Call this at the start of a case, or
/// when a bed has been poured and is at rest. A later call replaces the mark. Checkpoints contain the mark.
template <class S>
void mark_start(S& solver) {
  if constexpr (detail::explain_start<S>())
    for_each_particle<typename detail::material_of<S>::policy>("scree::mark_start", solver.material(),
                                                               detail::TakeStart{});
}

/// Returns the index of Doucet, Bertrand & Chaouki (2008) for mixing in the weak sense, which needs no concentration:
/// the largest eigenvalue of C C^T, where C is the matrix of the correlations between the current coordinates of the
/// particles and their coordinates at mark_start(). `published` is this eigenvalue divided by its value at the start.
/// `published` changes, to at most the number of coordinates, when a bed that is wider than deep rotates without
/// mixing. `index` uses coordinates that are transformed to be uncorrelated and of equal variance, now and at the
/// start: it is the largest squared canonical correlation. `index` does not depend on the axes, lies within [0, 1], and
/// is 1 as long as some coordinate is a linear function of the initial coordinates, as after any rotation or shear. If
/// the particles have mixed in all directions but one, `index` is 1 and `direction` is that direction. For N particles
/// at random positions, `index` is about 1/N.
///
/// Particles are weighted by volume. Only particles that were present at the mark and are still present are included:
/// particles that were added later or entered through an inlet are excluded until the next mark, and particles that
/// have left are excluded. `share` is the included share of the volume. If no particle is included, `index` and
/// `published` are NaN. A coordinate that is the same for all particles has zero correlations. Along a periodic axis
/// the index is meaningless, because coordinates jump at the ends of the period. The sums are computed on the device
/// and are bitwise identical on any number of ranks (WholeBody). Throws std::runtime_error if a position is not finite,
/// and std::invalid_argument if mark_start() was never called.
template <class S>
auto doucet_index(S const& solver) {
  constexpr int dim = S::policy::dim;
  DoucetIndex<dim> found;
  if constexpr (detail::explain_start<S>()) {
    char const* const what = "the index of Doucet";
    auto const means = sums_over(solver.whole(), detail::StartMeans<dim>{}, what);
    double const others = means[1 + 2 * dim];
    if (!(means[0] > 0) && others > 0 && solver.turnover().removed == 0)
      throw std::invalid_argument(
          "scree: doucet_index() compares places with those at mark_start(solver), which has not been called");
    if (!(means[0] > 0)) return found;
    found.share = means[0] / (means[0] + others);
    detail::StartProducts<dim> products{{}};
    for (int a = 0; a < 2 * dim; ++a) products.mean[a] = means[1 + a] / means[0];
    auto const sums = sums_over(solver.whole(), products, what);
    auto now = zero<Mat<3, double>>(), start = now, between = now;  // covariances times the volume
    int k = 0;
    for (int a = 0; a < 2 * dim; ++a)
      for (int b = a; b < 2 * dim; ++b, ++k) {
        if (b < dim)
          now(a, b) = now(b, a) = sums[k];
        else if (a < dim)
          between(a, b - dim) = sums[k];
        else
          start(a - dim, b - dim) = start(b - dim, a - dim) = sums[k];
      }
    auto const correlations = detail::correlations_of(between, now, start);
    auto const root = detail::inverse_root(now);
    auto const [largest, axis] = detail::largest_of_square((root * between * detail::inverse_root(start)).eval());
    found.index = largest;
    found.published = detail::largest_of_square(correlations).first /
                      detail::largest_of_square(detail::correlations_of(start, start, start)).first;
    Vec<3, double> const along = root * axis;
    for (int a = 0; a < dim; ++a) {
      found.direction[a] = norm(along) > 0 ? along[a] / norm(along) : 0;
      for (int b = 0; b < dim; ++b) found.correlations(a, b) = correlations(a, b);
    }
  }
  return found;
}

}  // namespace scree
