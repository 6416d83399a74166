// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../laws/matsuoka_nakai.hpp"
#include "../laws/section.hpp"

#include <type_traits>

namespace scree {

/// The section that a law needs: in space MatsuokaNakai if the law takes a section, as sand has it; in the plane, and
/// for other laws, the surface as the law has it.
struct SectionByLaw {};

namespace granular {

/// The section that the models of Granular name, in a number of dimensions.
template <class Named, class Law, int dim>
struct SectionOf {
  using type = Named;
};
template <class Law, int dim>
struct SectionOf<SectionByLaw, Law, dim> {
  using type = std::conditional_t<TakesSection<Law> && dim == 3, MatsuokaNakai, CircularCone>;
};
/// The section of the yield surface of a granular model: `Named`, or the one that the law needs.
template <class Named, class Law, int dim>
using section_of = typename SectionOf<Named, Law, dim>::type;

/// Whether a named section can act: CircularCone leaves every law as it is, others need a law that takes them.
template <class Named, class Law>
inline constexpr bool section_fits =
    std::is_same_v<Named, SectionByLaw> || std::is_same_v<Named, CircularCone> || TakesSection<Law>;

/// A point as a law sees it for a section; of the circular cone the point itself.
template <class S, class Point>
SCREE_FN decltype(auto) at_section(Point const& point) {
  if constexpr (std::is_same_v<S, CircularCone>)
    return (point);
  else
    return PointOfSection<Point, S>{point};
}

}  // namespace granular
}  // namespace scree
