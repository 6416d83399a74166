// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/on_plate.hpp"
#include "../core/one_part.hpp"
#include "start.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

// Finds walls that are too thin for the support of the kernel. It runs on the host and does not depend on the
// formulation.
namespace scree {

struct SlipNormal;
struct DummyVelocity;

namespace detail {

/// What one wall particle sees within a little less than a support of 3 spacings. `across` is the direction through the
/// wall.
struct WallView {
  using Point = PointsInCells::Point;
  struct Weighted {
    Point x;  // from the particle, m
    double weight, squared;
  };
  int dimensions = 2;
  std::vector<Weighted> material;
  Point across = {};
  double other_share = 0;   ///< share of the weight of the material on the side that has less of it
  int fewer = 0;            ///< particles of the material on the side that has fewer
  double thickness = 0;     ///< between the material of both sides, m
  bool is_edge = false;     ///< there is material to the side, or both sides are not opposite
  bool is_one_row = false;  ///< there is material in front and no wall behind

  static double product(Point const& a, Point const& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  /// What is wrong with the wall here; "" if nothing is.
  [[gnu::cold]] std::string fault(bool plate, double spacing) const {
    double const thick = thickness / spacing;
    if (is_one_row)
      return "it has one row of particles, so that the support of the material in front is half empty; it needs two "
             "rows, better three";
    int const bed = dimensions == 2 ? 4 : 8;  // fewer particles are grains that have sunk into the wall
    if (is_edge || other_share < 0.05 || fewer < bed) return "";
    if (!plate)
      return formatted(
          "it has material on both sides, %.2g spacings apart, and shows each the mean of both; make it 4 "
          "spacings thick, or 2 and a plate (`using walls = PlateWalls`, field `on_plate`)",
          thick);
    if (thick < 1.75)
      return formatted("material acts on material through a plate of %.2g spacings; a plate needs two", thick);
    return "";
  }
  /// Adds a particle of the material, x from the wall particle (m).
  void add(Point const& x, double squared, double spacing) {
    double const r = std::sqrt(squared) / spacing, left = 1 - r / 3;
    material.push_back({x, left > 0 ? left * left * left * left * (1 + 4 * r / 3) : 0, squared});
  }
  /// Call it once `material` is known. for_each_wall(visit) calls visit(x) for the particles of walls within the same
  /// distance; it is called where walls behind are looked for.
  template <class ForEachWall>
  void look(double spacing, ForEachWall const& for_each_wall) {
    if (material.empty()) return;
    find_across();
    Point mean_here = {}, mean_there = {};
    double along = 0, aside = 0;  // second moments
    int count_there = 0;
    double here = 0, there = 0, least_here = 3 * spacing, least_there = least_here;
    for (auto const& [x, weight, squared] : material) {
      double const height = product(x, across), distance = std::sqrt(squared);
      (height < 0 ? there : here) += weight;
      count_there += height < 0;
      for (std::size_t axis = 0; axis < 3; ++axis) (height < 0 ? mean_there : mean_here)[axis] += weight * x[axis];
      double& least = height < 0 ? least_there : least_here;
      least = std::min(least, distance);
      along += weight * height * height;
      aside += weight * (squared - height * height) / (dimensions - 1);
    }
    other_share = std::min(here, there) / (here + there);
    fewer = std::min(count_there, int(material.size()) - count_there);
    double const lengths = std::sqrt(product(mean_here, mean_here) * product(mean_there, mean_there));
    is_edge = aside > 0.65 * along || product(mean_here, mean_there) > -0.8 * lengths;
    thickness = least_here + least_there - spacing;
    if (there > 0 || !(least_here < 1.6 * spacing)) return;
    bool has_wall_behind = false;
    int beside = 0;  // a few wall particles on their own are no row
    for_each_wall([&](Point const& x) {
      double const distance = std::sqrt(product(x, x));
      has_wall_behind = has_wall_behind || product(x, across) < -0.4 * distance;
      beside += distance < 1.6 * spacing;
    });
    is_one_row = !has_wall_behind && beside >= 2;
  }

 private:
  void find_across() {
    Weighted const* nearest = &material[0];
    for (Weighted const& m : material)
      if (m.squared < nearest->squared) nearest = &m;
    double const reach = std::sqrt(nearest->squared);
    for (std::size_t axis = 0; axis < 3; ++axis) across[axis] = nearest->x[axis] / reach;
    for (int iteration = 0; iteration < 4; ++iteration) {
      Point sum = {};
      for (auto const& [x, weight, squared] : material) {
        double const signed_weight = product(x, across) < 0 ? -weight : weight;
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += signed_weight * x[axis];
      }
      double const length = std::sqrt(product(sum, sum));
      if (!(length > 0)) break;
      Point const before = across;
      for (std::size_t axis = 0; axis < 3; ++axis) across[axis] = sum[axis] / length;
      if (across == before) break;
    }
  }
};

/// Evaluates what wall particles see. The particles of the material come first; there are `owned` of them.
class WallsLook {
 public:
  using Point = PointsInCells::Point;
  WallsLook(std::vector<Point> const& places, std::size_t owned, double spacing, int dimensions)
      : owned_(owned),
        spacing_(spacing),
        dimensions_(dimensions),
        walls_(places, owned, places.size(), 3 * spacing),
        material_(places, 0, owned, 3 * spacing, [near = walls_.cells_near(reach())](CellIndex const& cell) {
          return near.find(cell) != CellNumbers::none;
        }) {}
  /// The number of cells with wall particles.
  std::size_t cells() const { return walls_.size(); }
  /// visit(w, view) for those wall particles in some cells that see material.
  template <class Visit>
  void visit_cells(std::size_t from, std::size_t to, Visit const& visit) const {
    Around around;
    for (std::size_t cell = from; cell < to; ++cell) {
      around.find(*this, walls_.hull_of(cell));
      if (!around.material.empty())
        for (auto const* w = walls_.begin(cell); w != walls_.end(cell); ++w)
          visit(w->number - owned_, view(w->x, around));
    }
  }
  WallView operator()(Point const& x) const {
    Around around;
    PointsInCells::Hull here;
    here.add(x);
    around.find(*this, here);
    return view(x, around);
  }

