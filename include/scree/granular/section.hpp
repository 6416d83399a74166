// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../laws/matsuoka_nakai.hpp"
#include "../laws/section.hpp"

#include <type_traits>

namespace scree {

/// The default section of the yield surface: in 3D MatsuokaNakai, the section of sand, if the law takes a section; in
/// 2D, and for other laws, the yield surface of the law itself.
struct SectionByLaw {};

namespace granular {

/// Selects the type of section_of.
template <class Named, class Law, int dim>
struct SectionOf {
  using type = Named;
};
template <class Law, int dim>
struct SectionOf<SectionByLaw, Law, dim> {
  using type = std::conditional_t<TakesSection<Law> && dim == 3, MatsuokaNakai, CircularCone>;
};
/// The section of the yield surface of a granular model in `dim` dimensions: `Named`, or the default for the law if
/// `Named` is SectionByLaw.
template <class Named, class Law, int dim>
using section_of = typename SectionOf<Named, Law, dim>::type;

/// Whether a named section fits a law: CircularCone leaves every law as it is; other sections need a law that takes a
/// section.
template <class Named, class Law>
inline constexpr bool section_fits =
    std::is_same_v<Named, SectionByLaw> || std::is_same_v<Named, CircularCone> || TakesSection<Law>;

/// Returns the point that is passed to a law for a section: the point itself for CircularCone, otherwise a
/// PointOfSection.
template <class S, class Point>
SCREE_FN decltype(auto) at_section(Point const& point) {
  if constexpr (std::is_same_v<S, CircularCone>)
    return (point);
  else
    return PointOfSection<Point, S>{point};
}

}  // namespace granular
}  // namespace scree
