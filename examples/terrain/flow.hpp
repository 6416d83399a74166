// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case.hpp"

#include <scree/app/checkpoints.hpp>
#include <scree/app/figures.hpp>
#include <scree/app/run_ranks.hpp>
#include <scree/app/say.hpp>
#include <scree/app/summary.hpp>
#include <scree/granular/wall_guard.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/io/write_raster.hpp>
#include <scree/openings/regions.hpp>
#include <scree/probes/depth_map.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/setup/measured_fill.hpp>
#include <scree/setup/terrain.hpp>
#include <scree/setup/walls.hpp>
#include <scree/solver/solver.hpp>

#ifdef SCREE_HAS_GDAL
#include <scree/gdal/read_gdal.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Granular material that is released on the terrain of a raster, flows and comes to rest.
namespace terrain {

using scree::Box;
using scree::Raster;
using X = scree::Vec<3, double>;
inline constexpr char const* through_ground = "through the ground";

struct Models : scree::GranularModels {
  using forces = std::tuple<scree::WallGuard>;
};
template <class Real>
struct Formulation : scree::Formulation<3, Real> {
  using physics = scree::Granular<Models>;
  using integrator = scree::SymplecticEuler;
};

inline scree::Granular<Models> physics_of(Options const& o) {
  auto const& m = o.material;
  scree::MuOfI<> const law{
      .elastic = {m.young, m.poisson, m.density}, .grains = {m.diameter}, .mu_s = m.mu_s, .mu_d = m.mu_d, .I0 = m.I0};
  return {.law = law,
          .viscosity_speed = o.numerics.viscosity_speed,
          .cfl = o.numerics.cfl,
          .forces = {scree::WallGuard{.speed = law.sound_speed()}}};
}

/// Reads a raster: with GDAL if scree was configured with it and the file does not end in .asc, otherwise as an ESRI
/// ASCII grid.
inline Raster read(std::filesystem::path const& file) {
#ifdef SCREE_HAS_GDAL
  if (file.extension() != ".asc") return scree::read_gdal(file);
#endif
  return scree::read_raster(file);
}

/// The ground and the material on the ground, in coordinates relative to the south-west corner of the raster.
struct Site {
  X corner;  // of the raster, m
  scree::HeightField ground;
  Raster depth;  // depth of the material at the start, m
  scree::Release release;
  Box<3> room;  // domain of the simulation, over the rectangle of the raster

  static Site read(Options const& o) {
    Raster const heights = terrain::read(o.ground.heights);
    X const corner(heights.x, heights.y, 0);
    scree::HeightField const ground(heights.moved(-corner[0], -corner[1]));
    Raster const depth = terrain::read(o.ground.release).moved(-corner[0], -corner[1]);
    Box<3> room = ground.extent();
    double const above = 4 * o.numerics.spacing + *std::max_element(depth.values.begin(), depth.values.end(), less);
    room.low[2] -= 10 * o.numerics.spacing, room.high[2] += above;
    return {corner, ground, depth, scree::Release(ground, depth), room};
  }
  /// Returns the height (m) of the surface of the material at the start.
  double surface(X const& x) const {
    double const d = depth(x[0], x[1]);
    return ground.height(x[0], x[1]) + (d > 0 ? d : 0);
  }
  /// Returns a raster that covers the ground, with NaN in every cell.
  Raster map(double cell) const {
    auto const points = [&](int axis) { return int((room.high[axis] - room.low[axis]) / cell) + 1; };
    Raster map{.name = "map", .columns = points(0), .rows = points(1), .x = 0, .y = 0, .spacing = cell};
    map.values.assign(std::size_t(map.columns) * std::size_t(map.rows), std::numeric_limits<double>::quiet_NaN());
    return map;
  }
  void write(std::filesystem::path const& file, Raster const& map) const {
    scree::write_raster(file, map.moved(corner[0], corner[1]));
  }

 private:
  static bool less(double a, double b) { return std::isnan(a) || a < b; }  // NaN sorts first
};

/// The greatest depth so far in each cell, and the time (s) at which the depth first exceeded `least`.
struct Footprint {
  Raster largest, arrival;
  double least;  // m

