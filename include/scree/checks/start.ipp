// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../core/compiled.hpp"
#include "../core/in_layers.hpp"
#include "packing.hpp"
#include "points_in_cells.hpp"
#include "start.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace scree {

namespace detail {

/// Calls look(portion) for each portion in [0, portions), on the threads of the host. If a call returns false, some
/// later portions are skipped, but no earlier ones.
template <class Look>
void visit_in_order(long portions, Look const& look) {
  std::atomic<long> last = portions;
  for_each_layer(portions, [&](long portion) {
    if (portion > last || look(portion)) return;
    for (long before = last; portion < before && !last.compare_exchange_weak(before, portion);) continue;
  });
}

/// An evaluation of the packing around particles, including their periodic images.
class StartLook {
 public:
  StartLook(PlacedParticles const& all, std::size_t first_wall, double spacing, int dimensions,
            std::vector<Period> const& periods)
      : all_(all),
        first_wall_(first_wall),
        kernel_(spacing, dimensions),
        cells_(all.places, 0, all.places.size(), kernel_.support()),
        periods_(periods) {}
  /// Returns the number of cells with particles.
  std::size_t cells() const { return cells_.size(); }
  /// Calls visit(i, crowding) for those of the first `owned` particles that are in some cells, until a call returns
  /// false.
  void visit_cells(std::size_t from, std::size_t to, std::size_t owned,
                   std::function<bool(std::size_t, Crowding const&)> const& visit) const {
    std::vector<PointsInCells::Numbered> around;
    for (std::size_t cell = from; cell < to; ++cell) {
      if (cells_.begin(cell)->number >= owned) continue;
      around.clear();
      find(cells_.hull_of(cell), {}, 0, around);
      for (auto const* p = cells_.begin(cell); p != cells_.end(cell) && p->number < owned; ++p)
        if (!visit(p->number, crowding(*p, around))) return;
    }
  }
  Crowding operator()(std::size_t i) const { return crowding({all_.places[i], i}, around(i)); }
  /// Returns the volume of a wall particle over the dim-th power of the distance to the nearest other one, which is
  /// taken to be at most the support.
  double fill_of_wall(std::size_t i) const { return all_.volumes[i] / kernel_.volume(std::sqrt(nearest_of_walls(i))); }

 private:
  std::vector<PointsInCells::Numbered> around(std::size_t i) const {
    std::vector<PointsInCells::Numbered> found;
    PointsInCells::Hull here;
    here.add(all_.places[i]);
    find(here, {}, 0, found);
    return found;
  }
  double nearest_of_walls(std::size_t i) const {
    double least = kernel_.support() * kernel_.support();
    for (auto const& j : around(i)) {
      double const squared = PointsInCells::squared_distance(all_.places[i], j.x);
      if (j.number >= first_wall_ && (j.number != i || squared > 0)) least = std::min(least, squared);
    }
    return least;
  }
  void find(PointsInCells::Hull const& box, PointsInCells::Point const& shift, std::size_t period,
            std::vector<PointsInCells::Numbered>& around) const {
    if (period < periods_.size()) {
      auto const& [axis, low, high] = periods_[period];
      for (double const by : {0.0, high - low, low - high}) {
        auto moved = shift;
        moved[std::size_t(axis)] = by;
        find(box, moved, period + 1, around);
      }
      return;
    }
    cells_.add_near(box, kernel_.support(), shift, around);
  }
  [[gnu::noinline]] Crowding crowding(PointsInCells::Numbered const& i,
                                      std::vector<PointsInCells::Numbered> const& around) const {
    CrowdingSum sum(kernel_, all_.volumes[i.number]);
    for (auto const& j : around) {
      double const x = i.x[0] - j.x[0], y = i.x[1] - j.x[1], z = i.x[2] - j.x[2], squared = x * x + y * y + z * z;
      if (!kernel_.reaches(squared) || (j.number == i.number && squared == 0)) continue;  // itself, not its images
      sum.add(x, y, z, squared, all_.volumes[j.number], j.number >= first_wall_, j.number);
    }
    return sum.result();
  }