 private:
  /// The particles around a box.
  struct Around {
    std::vector<Point> material;
    PointsInCells::Hull box;
    void find(WallsLook const& all, PointsInCells::Hull const& hull) {
      box = hull;
      material.clear();
      all.material_.near(box, all.reach(), {}, [&](auto const& p) { material.push_back(p.x); });
    }
  };
  double reach() const { return std::sqrt(8.7) * spacing_; }
  /// visit(x from `centre`, |x|^2) for a particle that is near.
  template <class Visit>
  void if_near(Point const& centre, Point const& y, Visit const& visit) const {
    Point const x = {y[0] - centre[0], y[1] - centre[1], y[2] - centre[2]};
    double const squared = WallView::product(x, x);
    if (squared > 0 && squared < 8.7 * spacing_ * spacing_) visit(x, squared);
  }
  WallView view(Point const& centre, Around const& around) const {
    WallView found;
    found.dimensions = dimensions_;
    for (Point const& y : around.material)
      if_near(centre, y, [&](Point const& x, double squared) { found.add(x, squared, spacing_); });
    found.look(spacing_, [&](auto const& visit) {
      walls_.near(around.box, reach(), {},
                  [&](auto const& p) { if_near(centre, p.x, [&](Point const& x, double) { visit(x); }); });
    });
    return found;
  }

  std::size_t owned_;
  double spacing_;
  int dimensions_;
  PointsInCells walls_, material_;  // the material near walls
};

}  // namespace detail

/// The particles of the material, `owned` of them, then those of walls, and which of the latter belong to plates; of
/// all parts of the case, or those near one of them.
struct ParticlesAtWalls {
  PlacedParticles all;
  std::size_t owned = 0;
  std::vector<bool> is_plate;
  std::size_t looked_at = std::numeric_limits<std::size_t>::max();  ///< later particles of walls belong to other parts

  ParticlesAtWalls() = default;
  template <class Parts, class Body>
  [[gnu::cold]] ParticlesAtWalls(Parts const& parts, Body const& material) {
    all.add(parts, material);
    owned = all.places.size();
  }
  /// Adds the particles of a wall that granular mechanics see. Walls that extrapolate show a mean of the material
  /// except on plates (boundaries/plates.hpp); those without an extrapolated velocity are like plates.
  template <class Parts, class Body>
  [[gnu::cold]] void add_wall([[maybe_unused]] Parts const& parts, [[maybe_unused]] Body const& body) {
    if constexpr (OneOf<SlipNormal, typename Body::fields>) {
      all.add(parts, body);
      if constexpr (OneOf<OnPlate, typename Body::fields>)
        add_plates(parts.order_of(body).of(body.to_host(OnPlate{})));
      else
        is_plate.resize(all.places.size() - owned, !OneOf<DummyVelocity, typename Body::fields>);
    }
  }
  /// The same for one part of a case: the particles of the material that are here and near, those of walls that are
  /// here, and then those that are near. All parts call them together.
  template <class Sys>
  [[gnu::cold]] void add_material_near(Sys const& system, double reach) {
    all.add_here(system.template body<Material>());
    all.add_here(system.template copies_near<Material>(reach, false, Fields<Position, Volume, Identity>{}));
    owned = all.places.size();
  }
  template <class Body, class Sys>
  [[gnu::cold]] void add_wall_here(Sys const& system) {
    auto const& body = system.template body<Body>();
    add_wall_particles<typename std::remove_cvref_t<decltype(body)>::fields>(body);
    looked_at = is_plate.size();
  }
  template <class Body, class Sys>
  [[gnu::cold]] void add_wall_near([[maybe_unused]] Sys const& system, [[maybe_unused]] double reach) {
    using Given = typename std::remove_cvref_t<decltype(system.template body<Body>())>::fields;
    using Wanted = Merge<Fields<Position, Volume, Identity>, Common<Fields<OnPlate>, Given>>;
    if constexpr (OneOf<SlipNormal, Given>)
      add_wall_particles<Given>(system.template copies_near<Body>(reach, false, Wanted{}));
  }

