// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "law.hpp"

namespace scree {

/// Rate of the void ratio.
struct VoidRatioRate : Scalar<"void ratio rate", "1/s"> {};
/// Void ratio e: volume of voids over volume of grains.
struct VoidRatio : Scalar<"void ratio", "1"> {
  using rate = VoidRatioRate;
  static constexpr bool compensated = true;
  static constexpr bool above_zero = true;
};

namespace fields {
inline constexpr VoidRatioRate void_ratio_rate{};
inline constexpr VoidRatio void_ratio{};
}  // namespace fields

/// Limiting and critical void ratios of a sand at a given pressure, dimensionless.
template <class Real>
struct VoidRatios {
  Real densest, critical, loosest;  ///< e_d, e_c, e_i
};

/// The hypoplastic law for sand of von Wolffersdorff (1996). The stress rate is a function of the present stress, the
/// void ratio and the strain rate, without an elastic range or a yield surface; stiffness, peak strength and dilatancy
/// depend on pressure and density. The void ratio e is an internal variable, which must be set at the start. The law is
/// suited to monotonic deformation: under small load cycles it accumulates too much strain. See docs/theory/laws.md for
/// the equations.
struct Hypoplastic {
  double critical_angle = 0;      ///< phi_c
  double granulate_hardness = 0;  ///< h_s
  double exponent = 0;            ///< n
  double e_d0 = 0;
  double e_c0 = 0;  ///< above e_d0
  double e_i0 = 0;  ///< above e_c0
  double alpha = 0;
  double beta = 0;
  double rest_density = 0;  ///< rho
  /// The pressure below which the stiffness is constant, because the law has no stiffness at zero pressure.
  double least_pressure = 10;

  using reads = Fields<>;
  using history = Fields<VoidRatio>;

  static constexpr auto parameters() {
    using H = Hypoplastic;
    return std::array{
        parameter("critical_angle", &H::critical_angle, "rad", "friction angle phi_c in the critical state",
                  ParameterRange{0, 1.5707963, true, true, "above 0 and below pi/2"}),
        parameter("granulate_hardness", &H::granulate_hardness, "Pa", "h_s", allowed::above(0)),
        parameter("exponent", &H::exponent, "1", "n, of the pressure in the void ratios", allowed::between(0, 1)),
        parameter("e_d0", &H::e_d0, "1", "densest void ratio at zero pressure", allowed::above(0)),
        parameter("e_c0", &H::e_c0, "1", "critical void ratio at zero pressure", allowed::above(0, "above e_d0")),
        parameter("e_i0", &H::e_i0, "1", "loosest void ratio at zero pressure", allowed::above(0, "above e_c0")),
        parameter("alpha", &H::alpha, "1", "exponent of the density in peak strength and dilatancy",
                  allowed::at_least(0)),
        parameter("beta", &H::beta, "1", "exponent of the density in the stiffness", allowed::at_least(0)),
        parameter("rest_density", &H::rest_density, "kg/m^3", "density of grains and voids together",
                  allowed::above(0)),
        parameter("least_pressure", &H::least_pressure, "Pa", "pressure below which the stiffness is constant",
                  allowed::above(0))};
  }
  /// Throws std::invalid_argument if a parameter is out of range.
  void check() const {
    check_parameters(*this);
    check_setting(e_c0 > e_d0, "e_c0 (-)", e_c0, "above e_d0");
    check_setting(e_i0 > e_c0, "e_i0 (-)", e_i0, "above e_c0");
    check_setting(normaliser<double>() > 0, "alpha (-)", alpha,
                  "so small that 3 + a^2 > sqrt(3) a ((e_i0 - e_d0)/(e_c0 - e_d0))^alpha");
  }
  SCREE_FN double density() const { return rest_density; }

  /// Returns the void ratios e_d, e_c and e_i at a pressure (Pa), $e = e_0 \exp(-(3 p/h_s)^n)$ (Bauer 1996).
  template <class Real>
  SCREE_FN VoidRatios<Real> void_ratios(Real p) const {
    Real const shrunk =
        Kokkos::exp(-Kokkos::pow(3 * Kokkos::max(p, Real(0)) / Real(granulate_hardness), Real(exponent)));
    return {Real(e_d0) * shrunk, Real(e_c0) * shrunk, Real(e_i0) * shrunk};
  }

