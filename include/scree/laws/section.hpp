// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/setting.hpp"
#include "circular_cone.hpp"

#include <cmath>
#include <concepts>
#include <stdexcept>
#include <type_traits>

// The section of a yield surface, normal to the hydrostatic axis, describes how the strength depends on the
// intermediate principal stress.
namespace scree {

/// The section of the yield surface of a frictional law is an empty struct with these functions:
///   ratio(k, cosine)     $\sqrt{J_2}/p$ at yield for $\cos 3\theta$ of the deviator, see cosine_of_lode_angle(); it is
///                        k in plane shear
///   least_ratio(k)       a lower bound on the ratio in all directions; 0 is always valid. For stresses up to this
///                        bound ratio() is not evaluated
/// Both functions return the type of k, float or double.
template <class S>
concept YieldSection = std::is_empty_v<S> && std::is_default_constructible_v<S> && requires(S const& section) {
  { section.ratio(1.0, 1.0) } -> std::same_as<double>;
  { section.ratio(1.0f, 1.0f) } -> std::same_as<float>;
  { section.least_ratio(1.0) } -> std::same_as<double>;
  { section.least_ratio(1.0f) } -> std::same_as<float>;
};

/// Whether admissible() of a law uses the section of its point, by calling return_to_yield(); the law declares this by
/// a constant `takes_section` = true.
template <class Law>
concept TakesSection = requires {
  requires Law::takes_section;
};

/// The point that is passed to a law if its yield surface has the section S.
template <class Point, YieldSection S>
struct PointOfSection {
  using section = S;
  Point const& point;
  template <Field F>
  SCREE_FN decltype(auto) operator[](F field) const {
    return point[field];
  }
};

namespace detail {
template <class Point>
concept KnowsSection = requires {
  typename Point::section;
};
template <class Point>
struct SectionAt {
  using type = CircularCone;
};
template <KnowsSection Point>
struct SectionAt<Point> {
  using type = typename Point::section;
};
}  // namespace detail

/// The section of the yield surface at a point: a circular cone unless the point names another section.
template <class Point>
using section_at = typename detail::SectionAt<Point>::type;

/// Returns $\cos 3\theta$ of a deviator, $(3 \sqrt{3}/2) J_3/J_2^{3/2}$ with compression positive: 1 in triaxial
/// compression, 0 in plane shear, -1 in triaxial extension, and 0 if there is no shear.
template <class Real>
SCREE_FN Real cosine_of_lode_angle(StressTensor<Real> const& s) {
  StressTensor<Real> const direction = s / equivalent_shear_stress(s);
  Real const cosine = -Real(1.5 * 1.7320508075688772 / 3) * dot(direction * direction, direction);
  return cosine > -1 ? Kokkos::min(cosine, Real(1)) : cosine <= -1 ? Real(-1) : Real(0);
}

namespace detail {
/// Throws std::invalid_argument if the ratio of a section is not k in plane shear, or if its lower bound is negative or
/// exceeds the ratio in some direction. The ratios are computed once.
template <YieldSection S>
[[gnu::cold]] void check_ratios() {
  auto const check = [] {
    for (double k = 0.05; k < 0.86; k += 0.1) {  // friction ratios stay below sqrt(3)/2
      double const least = S{}.least_ratio(k), in_plane_shear = S{}.ratio(k, 0.0);
      if (!(std::abs(in_plane_shear - k) < 1e-9))
        throw std::invalid_argument(
            formatted("scree: ratio(%.3g, 0) of the section is %.4g: in plane shear it must be k", k, in_plane_shear));
      for (double cosine = -1; cosine < 1.05; cosine += 0.1)
        if (double const ratio = S{}.ratio(k, cosine); !(least >= 0 && ratio >= least * (1 - 1e-12)))
          throw std::invalid_argument(formatted(
              "scree: least_ratio(%.3g) of the section is %.4g: it must be 0 or more and not above the ratio in "
              "any direction, which is %.4g where cos 3 theta = %.3g",
              k, least, ratio, cosine));
    }
    return true;
  };
  [[maybe_unused]] static bool const checked = check();
}
}  // namespace detail

}  // namespace scree
