// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "spots.hpp"
#include "wall_view.hpp"

#include <vector>

// The search for walls that are too thin, in the execution space that has the particles. It only finds whether there
// are any; if so, the host repeats the search and names one of them.
namespace scree::detail {

/// Counts the particles of walls that have a fault.
struct CountThinWalls {
  using value_type = int;
  SpotsView cells;
  int dimensions;
  double spacing, support;
  int owned;  // the particles of the material come first
  Span<char const> is_plate;
  Span<char const> turns;  // empty: none

  SCREE_FN void init(int& faults) const { faults = 0; }
  SCREE_FN void join(int& faults, int const& others) const { faults += others; }
  SCREE_FN void operator()(int k, int& faults) const {
    int const w = cells.numbers(k) - owned;
    if (w < 0) return;
    WallView view;
    view.dimensions = dimensions, view.spacing = spacing, view.support = support;
    Spot const here = cells.sorted(k);
    view.look(
        [&](auto const& visit) { for_each_near(here, true, visit); },
        [&](auto const& visit) { for_each_near(here, false, [&](WallView::Point const& x, double) { visit(x); }); });
    if (view.fault(is_plate(w) != 0, turns.size() > 0 && turns(w) != 0) != ThinWall::none) ++faults;
  }

 private:
  /// Visits the particles of the material, or those of walls, that are near but not at the position of `here`.
  template <class Visit>
  SCREE_FN void for_each_near(Spot const& here, bool material, Visit const& visit) const {
    cells.for_each_near(here.x, [&](int j, Spot const&, double x, double y, double z, double squared) {
      if ((j < owned) == material && squared > 0 && squared < sq(WallView::reach(support) * spacing))
        visit(WallView::Point(-x, -y, -z), squared);
      return true;
    });
  }
};

/// Returns the number of wall particles with a fault, as ThinWalls::faults() does, apart from rounding; -1 if the host
/// has to check, because too many particles are in one bucket. The spots are those of the material, then those of
/// walls; `is_plate` and `turns` (empty: none) have an entry for each wall particle.
template <class Space>
int faults_of_thin_walls(Spots<Space> const& spots, double spacing, int dimensions,
                         ArrayIn<char, Space> const& is_plate, ArrayIn<char, Space> const& turns,
                         double support = WallView::usual_support) {
  SpotsInCells<Space> const cells(spots, WallView::cell(support) * spacing, dimensions, {});
  if (!cells.is_complete()) return -1;
  return reduce(spots.space(), "scree::thin_walls", spots.all.size(),
                CountThinWalls{cells.view(), dimensions, spacing, support, spots.owned, is_plate, turns});
}

}  // namespace scree::detail

#ifdef SCREE_COMPILED
SCREE_INSTANCE int scree::detail::faults_of_thin_walls(
    scree::detail::Spots<Kokkos::DefaultExecutionSpace> const&, double, int,
    scree::detail::ArrayIn<char, Kokkos::DefaultExecutionSpace> const&,
    scree::detail::ArrayIn<char, Kokkos::DefaultExecutionSpace> const&, double);
#endif
