// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "../core/symmetric.hpp"
#include "../passes/pass.hpp"
#include "../terms/shepard.hpp"

#include <concepts>
#include <tuple>
#include <type_traits>

// Each particle integrates its own stress, and the stresses of neighbouring particles drift apart. A stress filter, a
// list of passes that runs at the end of every period-th step, prevents this drift. See docs/theory/granular.md.
namespace scree {

/// Yielding of a particle since the last filtering: the sum of the reductions of $\sqrt{J_2}$ by the law, divided by
/// the bulk modulus. The yielding equals the plastic shear strain times G/K.
struct Yielding : Scalar<"yielding since the last filter", "1"> {};

namespace fields {
inline constexpr Yielding yielding{};
}  // namespace fields

/// A stress filter is a struct with these members:
///   period    number of steps from one run of the filter to the next, 1 or more; checked by Granular
///   history   fields that accumulate between runs: Fields<Yielding> or Fields<>
///   passes()  tuple of passes of the filter
template <class F>
concept StressFilter = requires(F const& filter) {
  typename F::history;
  requires std::is_same_v<typename F::history, Fields<>> || std::is_same_v<typename F::history, Fields<Yielding>>;
  { filter.period } -> std::convertible_to<int>;
  std::tuple_size<decltype(filter.passes())>::value;
};

/// The stress filter that leaves the stress of the constitutive law unchanged.
struct NoFilter {
  int period = 1;
  using history = Fields<>;
  std::tuple<> passes() const { return {}; }
};

namespace detail {
struct TakeSmoothedStress {
  using reads = Fields<Smoothed<Stress>>;
  using writes = Fields<Stress>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    out[fields::stress] = i[Smoothed<Stress>{}];
  }
};
}  // namespace detail

/// Stress filter by the Shepard mean, $\sigma_i = \sum_j \sigma_j V_j W_{ij}/\sum_j V_j W_{ij}$: Zhu et al. (2024), eq.
/// 3.12. At boundaries of the material the mean is one-sided and reduces the load on the lowest rows, so that a bed
/// creeps.
struct ShepardFilter {
  int period = 30;
  using history = Fields<>;
  static constexpr auto parameters() {
    return std::array{parameter("period", &ShepardFilter::period, "steps", "steps from one filtering to the next",
                                allowed::at_least(1))};
  }
  auto passes() const {
    return std::tuple(
        pair_pass_then<Material>("scree::shepard_filter", ShepardMean<Stress>{}, over<Material>(ShepardSums<Stress>{})),
        point_pass<Material>("scree::take_smoothed", detail::TakeSmoothedStress{}));
  }
};

namespace linear_filter {

/// The moments of the kernel, $\sum_j V_j W_{ij} b b^T$ with $b = (1, x_{ij}/h)$.
struct Moments : Labelled<"moments of the kernel", "1"> {
  template <int Dim, class Real>
  using value = Mat<Dim + 1, Real>;
};
/// The moments of the stress, $\sum_j V_j W_{ij} b \sigma_j^T$ with $b = (1, x_{ij}/h)$.
struct StressMoments : Labelled<"moments of the stress", "Pa"> {
  template <int Dim, class Real>
  using value = Small<Real, Dim + 1, symmetric3_size<Dim>>;
};

/// Pair term for the sums over neighbours for the fit of a linear function to the stress.
struct Sums {
  using reads = Fields<Volume, Stress>;
  using adds = Fields<Moments, StressMoments>;
  static constexpr bool takes_packs = true;
  static constexpr bool includes_self = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    using Real = typename IJ::real;
    auto const b = joined(Real(1), ij.x / ij.h());
    Real const w = j[volume] * ij.W();
    sum[Moments{}] += outer(w * b, b);
    sum[StressMoments{}] += outer(w * b, j[stress]);
  }
};

/// Condition that a particle has yielded since the last filtering.
struct Yielded {
  using reads = Fields<Yielding>;
  template <class I>
  SCREE_FN bool operator()(I const& i) const {
    return i[fields::yielding] > 0;
  }
};

/// Moves the stress of a particle towards the fitted value at its position. A particle keeps its stress if no linear
/// function can be fitted to its neighbours.
struct Fit {
  double full_at;
  using reads = Fields<Stress, Yielding>;
  using writes = Fields<Smoothed<Stress>>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const& i, T const& total, O& out) const {
    using namespace fields;
    using Matrix = std::remove_cvref_t<decltype(total[Moments{}])>;
    using Real = typename Matrix::Scalar;
    using Packed = std::remove_cvref_t<decltype(i[stress])>;
    constexpr int n = Matrix::RowsAtCompileTime;
    Vec<n, Real> at_centre = zero<Vec<n, Real>>(), weights;
    at_centre[0] = 1;
    out[Smoothed<Stress>{}] = i[stress];
    if (!solve_positive_definite<n, Real>(total[Moments{}], at_centre, Real(1e-3), weights)) return;
    Packed const fitted = transposed(total[StressMoments{}]) * weights;
    Real const share = Kokkos::min(Real(1), i[yielding] / Real(full_at));
    out[Smoothed<Stress>{}] += share * (fitted - i[stress]);
  }
};

/// Replaces the stress of a particle by the smoothed stress and sets its yielding to zero.
struct TakeFittedStress {
  using reads = Fields<Smoothed<Stress>>;
  using writes = Fields<Stress, Yielding>;
  template <class I, class O>
  SCREE_FN void operator()(I const& i, O& out) const {
    using namespace fields;
    out[stress] = i[Smoothed<Stress>{}];
    out[yielding] = 0;
  }
};

}  // namespace linear_filter

/// Stress filter that moves the stress of a particle towards the value at x_i of a linear function fitted to the stress
/// of the neighbours with weights $V_j W_{ij}$. The change is proportional to the yielding since the last filtering; if
/// the yielding is `full_at` or more, the fitted value replaces the stress. The stress of material that does not yield
/// is unchanged, so every equilibrium persists, even if the stress is not linear in the position.
struct LinearFilter {
  int period = 30;
  double full_at = 1e-4;
  using history = Fields<Yielding>;
  static constexpr auto parameters() {
    return std::array{
        parameter("period", &LinearFilter::period, "steps", "steps from one filtering to the next",
                  allowed::at_least(1)),
        parameter("full_at", &LinearFilter::full_at, "1",
                  "yielding from which on the fitted stress replaces the own one", allowed::above_or_infinite(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const { check_parameters(*this, "LinearFilter"); }
  auto passes() const {
    return std::tuple(pair_pass_where<Material>("scree::linear_filter", linear_filter::Yielded{},
                                                linear_filter::Fit{full_at}, over<Material>(linear_filter::Sums{})),
                      point_pass<Material>("scree::take_fitted", linear_filter::TakeFittedStress{}));
  }
};

}  // namespace scree
