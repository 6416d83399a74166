// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "../boundaries/wall.hpp"
#include "../checks/confines.hpp"
#include "../checks/near_cells.hpp"
#include "../checks/set_values.hpp"
#include "../checks/thin_walls.hpp"
#include "../core/tuple.hpp"
#include "../fields/array.hpp"
#include "../motion/prescribe.hpp"
#include "../passes/outside_validity.hpp"
#include "../passes/survey.hpp"
#include "../passes/validity.hpp"
#include "../system/pick.hpp"
#include "../terms/gravity.hpp"
#include "look_in_space.hpp"
#include "settings.hpp"
#include "unset_fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// Checks of a solver: fields that are set, the start, walls and lost particles.
namespace scree::detail {

/// The largest allowed unit in the last place of a coordinate, in spacings. The coordinates of two neighbours are each
/// rounded by up to half a unit, which displaces the neighbours by 0.4 units (rms) relative to each other. If the
/// neighbours in a lattice are displaced by delta (rms), the error of the pressure gradient is about $3 \delta/(h
/// \sqrt{n})$ times the pressure over h, with n neighbours: with h = 1.5 spacings and n = 28 (2D), 1.5e-4 of this
/// quotient per unit of 0.001 spacings.
inline constexpr double coarsest_unit = 1e-3;

/// Returns a message if single precision is too coarse for positions at this distance (m) from the origin; otherwise
/// "".
[[gnu::cold]] std::string fault_of_precision(double farthest, double spacing);

/// Throws an exception with the text of a fault unless the text is empty: std::invalid_argument before the first step,
/// OutsideValidity later.
[[gnu::cold]] void stop_for(std::string const& fault, long steps);

/// Returns the warning about material under pressure with this packing.
[[gnu::cold]] std::string warning_of_packing(Packing const& found, double time, long steps);

/// Whether all bodies of a list carry the stress.
template <class P, class... Bs>
constexpr bool carry_stress(Bodies<Bs...>) {
  return (OneOf<Stress, scree::carried_fields<P, Bs>> && ...);
}

/// A physics model that warns of a bed of a certain depth (m).
template <class Physics>
concept WarnsOfDepth = requires(Physics const& physics) {
  physics.warning_of_depth(0.0);
};

/// The checks of particle positions, in the execution space if possible and otherwise on the host.
template <class P>
class PositionChecks {
 public:
  /// Checks whether single precision resolves the distances between particles, given their largest coordinate (m). If
  /// not, throws std::invalid_argument before the first step and OutsideValidity later.
  static void precision(double farthest, SolverSettings<P> const& settings, long steps) {
    if (!std::is_same_v<typename P::real, float> || !settings.start_checks) return;
    stop_for(fault_of_precision(farthest, settings.spacing), steps);
  }
  /// Checks the fields, positions and depth before the first step; with `warns` it also warns of a soft bed. Throws
  /// std::invalid_argument as require_all_set(), check_start() and check_depth() do.
  template <class Sys>
  [[gnu::cold]] static void start(Sys const& system, SolverSettings<P> const& settings, bool warns = false) {
    for_each_body(typename P::bodies{}, [&]<class Body>() { require_all_set<P, Body>(system.template body<Body>()); });
    if (!settings.start_checks) return;
    if constexpr (!on_host<typename P::space>)
      if (start_in_space(system, settings, warns)) return;
    Places const here = places(system, settings);
    check_start(here.all, here.owned, settings.spacing, P::dim, here.periods, words_of(system, settings, warns),
                here.others);
    check_depth(system, settings, warns,
                [&](auto const& g) { return extent_along(g, here.all, here.owned, system.whole_case()); });
  }
  /// Checks positions as start() does, in the execution space. Returns false if they must be checked on the host.
  template <class Sys>
  [[gnu::cold]] static bool start_in_space(Sys const& system, SolverSettings<P> const& settings, bool warns = false) {
    return look_in_space<P>(system, settings, [&](auto& look) {
      look.check_start(words_of(system, settings, warns));
      check_depth(system, settings, warns, [&](auto const& g) {
        return look.extent_along({double(g[0]), double(g[1]), P::dim == 3 ? double(g[P::dim - 1]) : 0.0});
      });
    });
  }
  /// Sets the volumes (m^dim) of an evolving body during a run, when grains may be packed more loosely or more densely
  /// than at the start. Throws std::invalid_argument, and leaves the volumes unchanged, if the new volumes do not fit
  /// the distances between the particles and fit them worse than the old ones.
  template <class Body, class Sys, class Values>
  [[gnu::cold]] static void set_volumes(Sys& system, SolverSettings<P> const& settings, Values const& values) {
    using namespace fields;
    auto& material = system.template body<Body>();
    auto const old = material.to_host(volume);
    Packing const before = packing_of_all(system, settings);
    material.from_host(volume, values);
    Packing const after = packing_of_all(system, settings);
    if (!after.can_tell() || after.may_start() || after.misfit() <= before.misfit()) return;
    material.from_host(volume, old);
    throw std::invalid_argument(fault_of_packing(after, settings.spacing, P::dim, "after set()") +
                                "; if this is meant, set `start_checks = false`");
  }
  /// Checks whether walls are too thin, if this check is due. Grains may reach both sides of a wall at any step, so the
  /// check is repeated, each time at eight times the step number of the last check. If a wall is too thin, throws
  /// std::invalid_argument before the first step and OutsideValidity later.
  template <class Sys>
  void walls_now_and_then(Sys const& system, SolverSettings<P> const& settings, long steps) {
    if (settings.start_checks && steps >= walls_due_) walls(system, settings, steps);
  }
  /// Warns once if loaded grains are packed too loosely or too densely. The intervals between checks double during the
  /// run.
  template <class Sys>
  void packing_now_and_then(Sys const& system, SolverSettings<P> const& settings, double time, long steps) {
    if constexpr (carry_stress<P>(evolving_bodies<P>{}) && evolves_position<P>)
      if (settings.start_checks && steps >= packing_due_) packing(system, settings, time, steps);
  }
  /// Returns the packing of the material particles with a positive pressure.
  template <class Sys>
  [[gnu::cold]] static Packing packing_under_pressure(Sys const& system, SolverSettings<P> const& settings) {
    if constexpr (!on_host<typename P::space> && !several_evolve<P>) {
      Packing found;
      auto const& material = system.template body<Material>();
      if (look_in_space<P>(system, settings, [&](auto& look) { found = look.packing(which_are_loaded(material)); }))
        return found;
    }
    Places const here = places(system, settings);
    std::vector<char> loaded;
    for_each_body(evolving_bodies<P>{}, [&]<class Body>() {
      auto const& material = system.template body<Body>();
      auto const stress =
          here.others.sum ? material.to_host(fields::stress) : system.template whole<Body>().values(fields::stress);
      for (auto const& each : stress) loaded.push_back(each[0] + each[1] + each[2] < 0);
    });
    return packing_of(here.all, here.owned, settings.spacing, P::dim, here.periods, here.others, loaded);
  }

