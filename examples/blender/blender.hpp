// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case.hpp"

#include <scree/app/checkpoints.hpp>
#include <scree/app/figures.hpp>
#include <scree/app/list_of_sizes.hpp>
#include <scree/app/run_ranks.hpp>
#include <scree/app/say.hpp>
#include <scree/app/summary.hpp>
#include <scree/granular/segregating.hpp>
#include <scree/granular/wall_forces.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/io/write_file.hpp>
#include <scree/mixing/doucet.hpp>
#include <scree/mixing/lacey.hpp>
#include <scree/mixing/neighbours.hpp>
#include <scree/motion/composed.hpp>
#include <scree/motion/rotation_about.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/setup/measured_fill.hpp>
#include <scree/setup/mesh.hpp>
#include <scree/setup/walls.hpp>
#include <scree/solver/solver.hpp>
#include <scree/solver/wall_loads.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <vector>

// Grains of two or more sizes in a vessel that is read from a file and turns about a horizontal axis.
namespace blender {

/// The model of two grain sizes, small and large.
struct TwoSizes {
  using Grains = scree::BidisperseGrains;
  using Segregation = scree::ConservativeSegregation<scree::ShearRateClosure>;
  using Mixture = scree::Concentration;
  using Kinds = scree::TwoSizes;
  using Output = scree::Fields<scree::Concentration>;
  static Grains grains(Options const& o) { return {.d_small = o.material.d_small, .d_large = o.material.d_large}; }
  static Segregation segregation(Options const& o) {
    return {{.chi_V = o.segregation.chi_V,
             .chi_D = o.segregation.chi_D,
             .d_small = o.material.d_small,
             .d_large = o.material.d_large},
            scree::SegregationFlux::symmetric()};
  }
  static double mixed(Options const& o) { return o.segregation.share; }
  /// Returns the initial concentration of the particles [first, behind) of n, which are sorted by a coordinate and
  /// share the same value of it.
  static double apart(Options const& o, double first, double behind, double n) {
    return std::clamp((o.segregation.share * n - first) / (behind - first), 0.0, 1.0);
  }
  static double mean_diameter(Options const& o) {
    return o.segregation.share * o.material.d_small + (1 - o.segregation.share) * o.material.d_large;
  }
  /// Returns the index of the smallest grains.
  static int smallest(Options const&) { return 0; }
  template <class Real>
  static Real as(double C) {
    return Real(C);
  }
  template <class C>
  SCREE_FN static double share(C const& mixture, int) {
    return double(mixture);
  }
};
/// The model of the grain sizes in a list.
struct ListOfSizes : app::ListOfSizes {
  using Mixture = scree::Concentrations<species>;
  using Kinds = scree::SpeciesOf<species>;
  using Output = EachConcentration;
  static Grains grains(Options const& o) { return app::ListOfSizes::grains(o.species); }
  static Segregation segregation(Options const& o) { return app::ListOfSizes::segregation(o.species); }
  static auto mixed(Options const& o) { return o.species.mixed(); }
  static auto apart(Options const& o, double first, double behind, double n) {
    return o.species.layer(first / n, behind / n);
  }
  static double mean_diameter(Options const& o) { return o.species.mixed().dot(o.species.all_diameters()); }
  static int smallest(Options const& o) { return o.species.smallest(); }
  template <class Real>
  static scree::Vec<species, Real> as(scree::Vec<species, double> const& C) {
    return C.template cast<Real>();
  }
  template <class C>
  SCREE_FN static double share(C const& mixture, int k) {
    return double(mixture[k]);
  }
};

template <class Sizes>
struct Models : scree::GranularModels {
  using law = scree::VolumeMemory<scree::MuOfI<typename Sizes::Grains>>;
  using volume_control = scree::VolumeConsistency;
};
using Motion = scree::Composed<scree::RotationAbout, scree::RotationAbout>;

/// Passes for output: the forces on the vessel, and the neighbours of another kind.
template <class Kinds>
struct Diagnostics {
  template <class Physics>
  auto passes(scree::Resolution const& resolution, Physics const& physics) const {
    return std::tuple_cat(scree::WallForces{}.passes(resolution, physics),
                          scree::NeighbourMixing<Kinds>{}.passes(resolution));
  }
};

template <class Real, class Sizes>
struct Formulation : scree::Formulation<3, Real> {
  using physics = scree::SegregatingGranular<scree::Granular<Models<Sizes>>, typename Sizes::Segregation>;
  using integrator = scree::SymplecticEuler;
  using motion = Motion;
  using diagnostics = Diagnostics<typename Sizes::Kinds>;
  using carries = scree::Fields<scree::StartPosition>;
};

template <class Real, class Sizes>
typename Formulation<Real, Sizes>::physics physics_of(Options const& o) {
  auto const& m = o.material;
  scree::MuOfI<typename Sizes::Grains> const law{.elastic = {m.young, m.poisson, m.density},
                                                 .grains = Sizes::grains(o),
                                                 .mu_s = m.mu_s,
                                                 .mu_d = m.mu_d,
                                                 .I0 = m.I0,
                                                 .grain_density = m.grain_density};
  return {{.law = {law, true},
           .viscosity_speed = o.numerics.viscosity_speed,
           .cfl = o.numerics.cfl,
           .volume_control = {.per_strain = 3}},
          Sizes::segregation(o),
          segregation_period(o)};
}

/// Returns the motion of the vessel: rotation about the x axis and, in the rotating frame, about the vessel's own z
/// axis.
inline Motion motion_of(Options const& o) {
  return {.outer = {rate(o), {1, 0, 0}}, .inner = {o.vessel.own_speed * 2 * std::numbers::pi / 60, {0, 0, 1}}};
}

/// A functor that returns V, V C, V x and V C x, with the concentration C of the smallest grains and the first
/// coordinate x.
template <class Sizes>
struct PlacesOfSmall {
  int smallest;
  static constexpr int count = 4;
  using reads = scree::Fields<scree::Volume, typename Sizes::Mixture, scree::Position>;
  template <class I>
  SCREE_FN scree::Vec<4, double> operator()(I const& i) const {
    using namespace scree::fields;
    double const V = double(i[volume]), C = Sizes::share(i[typename Sizes::Mixture{}], smallest),
                 x = double(i[position][0]);
    return {V, V * C, V * x, V * C * x};
  }
};

/// Measures of how well the grains are mixed.
struct Mixture {
  double mean = 0;        ///< mean C of the smallest grains, -
  double intensity = 0;   ///< of segregation, 1: separated, 0: mixed
  double lacey = 0;       ///< Lacey's index; 0: separated, 1: as mixed as samples of this size can be
  double along = 0;       ///< mean x of the smallest grains minus mean x of all grains, m
  double neighbours = 0;  ///< unlike neighbours over the number in a perfect mixture
  double doucet = 0;      ///< Doucet's index; 1: order as at the start, 0: order lost
  int samples = 0;
};

/// Returns the measures of mixing. Samples are the cubes with edge length `edge` (m) that are more than half full.
/// `grain` is the bulk volume per grain (m^3).
template <class Sizes, class Solver>
Mixture mixture_of(Solver& solver, double edge, double grain, int smallest) {
  auto const intensity = scree::segregation_intensity(solver);
  auto const lacey = scree::lacey_index(solver, {.cell = edge, .grains = {grain}});
  auto const places = scree::sums_over(solver.whole(), PlacesOfSmall<Sizes>{smallest}, "the place of small grains");
  return {.mean = intensity.mean[smallest],
          .intensity = intensity.value,
          .lacey = lacey.index,
          .along = places[3] / places[1] - places[2] / places[0],
          .neighbours = scree::neighbour_index(solver).value,
          .doucet = scree::doucet_index(solver).index,
          .samples = lacey.samples};
}

/// Runs a case, or one rank of a case, and writes its table and frames.
template <class P, class Sizes>
int simulate_rank(app::Run<Options> const& run, typename P::space const& space, app::Ranks<P> const& ranks) {
  using namespace scree::fields;
  using Real = typename P::real;
  using S = scree::Solver<P>;
  Options const& o = run.options;
  double const dr = o.numerics.spacing, rho = o.material.density, began = scree::wall_seconds();
  scree::Mesh const vessel = scree::read_mesh(o.vessel.file, {.scale = o.vessel.scale});
  if (!vessel.report().closed)
    throw std::runtime_error(vessel.report().name + ": the vessel has open edges; a blender needs a closed one");
  if (!run.quiet) app::say(stdout, "{}", vessel.report().text(dr));
  scree::VolumeBelow<scree::Mesh> const below(vessel, dr);
  auto const bed = scree::fill_up_to(vessel, below, below.level_of(o.vessel.fill * below.total()), dr);
  scree::Groups<3> walls;
  walls.add("vessel", scree::wall_around(vessel, dr, 3));

  Motion const motion = motion_of(o);
  S solver(
      space,
      {.spacing = dr, .physics = physics_of<Real, Sizes>(o), .motion = motion, .sort_period = 20'000, .ranks = ranks},
      scree::cast<Real>(bed.points), walls);
  solver.set(volume, bed.volumes, [](double v) { return Real(v); });
  scree::Geostatic const at_rest{.surface_height = bed.level, .density = rho, .gravity = 9.81, .K0 = 1};
  solver.set(stress, bed.points,
             [&](auto const& x) { return scree::packed<3>(at_rest(x)).template cast<Real>().eval(); });
  solver.set(velocity, bed.points, [&](auto const& x) { return motion.velocity(x, 0).template cast<Real>().eval(); });
  // The sizes fill their shares of the bed from below or along x; particles with the same coordinate get the same
  // mixture.
  int const axis = o.segregation.start == Start::halves ? 0 : 2;
  std::vector<double> places;
  for (auto const& x : bed.points) places.push_back(x[axis]);
  std::sort(places.begin(), places.end());
  solver.set(typename Sizes::Mixture{}, bed.points, [&](auto const& x) {
    if (o.segregation.start == Start::mixed) return Sizes::template as<Real>(Sizes::mixed(o));
    auto const [first, behind] = std::equal_range(places.begin(), places.end(), x[axis]);
    return Sizes::template as<Real>(
        Sizes::apart(o, double(first - places.begin()), double(behind - places.begin()), double(places.size())));
  });

  double const mean_d = Sizes::mean_diameter(o);
  double const grain = std::numbers::pi / 6 * std::pow(mean_d, 3) * o.material.grain_density / rho;
  auto const mixture = [&](S& now) { return mixture_of<Sizes>(now, o.output.sample * dr, grain, Sizes::smallest(o)); };
  scree::mark_start(solver);
  Mixture const first = mixture(solver);
  double const duration = o.output.turns * turn(o);
  app::Checkpoints checkpoints(run, o.output.checkpoints, o.output.restart_from);
  app::Table const table{.file = "history.csv",
                         .columns = {{"turns"},
                                     {"lacey"},
                                     {"intensity"},
                                     {"along", "m"},
                                     {"mean"},
                                     {"torque", "N m"},
                                     {"power", "W"},
                                     {"speed", "m/s"},
                                     {"neighbours"},
                                     {"doucet"}},
                         .unit = turn(o)};
  checkpoints.restore(solver, duration, {table});

  run.begin(solver);
  double const set_up = scree::wall_seconds() - began, start = scree::wall_seconds();
  auto history = checkpoints.open(table);
  using Frames = scree::BodySeries<
      scree::Merge<scree::Fields<scree::Velocity>, typename Sizes::Output, scree::Fields<scree::ShearRate>>,
      scree::Bodies<scree::Material, scree::Wall>>;
  auto frames = checkpoints.frames<Frames>();
  scree::Progress progress({.end = o.output.turns, .name = "turns", .unit = turn(o), .quiet = run.quiet});
  scree::run_with(
      solver, duration,
      {scree::every<S>(o.output.history * turn(o),
                       [&](S& now) {
                         Mixture const m = mixture(now);
                         auto const load = scree::wall_load(now, walls, "vessel");
                         double speed = 0;
                         for (auto const& u : now.material().to_host(velocity))
                           speed = std::max(speed, double(u.norm()));
                         history.row({now.time() / turn(o), m.lacey, m.intensity, m.along, m.mean, -load.moment[0],
                                      -load.power, now.whole().largest(speed), m.neighbours, m.doucet});
                       }),
       scree::every<S>(o.output.frames * turn(o), [&](S& now) { frames.append(now); })},
      progress, checkpoints);
  progress.finish(solver);
  checkpoints.save(solver.snapshot());

  Mixture const last = mixture(solver);
  double const seconds = scree::wall_seconds() - start;
  auto const figures = app::figures_of(solver);
  double volume = 0;
  for (double const v : bed.volumes) volume += v;
  app::Json::Object summary;
  app::add_counts(summary, figures, seconds);
  summary.emplace_back("triangles", int(vessel.triangles().size()));
  summary.emplace_back("vessel_volume", below.total());
  summary.emplace_back("bed_volume", volume);
  summary.emplace_back("grains_of_a_dem", volume / grain);
  summary.emplace_back("set_up_seconds", set_up);
  summary.emplace_back("samples", last.samples);
  summary.emplace_back("lacey_at_start", first.lacey);
  summary.emplace_back("lacey", last.lacey);
  summary.emplace_back("intensity_at_start", first.intensity);
  summary.emplace_back("intensity", last.intensity);
  summary.emplace_back("drift_of_mean", last.mean - first.mean);
  summary.emplace_back("neighbours_at_start", first.neighbours);
  summary.emplace_back("neighbours", last.neighbours);
  summary.emplace_back("doucet", last.doucet);
  app::add_packing(summary, figures.packing);
  scree::write_file(run.output / "summary.json", app::to_json(summary));
  if (!run.quiet)
    app::say(stdout,
             "Lacey index {:.3f}, at the start {:.3f}; intensity of segregation {:.3f}, at the start {:.3f}; unlike "
             "neighbours {:.3f}, at the start {:.3f}; index of Doucet {:.3f}\n",
             last.lacey, first.lacey, last.intensity, first.intensity, last.neighbours, first.neighbours, last.doucet);
  return checkpoints.exit_code();
}

template <class Real, class Sizes>
int simulate(app::Run<Options> const& run) {
  using P = app::AsCompiled<Formulation<Real, Sizes>>;
  return app::run_ranks<P>(run, {}, run.options.numerics.ranks, simulate_rank<P, Sizes>);
}

}  // namespace blender