  PlacedParticles const& all_;
  std::size_t first_wall_;
  PackingKernel kernel_;
  PointsInCells cells_;
  std::vector<Period> const& periods_;
};

SCREE_BODY Crowding crowding_at(PlacedParticles const& all, std::size_t i, std::size_t first_wall, double spacing,
                                int dimensions, std::vector<Period> const& periods) {
  return StartLook(all, first_wall, spacing, dimensions, periods)(i);
}

}  // namespace detail

SCREE_BODY void check_start(PlacedParticles const& all, std::size_t owned, double spacing, int dimensions,
                            std::vector<Period> const& periods, StartWords const& words, OtherPlaces const& others) {
  std::size_t const first_wall = std::max(owned, others.first_wall);
  auto const number = [&](std::size_t i) {
    return all.numbers.empty() ? i - (i < first_wall ? 0 : first_wall) : std::size_t(all.numbers[i]);
  };
  auto const named = [&](std::size_t i) { return detail::NamedParticle{number(i), all.places[i]}; };
  detail::StartFaults const faults{spacing, dimensions, words};
  detail::StartLook const look(all, first_wall, spacing, dimensions, periods);
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  struct Found {
    std::size_t wrong = none, alone = 0, last_alone = 0;
    detail::PackingOfMany packing = {};
  };
  std::size_t const at_once = 64;
  std::vector<Found> all_found(look.cells() / at_once + 1);
  detail::visit_in_order(static_cast<long>(all_found.size()), [&](long portion) {
    Found& found = all_found[static_cast<std::size_t>(portion)];
    std::size_t const first = static_cast<std::size_t>(portion) * at_once;
    look.visit_cells(first, std::min(first + at_once, look.cells()), owned,
                     [&](std::size_t i, detail::Crowding const& at) {
                       if (at.nearest > 1.5 * spacing) ++found.alone, found.last_alone = std::max(found.last_alone, i);
                       if (at.is_wrong(spacing, words.most_density)) found.wrong = i;
                       found.packing.add(at, spacing);
                       return found.wrong == none;
                     });
    return found.wrong == none;
  });
  Found found;
  for (Found const& each : all_found) {
    if (found.wrong == none) found.wrong = each.wrong;
    found.alone += each.alone, found.last_alone = std::max(found.last_alone, each.last_alone);
    found.packing.add(each.packing);
  }
  if (found.wrong != none) {
    auto const at = look(found.wrong);
    faults.refuse(named(found.wrong), at, number(at.neighbour), at.neighbour >= first_wall);
  }
  auto const everywhere = [&](long here) { return others.sum ? others.sum(here) : here; };
  long const alone = everywhere(long(found.alone)), count = everywhere(long(owned));
  if (faults.refuses_alone(alone, count) && found.alone > 0) faults.refuse_alone(named(found.last_alone), alone, count);
  if (!faults.judges_packing()) return;
  std::size_t const walls = all.places.size() - first_wall, some = std::min(walls, detail::walls_looked_at);
  for (std::size_t k = 0; k < some; ++k) found.packing.add_wall(look.fill_of_wall(first_wall + k * walls / some));
  faults.check(found.packing.of_all(everywhere));
}

SCREE_BODY Packing packing_of(PlacedParticles const& all, std::size_t owned, double spacing, int dimensions,
                              std::vector<Period> const& periods, OtherPlaces const& others,
                              std::vector<char> const& counted) {
  detail::StartLook const look(all, all.places.size(), spacing, dimensions, periods);
  std::size_t const at_once = 64;
  std::vector<detail::PackingOfMany> portions(look.cells() / at_once + 1);
  detail::for_each_layer(static_cast<long>(portions.size()), [&](long portion) {
    auto& found = portions[static_cast<std::size_t>(portion)];
    std::size_t const first = static_cast<std::size_t>(portion) * at_once;
    look.visit_cells(first, std::min(first + at_once, look.cells()), owned,
                     [&](std::size_t i, detail::Crowding const& at) {
                       if (counted.empty() || counted[i] != 0) found.add(at, spacing);
                       return true;
                     });
  });
  for (std::size_t k = 1; k < portions.size(); ++k) portions[0].add(portions[k]);
  return portions[0].of_all([&](long here) { return others.sum ? others.sum(here) : here; });
}

}  // namespace scree