 private:
  template <class Given, class Particles>
  [[gnu::cold]] void add_wall_particles([[maybe_unused]] Particles const& particles) {
    if constexpr (OneOf<SlipNormal, Given>) {
      all.add_here(particles);
      if constexpr (OneOf<OnPlate, Given>)
        add_plates(particles.to_host(OnPlate{}));
      else
        is_plate.resize(all.places.size() - owned, !OneOf<DummyVelocity, Given>);
    }
  }
  template <class Values>
  void add_plates(Values const& values) {
    for (auto const on : values) is_plate.push_back(on > 0);
  }
};

/// Looks for walls that are too thin:
///   a wall with material on both sides, of which one of its particles shows each side a mean with a share of the other
///     above 5 %; walls of 4 spacings stay below
///   a plate of less than 1.75 spacings with material on both sides, which then act on each other
///   a wall of one row of particles with material in front
/// Edges and bodies of a few spacings, which have material all around, and the feet of plates are not looked at, and
/// periods are not followed. The threads of the host share the walls; of the particles with a fault the one with the
/// lowest number is named.
class ThinWalls {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  [[gnu::cold]] ThinWalls(ParticlesAtWalls const& particles, double spacing, int dimensions)
      : particles_(particles),
        spacing_(spacing),
        dimensions_(dimensions),
        look_(particles.all.places, particles.owned, spacing, dimensions) {
    if (particles.owned > 0) find();
  }
  /// How many particles of walls have a fault.
  std::size_t faults() const { return found_.faults; }
  /// The lowest number of these; `none` without.
  std::size_t lowest() const { return found_.lowest; }
  /// Names the fault of the particle with that number.
  [[gnu::cold]] std::string text() const {
    auto const& x = particles_.all.places[particles_.owned + found_.place];
    return detail::formatted(
        "scree: the wall is too thin at its particle %zu at (%.6g, %.6g%s) m: %s; if this is meant, set `start_checks "
        "= false`",
        found_.lowest, x[0], x[1], dimensions_ == 2 ? "" : detail::formatted(", %.6g", x[2]).c_str(),
        look_(x).fault(particles_.is_plate[found_.place], spacing_).c_str());
  }

 private:
  struct Found {
    std::size_t faults = 0, lowest = none, place = none;
    void add(std::size_t count, std::size_t number, std::size_t at) {
      faults += count;
      if (number < lowest) lowest = number, place = at;
    }
  };
  [[gnu::cold]] void find() {
    std::size_t const at_once = 64;
    std::vector<Found> all_found(look_.cells() / at_once + 1);
    detail::for_each_layer(static_cast<long>(all_found.size()), [&](long portion) {
      Found& found = all_found[static_cast<std::size_t>(portion)];
      std::size_t const first = static_cast<std::size_t>(portion) * at_once;
      look_.visit_cells(first, std::min(first + at_once, look_.cells()),
                        [&](std::size_t w, detail::WallView const& view) {
                          if (w >= particles_.looked_at || view.fault(particles_.is_plate[w], spacing_).empty()) return;
                          auto const& numbers = particles_.all.numbers;
                          found.add(1, numbers.empty() ? w : std::size_t(numbers[particles_.owned + w]), w);
                        });
    });
    for (Found const& each : all_found) found_.add(each.faults, each.lowest, each.place);
  }

  ParticlesAtWalls const& particles_;
  double spacing_;
  int dimensions_;
  detail::WallsLook look_;
  Found found_;
};

/// What is wrong with the first wall that is too thin; "" if none is. Three wall particles must have a fault, so that
/// single grains that have sunk into a wall do not count. `parts` looked together: the text is that of the part that
/// has the particle.
template <class Parts = OnePart>
[[gnu::cold]] std::string fault_of_thin_walls(ParticlesAtWalls const& particles, double spacing, int dimensions,
                                              Parts const& parts = {}) {
  ThinWalls const walls(particles, spacing, dimensions);
  double const lowest = -parts.largest(-double(walls.lowest()));
  bool const many = parts.sum(long(walls.faults())) >= 3;
  return many && walls.faults() > 0 && double(walls.lowest()) == lowest ? walls.text() : "";
}

}  // namespace scree