  Footprint(Raster const& like, double from) : largest(like), arrival(like), least(from) {
    std::fill(largest.values.begin(), largest.values.end(), 0.0);
  }
  void add(double time, Raster const& depth) {
    for (std::size_t k = 0; k < depth.values.size(); ++k) {
      largest.values[k] = std::max(largest.values[k], depth.values[k]);
      if (std::isnan(arrival.values[k]) && depth.values[k] > least) arrival.values[k] = time;
    }
  }
  double area() const {  // m^2
    auto const reached =
        std::count_if(largest.values.begin(), largest.values.end(), [&](double d) { return d > least; });
    return double(reached) * scree::sq(largest.spacing);
  }
  /// Returns all values for a checkpoint; take() restores them.
  std::vector<double> numbers() const {
    std::vector<double> all = largest.values;
    all.insert(all.end(), arrival.values.begin(), arrival.values.end());
    return all;
  }
  void take(std::vector<double> const& all) {
    std::size_t const n = largest.values.size();
    if (all.size() != 2 * n) throw std::runtime_error("the checkpoint holds maps of another size: keep output.cell");
    std::copy_n(all.begin(), n, largest.values.begin());
    std::copy_n(all.begin() + std::ptrdiff_t(n), n, arrival.values.begin());
  }
};

/// Returns a field of the particles on all ranks.
template <class S, class F>
auto values_of(S const& now, F field) {
  return now.whole().values(field);
}

/// The numbers in a row of history.csv.
struct Moment {
  double volume = 0, speed = 0, fastest = 0;  // m^3; mean, m/s; largest, m/s
  X centre = X::Zero();

