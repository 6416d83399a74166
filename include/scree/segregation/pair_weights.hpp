// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/root.hpp"
#include "../core/symmetric.hpp"
#include "../passes/pass.hpp"
#include "../passes/resolution.hpp"

#include <numbers>

// Weights w_ij = w_ji of pairs of material particles with sum_j V_j w_ij x_ij (x) x_ij = I. Conservative operators are
// based on them: sum_j V_j w_ij (f_i - f_j) approximates minus one half of the Laplacian of f. See
// docs/theory/segregation.md.
namespace scree {

/// The dipole $\sum_j V_j f_{ij} x_{ij}$, which is zero if the neighbours are evenly distributed around i.
struct Dipole : Vector<"dipole of the neighbours", "m"> {};
/// The second moment $\sum_j V_j f_{ij} x_{ij} \otimes x_{ij}$.
struct SecondMoment : Symmetric<"second moment of the neighbours", "m^2"> {};
/// The vector $\lambda_i$, which reduces the dipole of the weights.
struct OddCorrection : Vector<"odd correction of the pair weights", "1/m"> {};
/// The fourth moment $\sum_j V_j f_{ij} c_{ij} x \otimes x \otimes x \otimes x / r^2$, as an operator on symmetric
/// tensors.
struct FourthMoment : SymmetricOperator<"fourth moment of the neighbours", "m^2"> {};
/// The tensor $A_i$, which makes the second moment of the weights the identity.
struct EvenCorrection : Symmetric<"even correction of the pair weights", "1/m^2"> {};

namespace fields {
inline constexpr Dipole dipole{};
inline constexpr SecondMoment second_moment{};
inline constexpr OddCorrection odd_correction{};
inline constexpr FourthMoment fourth_moment{};
inline constexpr EvenCorrection even_correction{};
}  // namespace fields

namespace pair_weights {

/// Returns the shape $f_{ij} = (1 - r/R)^4$ of the weights within the support R. The corrections set its scale. A shape
/// that is sharper than the slope of the kernel has smaller errors next to walls, but tolerates less disorder.
template <class IJ>
SCREE_FN auto shape(IJ const& ij) {
  return math::power<4>(1 - ij.r / ij.support());
}

/// Returns $\sum_j V_j f_{ij} r^2$ over a full support of radius R, m^(Dim + 2).
template <int Dim, class Real>
SCREE_FN Real full_trace(Real R) {
  using std::numbers::pi;
  if constexpr (Dim == 2)
    return Real(pi / 140) * math::power<4>(R);
  else
    return Real(2 * pi / 315) * math::power<5>(R);
}

/// Returns $c_{ij} = 1 + (\lambda_i - \lambda_j) \cdot x_{ij}$, limited to 0.1 to 2, so that it is positive.
template <class I, class J, class IJ>
SCREE_FN auto odd_factor(I const& i, J const& j, IJ const& ij) {
  using namespace fields;
  using namespace math;
  using Real = typename IJ::real;
  return min(Real(2), max(Real(0.1), 1 + dot(i[odd_correction] - j[odd_correction], ij.x)));
}

/// Returns the weight $w_{ij} = f_{ij} c_{ij} \hat x \cdot (A_i + A_j)/2 \hat x$, m^-(Dim + 2).
template <class I, class J, class IJ>
SCREE_FN auto weight(I const& i, J const& j, IJ const& ij) {
  using namespace fields;
  auto const A = (i[even_correction] + j[even_correction]) / 2;
  return shape(ij) * odd_factor(i, j, ij) * dot(A, square_of(ij.x)) / sq(ij.r);
}

/// The sums for the dipole and for the second moment of the neighbours.
struct DisorderSums {
  using reads = Fields<Volume>;
  using adds = Fields<Dipole, SecondMoment>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const&, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const f = j[volume] * shape(ij);
    sum[dipole] += f * ij.x;
    sum[second_moment] += f * square_of(ij.x);
  }
};

/// Computes the odd correction in one damped step towards weights without a dipole: lambda = -0.8 M^{-1} E with the
/// dipole E and the isotropic part of the second moment M. The correction is zero if part of the support is empty,
/// because the dipole is then not due to disorder.
struct SolveOddCorrection {
  double radius;  ///< radius of the support, m
  using reads = Fields<>;
  using writes = Fields<OddCorrection>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace fields;
    using vector = typename O::template type<OddCorrection>;
    using Real = typename vector::Scalar;
    constexpr int dim = vector::RowsAtCompileTime;
    Real const trace = dot(total[second_moment], symmetric_identity<dim, Real>());
    bool const full = trace > Real(0.9) * full_trace<dim>(Real(radius));
    out[odd_correction] = full ? total[dipole] * (Real(-0.8) * dim / trace) : zero<vector>();
  }
};

/// The sum for the fourth moment of the neighbours.
struct FourthMomentSum {
  using reads = Fields<Volume, OddCorrection>;
  using adds = Fields<FourthMoment>;
  static constexpr bool takes_packs = true;
  template <class I, class J, class IJ, class S>
  SCREE_FN void operator()(I const& i, J const& j, IJ const& ij, S& sum) const {
    using namespace fields;
    auto const xx = square_of(ij.x);
    sum[fourth_moment] += outer((j[volume] * shape(ij) * odd_factor(i, j, ij) / sq(ij.r)) * xx, xx);
  }
};

/// Computes the even correction A from M : A = I with the fourth moment M. The relative deviation of A from the
/// isotropic solution is limited to 0.8, so that all weights are positive: in a corner, where all neighbours are in one
/// quadrant, no positive weights have the right second moment. The isotropic solution itself is bounded for particles
/// that have almost no neighbours.
struct SolveEvenCorrection {
  double radius;  ///< radius of the support, m
  using reads = Fields<>;
  using writes = Fields<EvenCorrection>;
  template <class I, class T, class O>
  SCREE_FN void operator()(I const&, T const& total, O& out) const {
    using namespace fields;
    auto const M = total[fourth_moment];
    using Real = typename decltype(M)::Scalar;
    constexpr int n = decltype(M)::RowsAtCompileTime, dim = n == 3 ? 2 : 3;
    Vec<n, Real> const identity = symmetric_identity<dim, Real>();
    Real const trace = dot(identity, M * identity);
    Vec<n, Real> const isotropic = identity * (dim / Kokkos::max(trace, Real(0.1) * full_trace<dim>(Real(radius))));
    Vec<n, Real> A = isotropic;
    if (solve_positive_definite<n, Real>(M, identity, Real(1e-4), A)) {
      Real const most = Real(0.8) * isotropic[0], deviation = norm(A - isotropic);
      if (deviation > most) A = isotropic + (A - isotropic) * (most / deviation);
    }
    out[even_correction] = A;
  }
};

/// Returns the passes that compute both corrections. Wall particles, if any, contribute to the odd correction only.
inline auto passes(Resolution const& resolution) {
  return std::tuple(pair_pass_then<Material>("scree::odd_correction", SolveOddCorrection{resolution.support},
                                             over<Material>(DisorderSums{}), over<Wall>(DisorderSums{})),
                    pair_pass_then<Material>("scree::even_correction", SolveEvenCorrection{resolution.support},
                                             over<Material>(FourthMomentSum{})));
}

}  // namespace pair_weights
}  // namespace scree