  /// Returns a bulk modulus, Pa, between those of isotropic loading and isotropic unloading.
  template <class Real, class Point>
  SCREE_FN Real bulk_modulus(StressTensor<Real> const& sigma, Point const& point) const {
    auto const at = state(sigma, Real(point[fields::void_ratio]));
    return at.stiffness * (sq(at.shape) + sq(at.a) / 3) / 3;
  }
  /// Returns an upper bound, m/s, on the speeds of loading and unloading waves in all directions.
  template <class Real, class Point>
  SCREE_FN Real sound_speed(StressTensor<Real> const& sigma, Point const& point) const {
    auto const at = state(sigma, Real(point[fields::void_ratio]));
    Real const largest = at.largest_ratio;
    Real const modulus = at.stiffness * (sq(at.shape) + sq(at.a * largest) +
                                         at.density_factor * at.a * at.shape * (2 * largest - Real(1) / 3));
    return Kokkos::sqrt(modulus / Real(rest_density));
  }
  template <class Real, class Point>
  SCREE_FN StressTensor<Real> stress_rate(StressTensor<Real> const& sigma, Mat<3, Real> const& L,
                                          Point const& point) const {
    auto const at = state(sigma, Real(point[fields::void_ratio]));
    Mat<3, Real> const D = (L + transposed(L)) / 2, &T = at.ratio;
    Real const work = dot(T, D), size = Kokkos::sqrt(squared_norm(D));
    Real const nonlinear = at.density_factor * at.a * at.shape * size;
    return rate_of_rotation(sigma, L) + at.stiffness * (sq(at.shape) * D + sq(at.a) * work * T +
                                                        nonlinear * (2 * T - identity_matrix<Mat<3, Real>>() / 3));
  }
  /// Sets the rate of the void ratio, $de/dt = (1 + e) \operatorname{tr} D$: grains keep their volume.
  template <class Real, class Point, class Rates>
  SCREE_FN void history_rate(StressTensor<Real> const&, Mat<3, Real> const& L, Point const& point, Rates& rates) const {
    using namespace fields;
    rates[void_ratio_rate] = (1 + Real(point[void_ratio])) * trace(L);
  }
  /// Returns the trial stress, limited to stresses for which the law is valid, that is, for grains in contact: each
  /// principal stress is compressive and at least a hundredth of the pressure. The pressure is limited so that the void
  /// ratio does not exceed e_i; for void ratios above e_i0 the stress is zero.
  template <class Real, class Point, class History>
  SCREE_FN StressTensor<Real> admissible(StressTensor<Real> const& trial, Point const& point, History&&) const {
    Real const p = Kokkos::min(pressure_of(trial), largest_pressure(Real(point[fields::void_ratio])));
    // NaN fails the comparison.
    if (!(p > 0)) return zero<StressTensor<Real>>();
    StressTensor<Real> const s = deviator_of(trial);
    Real const tension = largest_principal(s), most = Real(0.99) * p;
    Real const scale = tension > most ? most / tension : Real(1);
    return scale * s - p * identity_matrix<StressTensor<Real>>();
  }

 private:
  /// The stress divided by its trace, T, and the factors of the law.
  template <class Real>
  struct State {
    StressTensor<Real> ratio;
    Real largest_ratio;   // largest principal value of T
    Real a, shape;        // a, F
    Real density_factor;  // f_d
    Real stiffness;       // f_b f_e/(T : T), Pa
  };

  template <class Real>
  SCREE_FN Real parameter_a() const {
    Real const sin_phi = Kokkos::sin(Real(critical_angle));
    return Kokkos::sqrt(Real(3) / 8) * (3 - sin_phi) / sin_phi;
  }
  /// Returns $3 + a^2 - \sqrt{3} a ((e_{i0} - e_{d0})/(e_{c0} - e_{d0}))^\alpha$.
  template <class Real>
  SCREE_FN Real normaliser() const {
    Real const a = parameter_a<Real>();
    Real const looseness = Kokkos::pow(Real((e_i0 - e_d0) / (e_c0 - e_d0)), Real(alpha));
    return 3 + sq(a) - Kokkos::sqrt(Real(3)) * a * looseness;
  }
  /// Returns -cos(3 theta) of a deviator: 1 if T is in triaxial compression, -1 if it is in triaxial extension.
  template <class Real>
  SCREE_FN static Real lode(Mat<3, Real> const& s) {
    Real const norm2 = squared_norm(s), norm3 = norm2 * Kokkos::sqrt(norm2);
    if (!(norm3 > 0)) return 1;
    Mat<3, Real> const squared = s * s;
    return Kokkos::clamp(Kokkos::sqrt(Real(6)) * dot(squared, s) / norm3, Real(-1), Real(1));
  }
  /// Returns the largest principal value of a deviator.
  template <class Real>
  SCREE_FN static Real largest_principal(Mat<3, Real> const& s) {
    return Kokkos::sqrt(2 * squared_norm(s) / 3) * Kokkos::cos(Kokkos::acos(lode(s)) / 3);
  }
  /// Returns the pressure, Pa, at which a void ratio equals the loosest one, e_i; it is not positive above e_i0.
  template <class Real>
  SCREE_FN Real largest_pressure(Real e) const {
    Real const shrinkage = Kokkos::log(Real(e_i0) / e);
    if (!(shrinkage > 0)) return shrinkage;
    return Real(granulate_hardness) / 3 * Kokkos::pow(shrinkage, 1 / Real(exponent));
  }
  template <class Real>
  SCREE_FN State<Real> state(StressTensor<Real> const& sigma, Real e) const {
    Real const p = Kokkos::max(pressure_of(sigma), Real(least_pressure));
    auto const unit = identity_matrix<StressTensor<Real>>();
    StressTensor<Real> const deviator = deviator_of(sigma) / (-3 * p);

    State<Real> at;
    at.ratio = deviator + unit / 3;
    at.largest_ratio = Real(1) / 3 + largest_principal(deviator);
    at.a = parameter_a<Real>();
    Real const tan_psi = Kokkos::sqrt(3 * squared_norm(deviator)), root2 = Kokkos::sqrt(Real(2));
    Real const curved = (2 - sq(tan_psi)) / (2 - root2 * tan_psi * lode(deviator));
    at.shape = Kokkos::sqrt(Kokkos::max(sq(tan_psi) / 8 + curved, Real(0))) - tan_psi / (2 * root2);

    auto const [e_d, e_c, e_i] = void_ratios(p);
    at.density_factor = Kokkos::pow(Kokkos::max(e - e_d, Real(0)) / (e_c - e_d), Real(alpha));
    Real const of_pressure = Real(granulate_hardness / exponent) * (1 + e_i) / e_i *
                             Kokkos::pow(3 * p / Real(granulate_hardness), 1 - Real(exponent));
    Real const of_density = Kokkos::pow(Real(e_i0 / e_c0) * e_c / e, Real(beta));
    at.stiffness = of_pressure * of_density / normaliser<Real>() / squared_norm(at.ratio);
    return at;
  }
};
static_assert(ConstitutiveLaw<Hypoplastic>);

}  // namespace scree