  template <class S>
  explicit Moment(S const& now) {
    using namespace scree::fields;
    auto const V = values_of(now, scree::fields::volume);
    auto const x = values_of(now, position);
    auto const u = values_of(now, velocity);
    for (std::size_t k = 0; k < x.size(); ++k) {
      double const v = V[k], w = double(u[k].norm());
      volume += v, speed += v * w, fastest = std::max(fastest, w);
      centre += v * x[k].template cast<double>();
    }
    if (volume > 0) speed /= volume, centre /= volume;
  }
};

/// Returns the horizontal distance (m) of the farthest particle from the highest particle at the start, and the angle
/// (degrees) below the horizontal of the line between them.
template <class Points>
std::pair<double, double> reach(std::vector<X> const& start, Points const& points) {
  X const top = *std::max_element(start.begin(), start.end(), [](X const& a, X const& b) { return a[2] < b[2]; });
  double distance = 0, angle = 0;
  for (auto const& point : points) {
    X const way = point.template cast<double>() - top;
    double const along = std::hypot(way[0], way[1]);
    if (along > distance) distance = along, angle = std::atan2(-way[2], along);
  }
  return {distance, angle * 180 / std::numbers::pi};
}

/// Runs a case, or one rank of a case, and writes its maps, table and frames.
template <class P>
int simulate_rank(app::Run<Options> const& run, typename P::space const& space, app::Ranks<P> const& ranks) {
  using namespace scree::fields;
  using Real = typename P::real;
  using S = scree::Solver<P>;
  Options const& o = run.options;
  double const dr = o.numerics.spacing, began = scree::wall_seconds();
  Site const site = Site::read(o);
  auto const bed = scree::fill_measured(site.release, dr, site.room.low);
  auto const wall = scree::wall_around(complement(site.ground), dr, 3, site.room);
  S solver(space, {.spacing = dr, .physics = physics_of(o), .ranks = ranks}, scree::cast<Real>(bed.points),
           scree::cast<Real>(wall));
  solver.set(volume, bed.volumes, [](double v) { return Real(v); });
  solver.set(stress, bed.points, [&](X const& x) {
    scree::Geostatic const at_rest{site.surface(x), o.material.density, 9.81, 1};
    return scree::packed<3>(at_rest(x)).template cast<Real>().eval();
  });
  for (auto const& [side, axis, sign] :
       {std::tuple("west", 0, -1), {"east", 0, 1}, {"south", 1, -1}, {"north", 1, 1}}) {
    X const out = sign * X::Unit(axis);
    X const edge = (sign < 0 ? site.room.low : site.room.high) - 3 * dr * out;
    solver.drain({.name = side}, scree::Beyond<3>{edge, out});
  }
  solver.drain({.name = through_ground}, scree::Beyond<3>{site.room.low, {0, 0, -1}});
  auto const gone = [&](bool through) {  // volume lost through the ground, or beyond the edges
    double sum = 0;
    for (auto const& side : solver.left())
      if ((side.name == through_ground) == through) sum += side.volume;
    return sum;
  };
  auto const depth_of = [&](S const& now) { return scree::depth_map(site.map(o.output.cell), now); };

  app::Checkpoints checkpoints(run, o.output.checkpoints, o.output.restart_from);
  Footprint footprint(site.map(o.output.cell), o.output.least);
  app::Table const table{.file = "history.csv",
                         .columns = {{"time", "s"},
                                     {"volume", "m^3"},
                                     {"volume_gone", "m^3"},
                                     {"mean_speed", "m/s"},
                                     {"greatest_speed", "m/s"},
                                     {"centre_x", "m"},
                                     {"centre_y", "m"},
                                     {"centre_z", "m"},
                                     {"area", "m^2"}}};
  int maps = 0;
  checkpoints.keep(
      "footprint", [&] { return footprint.numbers(); }, [&](auto const& kept) { footprint.take(kept); });
  checkpoints.keep(
      "maps", [&] { return std::vector{double(maps)}; }, [&](auto const& kept) { maps = int(kept.at(0)); });
  checkpoints.restore(solver, o.output.duration, {table});
  auto const before = checkpoints.before();
  for (int k = 0; k < maps; ++k)
    if (auto const map = before / name_of_map(k); !std::filesystem::exists(map))
      throw std::runtime_error(map.string() + ": is missing beside the checkpoint");

  run.begin(solver);
  if (scree::writes_files() && checkpoints.restarts() && !std::filesystem::equivalent(before, run.output))
    for (int k = 0; k < maps; ++k)
      std::filesystem::copy_file(before / name_of_map(k), run.output / name_of_map(k),
                                 std::filesystem::copy_options::overwrite_existing);
  auto history = checkpoints.open(table);
  using Frames = scree::BodySeries<scree::Fields<scree::Velocity, scree::Pressure>>;
  auto frames = checkpoints.frames<Frames>();
  scree::Progress progress({.end = o.output.duration, .name = "t", .unit = 1, .quiet = run.quiet});
  scree::run_with(solver, o.output.duration,
                  {scree::every<S>(o.output.history,
                                   [&](S& now) {
                                     footprint.add(now.time(), depth_of(now));
                                     Moment const m(now);
                                     X const centre = m.centre + site.corner;
                                     history.row({now.time(), m.volume, gone(false), m.speed, m.fastest, centre[0],
                                                  centre[1], centre[2], footprint.area()});
                                   }),
                   scree::every<S>(o.output.maps,
                                   [&](S& now) {
                                     site.write(run.output / name_of_map(maps++), depth_of(now));
                                     frames.append(now);
                                   })},
                  progress, checkpoints);
  progress.finish(solver);
  checkpoints.save(solver.snapshot());

  site.write(run.output / "largest_depth.asc", footprint.largest);
  site.write(run.output / "arrival.asc", footprint.arrival);
  double const volume = site.release.exact_volume_below(site.room.high[2]).value();
  auto const [distance, angle] = reach(bed.points, values_of(solver, position));
  double const seconds = scree::wall_seconds() - began;
  Moment const last(solver);
  auto const figures = app::figures_of(solver);
  app::Json::Object summary = {{"particles_at_start", bed.points.size()},
                               {"released_volume", volume},
                               {"volume_on_ground", last.volume},
                               {"volume_gone", gone(false)},
                               {"volume_through_ground", gone(true)},
                               {"area", footprint.area()},
                               {"reach_angle_degrees", angle},
                               {"reach", distance},
                               {"maps", maps}};
  app::add_counts(summary, figures, seconds);
  app::add_packing(summary, figures.packing);
  scree::write_file(run.output / "summary.json", app::to_json(summary));
  if (!run.quiet)
    app::say(stdout,
             "{:.4g} m^3 covered {:.4g} m^2; the farthest grains are {:.4g} m away, at {:.1f} degrees below the top of "
             "the release; {:.3g} m^3 left the raster\nresults in {}\n",
             volume, footprint.area(), distance, angle, gone(false), run.output.string());
  if (gone(true) > 0)
    app::print_note(
        fmt::format("{:.3g} m^3 passed through the ground, single grains on its steps of wall particles", gone(true)));
  return checkpoints.exit_code();
}

template <class Real>
int simulate(app::Run<Options> const& run) {
  using P = app::AsCompiled<Formulation<Real>>;
  return app::run_ranks<P>(run, {}, run.options.numerics.ranks, simulate_rank<P>);
}

}  // namespace terrain