 private:
  template <class Sys>
  [[gnu::cold]] void packing(Sys const& system, SolverSettings<P> const& settings, double time, long steps) {
    packing_due_ = std::numeric_limits<long>::max();
    if (!system.whole_case().anywhere(bool(settings.warn))) return;
    Packing const found = packing_under_pressure(system, settings);
    if (found.keeps_volume())
      packing_due_ = 2 * steps;
    else if (settings.warn && system.whole_case().reports())
      settings.warn(warning_of_packing(found, time, steps));
  }
  template <class Sys>
  [[gnu::cold]] static Packing packing_of_all(Sys const& system, SolverSettings<P> const& settings) {
    if constexpr (!on_host<typename P::space>) {
      Packing found;
      if (look_in_space<P>(system, settings, [&](auto& look) { found = look.packing(); })) return found;
    }
    Places const here = places(system, settings);
    return packing_of(here.all, here.owned, settings.spacing, P::dim, here.periods, here.others);
  }
  /// Returns the words of check_start() for the start of a solver.
  template <class Sys>
  [[gnu::cold]] static StartWords words_of(Sys const& system, SolverSettings<P> const& settings, bool warns) {
    StartWords words;
    if (warns && system.whole_case().reports()) words.warn = settings.warn;
    return words;
  }
  /// Returns the depth (m) of material with a volume (m^dim), for warnings: extent(g) along gravity, or twice the mean
  /// height over the area that the material covers if that is less, as in a layer along a slope or in separate beds.
  template <class Extent>
  [[gnu::cold]] static double depth_of_bed(Extent const& extent, Vec<P::dim, double> const& g, double volume,
                                           double spacing) {
    using X = Vec<P::dim, double>;
    if (!(g.squaredNorm() > 0)) return 0;
    double area = 1;
    if constexpr (P::dim == 2) {
      area = extent(X(-g[1], g[0])) + spacing;
    } else {
      int least = 0;
      g.cwiseAbs().minCoeff(&least);
      X const a = X::Unit(least) - g * (g[least] / g.squaredNorm());
      X const b(g[1] * a[2] - g[2] * a[1], g[2] * a[0] - g[0] * a[2], g[0] * a[1] - g[1] * a[0]);
      area = (extent(a) + spacing) * (extent(b) + spacing);
    }
    return std::min(extent(g), 2 * volume / area);
  }
  /// Checks the depth of the material along gravity, extent(g) in m, if the physics model has such a check; with
  /// `warns` it also warns of a soft bed.
  template <class Sys, class Extent>
  [[gnu::cold]] static void check_depth([[maybe_unused]] Sys const& system,
                                        [[maybe_unused]] SolverSettings<P> const& settings, [[maybe_unused]] bool warns,
                                        [[maybe_unused]] Extent const& extent) {
    for_each_body(evolving_bodies<P>{}, [&]<class Body>() {
      auto const& physics = physics_of_body<Body>(settings.physics);
      if constexpr (requires { physics.check_depth(0.0); }) {
        Vec<P::dim, double> const g = gravity_of(physics).template vector<Vec<P::dim, double>>();
        physics.check_depth(extent(g));
        if constexpr (WarnsOfDepth<std::remove_cvref_t<decltype(physics)>>) {
          if (!warns) return;
          double particles = 0;
          for_each_body(evolving_bodies<P>{},
                        [&]<class Each>() { particles += double(system.template whole<Each>().size()); });
          double const volume = particles * std::pow(settings.spacing, P::dim);
          auto const text = physics.warning_of_depth(depth_of_bed(extent, g, volume, settings.spacing));
          if (!text.empty() && settings.warn && system.whole_case().reports()) settings.warn(text);
        }
      }
    });
  }
  /// The particles for checks of positions: those of the whole case or, if other ranks have some of them, the particles
  /// of this rank and those near them, periodic images included. The first `owned` particles, those of evolving bodies,
  /// are checked.
  struct Places {
    PlacedParticles all = {};
    std::size_t owned = 0;
    std::vector<Period> periods = {};
    OtherPlaces others = {};
  };
  template <class Sys>
  [[gnu::cold]] static Places places(Sys const& system, SolverSettings<P> const& settings) {
    Places found;
    auto const add = [&]<class Body>() { found.all.add_part(system.template whole<Body>()); };
    auto const add_near = [&]<class Body>() {
      system.template with_copies_near<Body>(reach_of_checks * settings.spacing, true,
                                             Fields<Position, Volume, Identity>{},
                                             [&](auto const& copies) { found.all.add_here(copies); });
    };
    for_each_body(evolving_bodies<P>{}, add);
    found.owned = found.all.places.size();
    for_each_body(evolving_bodies<P>{}, add_near);
    if (system.whole_case().all_here())
      found.periods = settings.periods;
    else
      found.others = {found.all.places.size(), [&](long here) { return system.whole_case().sum(here); }};
    for_each_body(following_bodies<P>{}, [&]<class Body>() {
      add.template operator()<Body>();
      add_near.template operator()<Body>();
    });
    return found;
  }
  /// Returns the extent (m), along a direction, of the first `count` particles on all ranks of the case; 0 if the
  /// direction is zero.
  template <class X, class Case>
  [[gnu::cold]] static double extent_along(X const& direction, PlacedParticles const& placed, std::size_t count,
                                           Case const& whole) {
    double const length = direction.norm();
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < count; ++i) {
      double along = 0;
      for (int axis = 0; axis < P::dim; ++axis) along += direction[axis] * placed.places[i][std::size_t(axis)];
      low = std::min(low, along), high = std::max(high, along);
    }
    low = -whole.largest(-low), high = whole.largest(high);
    return length > 0 && low <= high ? (high - low) / length : 0;
  }
  template <class Sys>
  [[gnu::cold]] void walls(Sys const& system, SolverSettings<P> const& settings, long steps) {
    walls_due_ = std::max(256L, 8 * steps);
    stop_for(fault_of_walls(system, settings, steps), steps);
  }
  /// Returns the text of fault_of_thin_walls(). If other ranks have some of the particles, the function checks the
  /// particles of this rank among all particles near them.
  template <class Sys>
  [[gnu::cold]] static std::string fault_of_walls(Sys const& system, SolverSettings<P> const& settings, long steps) {
    using Walls = typename walls_of<typename P::physics>::type;
    if constexpr (std::is_same_v<Walls, NoWalls>)
      return "";
    else
      return fault_of_walls<shows_means<Walls>>(system, settings, steps);
  }
  template <bool Means, class Sys>
  [[gnu::cold]] static std::string fault_of_walls(Sys const& system, SolverSettings<P> const& settings, long steps) {
    auto const for_each_wall = [&](auto const& visit) {
      for_each_body(following_bodies<P>{}, [&]<class Body>() {
        if (steps == 0 || !RigidTag<Body>)
          visit.template operator()<Body>();  // later, grains may reach all sides of rigid bodies
      });
    };
    auto const turning = [&]<class Body>() {
      return steps == 0 ? which_turn<Body>(system, settings) : std::vector<char>();
    };
    double const support = P::kernel::support * settings.smoothing;  // spacings
    double const reach = 1.01 * WallView::cell(support) * settings.spacing;
    if constexpr (!on_host<typename P::space>)
      if (walls_are_thick<P>(system, settings.spacing, support, Means, for_each_wall, turning)) return "";
    auto const& whole_case = system.whole_case();
    ParticlesAtWalls particles;
    particles.support = support;
    for_each_wall([&]<class Body>() {
      particles.add_wall(system.template whole<Body>(), Means, turning.template operator()<Body>());
    });
    for_each_wall([&]<class Body>() { particles.template add_wall_near<Body>(system, reach, Means); });
    if (!whole_case.anywhere(!particles.is_plate.empty())) return "";
    PlacedParticles material;
    for_each_body(evolving_bodies<P>{}, [&]<class Body>() {
      auto const grains = system.template whole<Body>();
      material.add_part(grains, those_near(particles.all.places, reach, grains.here()));
      system.template with_copies_near<Body>(reach, false, Fields<Position, Volume, Identity>{},
                                             [&](auto const& copies) { material.add_here(copies); });
    });
    particles.put_material(material);
    return fault_of_thin_walls(particles, settings.spacing, P::dim, whole_case);
  }
  /// Returns which particles of a body follow a motion that rotates them, now or later.
  template <class Body, class Sys>
  [[gnu::cold]] static std::vector<char> which_turn(Sys const& system, SolverSettings<P> const& settings) {
    auto const& body = system.template body<Body>();
    std::vector<char> turn(std::size_t(body.size()), 0);
    if constexpr (!RigidTag<Body>) {
      auto const motion = motion_of_body<Body>(settings.motion);
      if constexpr (!std::is_same_v<std::remove_const_t<decltype(motion)>, AtRest>) {
        auto const moves = moves_of(motion, body);
        auto const x = body.to_host(fields::position);
        for (std::size_t k = 0; k < turn.size(); ++k) turn[k] = may_turn(moves(k), x[k], settings.spacing);
      }
    }
    return turn;
  }

  static constexpr double reach_of_checks = 3.01;  // spacings; the checks reach 3 spacings
  // If the host has to check the particles of a GPU, a check costs as much as a few hundred steps with 1 to 10 million
  // particles; on a CPU it costs as much as one step.
  static constexpr long first_look_at_packing = on_host<typename basis_of<P>::space> ? 2048 : 16'384;
  long walls_due_ = 0;                        // the step of the next check of walls
  long packing_due_ = first_look_at_packing;  // the step of the next check of the packing
};

/// Returns the bound on the share of particles that are farther than a support (m) outside a box.
template <class P, class X>
Bound<DistanceBeyond<X>> nothing_lost(DistanceBeyond<X> const& box, double support, SolverSettings<P> const& settings) {
  return bound("distance beyond the walls (m)", box, support,
               "walls need as many rows as the support of the kernel has spacings, three with the default smoothing; "
               "where grains may get lost, raise `lost_share` of the settings",
               settings.lost_share);
}
/// Returns the number of particles of the evolving bodies that exceed a bound, in the whole case.
template <class Sys, class Measure>
long number_beyond(Sys const& system, Bound<Measure> const& bound) {
  long all = 0;
  for_each_body(bodies_named<Material, typename Sys::bodies>{}, [&]<class Body>() {
    auto const body = system.template whole<Body>();
    all += body.sum(static_cast<long>(survey(body.here(), Fields<>{}, bound).largest[0].beyond));
  });
  return all;
}
/// Returns the bounds on the state of a body: those of its physics model and, if positions evolve, a bound on lost
/// particles.
template <class P, class Physics, class Lost>
auto bounds_of(Physics const& physics, Resolution const& resolution, Lost const& lost) {
  auto const of_physics = validity_of(physics, resolution);
  if constexpr (evolves_position<P>)
    return in_a_row(of_physics, Tuple(lost()));
  else
    return of_physics;
}

}  // namespace scree::detail

#ifndef SCREE_COMPILED
#include "checks.ipp"
#endif
