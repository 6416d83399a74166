// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case.hpp"

#include <scree/app/checkpoints.hpp>
#include <scree/app/figures.hpp>
#include <scree/app/list_of_sizes.hpp>
#include <scree/app/profile.hpp>
#include <scree/app/run_ranks.hpp>
#include <scree/app/say.hpp>
#include <scree/app/summary.hpp>
#include <scree/fields/groups.hpp>
#include <scree/granular/segregating.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/io/write_file.hpp>
#include <scree/mixing/lacey.hpp>
#include <scree/motion/motion_of_groups.hpp>
#include <scree/motion/tabulated.hpp>
#include <scree/openings/regions.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

// A silo whose gate drops. Material that falls through the outlet is removed, and its mass and grain sizes are
// recorded.
namespace silo {

template <int Dim>
using Drop = scree::Tabulated<Dim, 2>;  // a table of two displacements

/// The model of two grain sizes, with small grains above large ones.
struct TwoSizes {
  static constexpr int kinds = 1;  // kinds whose masses are reported: the small grains
  using Grains = scree::BidisperseGrains;
  using Segregation = scree::ConservativeSegregation<scree::ShearRateClosure>;
  using Mixture = scree::Concentration;
  using Output = scree::Fields<scree::Concentration>;
  static Grains grains(Options const& o) { return {.d_small = o.material.d_small, .d_large = o.material.d_large}; }
  static Segregation segregation(Options const& o) {
    return {{.d_small = o.material.d_small, .d_large = o.material.d_large}, scree::SegregationFlux::symmetric()};
  }
  /// Returns the concentration of a particle at height z (m) at the start.
  static double start(Options const& o, double z) { return z > (1 - o.material.share) * o.geometry.height ? 1.0 : 0.0; }
  static double share(double C, int) { return C; }
  static std::string name(char const* what, int) { return fmt::format("C_{}", what); }
};
/// The model of the grain sizes in a list, one layer for each size.
struct ListOfSizes : app::ListOfSizes {
  static constexpr int kinds = species;
  using Mixture = scree::Concentrations<species>;
  using Output = EachConcentration;
  static Grains grains(Options const& o) { return app::ListOfSizes::grains(o.species); }
  static Segregation segregation(Options const& o) { return app::ListOfSizes::segregation(o.species); }
  static auto start(Options const& o, double z) {
    double const half = o.numerics.spacing / 2, H = o.geometry.height;
    return o.species.layer((z - half) / H, (z + half) / H);
  }
  template <class C>
  static double share(C const& mixture, int k) {
    return mixture[k];
  }
  static std::string name(char const* what, int k) { return fmt::format("C{}_{}", k + 1, what); }
};

template <class Sizes>
struct Models : scree::GranularModels {
  using law = scree::MuOfI<typename Sizes::Grains>;
};
template <int Dim, class Sizes>
struct Formulation : scree::Formulation<Dim> {
  using physics = scree::SegregatingGranular<scree::Granular<Models<Sizes>>, typename Sizes::Segregation>;
  using integrator = scree::SymplecticEuler;
  using motion = scree::MotionOfGroups<2, Drop<Dim>>;
};

template <class Sizes>
typename Formulation<2, Sizes>::physics physics_of(Options const& o) {
  auto const& m = o.material;
  scree::MuOfI<typename Sizes::Grains> const law{
      .elastic = {m.young, 0.3, m.density}, .grains = Sizes::grains(o), .mu_s = m.mu_s, .mu_d = m.mu_d};
  return {
      {.law = law, .viscosity_speed = o.numerics.viscosity_speed, .cfl = o.numerics.cfl}, Sizes::segregation(o), 10};
}

/// Returns the outlet, extended upwards and downwards (m).
template <int Dim>
auto outlet_of(Options const& o) {
  double const middle = o.geometry.width / 2, radius = o.geometry.outlet / 2, far = 2 * o.geometry.height;
  if constexpr (Dim == 2)
    return scree::Box<2>{{middle - radius, -far}, {middle + radius, far}};
  else
    return scree::Cylinder{2, {middle, middle, 0}, radius, -far, far};
}

/// Returns the wall particles: a floor four spacings thick with an outlet, the sides, and the gate in the outlet.
template <int Dim>
scree::Groups<Dim> walls_of(Options const& o) {
  using X = scree::Vec<Dim, double>;
  double const dr = o.numerics.spacing, W = o.geometry.width, thick = 4 * dr, top = o.geometry.height + 5 * dr;
  scree::Box<Dim> inner{X::Zero(), X::Constant(W)}, outer{X::Constant(-thick), X::Constant(W + thick)};
  inner.high[Dim - 1] = 2 * top, outer.high[Dim - 1] = top;
  scree::Box<Dim> floor = outer;
  floor.high[Dim - 1] = 0;
  auto const outlet = outlet_of<Dim>(o);
  X const anchor = outer.low;
  scree::Groups<Dim> walls;
  walls.add("silo", scree::fill_lattice(outer - inner - (outlet & floor), dr, anchor));
  walls.add("gate", scree::fill_lattice(floor & outlet, dr, anchor));
  return walls;
}

/// The mass balance between the grains that have left through the outlet and the grains inside, in total and for some
/// kinds of grains. Masses are in kg, or in kg/m in the plane.
template <class Sizes>
class Discharge {
 public:
  static constexpr int kinds = Sizes::kinds;
  struct Grains {
    double mass = 0;
    std::array<double, kinds> of_kind = {};
    template <class C>
    void add(double more, C const& mixture) {
      mass += more;
      for (int k = 0; k < kinds; ++k) of_kind[std::size_t(k)] += more * Sizes::share(mixture, k);
    }
  };
  template <class C>
  void leaves(double mass, C const& mixture) {
    now_.out.add(mass, mixture);
  }

  /// The rate of discharge since the last call of add() and the share of each kind in the discharge. add() takes the
  /// time (s) and the grains inside.
  struct Rate {
    double rate = 0;
    std::array<double, kinds> shares = {};
  };
  Rate add(double time, Grains const& in) {
    auto& [start, out, before, at_begin, at_end, time_before, begun, ended, drift, drift_of_kinds] = now_;
    if (time == 0) start = in;
    drift = std::max(drift, std::abs(in.mass + out.mass - start.mass) / start.mass);
    double const passed = out.mass - before.mass, span = time - time_before;
    Rate found{.rate = span > 0 ? passed / span : 0};
    for (std::size_t k = 0; k < kinds; ++k) {
      double const off = in.of_kind[k] + out.of_kind[k] - start.of_kind[k];
      drift_of_kinds = std::max(drift_of_kinds, std::abs(off) / start.mass);
      found.shares[k] = passed > 0 ? (out.of_kind[k] - before.of_kind[k]) / passed : none;
    }
    before = out, time_before = time;
    if (std::isnan(begun) && out.mass > 0.1 * start.mass) begun = time, at_begin = out;
    if (out.mass < 0.4 * start.mass) ended = time, at_end = out;
    return found;
  }
  double at_start() const { return now_.start.mass; }
  double out() const { return now_.out.mass; }
  double drift() const { return now_.drift; }                    ///< largest error of the total mass, relative
  double drift_of_kinds() const { return now_.drift_of_kinds; }  ///< largest error of the mass of a kind, relative
  /// Returns the mean rate of discharge (kg/s, in the plane kg/(m s)) from when a tenth of the mass has left until two
  /// fifths have left.
  double steady_rate() const { return (now_.at_end.mass - now_.at_begin.mass) / (now_.ended - now_.begun); }

  /// Returns all numbers for a checkpoint; take() restores them.
  std::vector<double> numbers() const {
    auto const all = std::bit_cast<Numbers>(now_);
    return {all.begin(), all.end()};
  }
  void take(std::vector<double> const& kept) {
    Numbers all;
    if (kept.size() != all.size()) throw std::runtime_error("the checkpoint holds other numbers of the discharge");
    std::copy(kept.begin(), kept.end(), all.begin());
    now_ = std::bit_cast<State>(all);
  }

 private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  struct State {
    Grains start, out, before, at_begin, at_end;
    double time_before = 0, begun = none, ended = none;  // s
    double drift = 0, drift_of_kinds = 0;
  };
  using Numbers = std::array<double, sizeof(State) / sizeof(double)>;
  State now_;
};

/// Runs a case, or one rank of a case, and writes its table and frames.
template <class P, class Sizes>
int simulate_rank(app::Run<Options> const& run, typename P::space const& space, app::Ranks<P> const& ranks) {
  using namespace scree::fields;
  using S = scree::Solver<P>;
  constexpr int Dim = P::dim;
  using X = scree::Vec<Dim, double>;
  Options const& o = run.options;
  double const dr = o.numerics.spacing, rho = o.material.density, H = o.geometry.height;
  X const up = X::Unit(Dim - 1);
  auto const walls = walls_of<Dim>(o);
  scree::Box<Dim> filling{X::Zero(), X::Constant(o.geometry.width)};
  filling.high[Dim - 1] = H;
  typename P::motion motion(walls);
  motion.set(walls.number("gate"), Drop<Dim>({o.output.opens, o.output.opens + 0.1}, {X(X::Zero()), X(-2 * H * up)}));

  S solver(space, {.spacing = dr, .physics = physics_of<Sizes>(o), .motion = motion, .lost_share = 1, .ranks = ranks},
           scree::fill_lattice(filling, dr, X(X::Constant(-4 * dr))), walls);
  scree::Geostatic const at_rest{H, rho, 9.81, 0.75};
  solver.set(stress, [&](auto const& x) { return scree::packed<Dim>(scree::Mat<3, double>(at_rest(x))); });
  typename Sizes::Mixture const mixture{};
  solver.set(mixture, [&](auto const& x) { return Sizes::start(o, x[Dim - 1]); });
  Discharge<Sizes> discharge;
  solver.drain({.name = "outlet", .reach = dr / 2}, scree::Beyond<Dim>{X(-8 * dr * up), X(-up)},
               scree::Fields<scree::Volume, typename Sizes::Mixture>{}, [&](double, auto const& fallen) {
                 for (auto const& each : fallen) discharge.leaves(rho * each[volume], each[mixture]);
               });

  app::Checkpoints checkpoints(run, o.output.checkpoints, o.output.restart_from);
  checkpoints.keep(
      "discharge", [&] { return discharge.numbers(); }, [&](auto const& kept) { discharge.take(kept); });
  app::Table table{.file = "history.csv",
                   .columns = {{"time", "s"},
                               {"mass_in", Dim == 2 ? "kg/m" : "kg"},
                               {"mass_out", Dim == 2 ? "kg/m" : "kg"},
                               {"rate", Dim == 2 ? "kg/(m s)" : "kg/s"},
                               {"beverloo"}}};
  int const told = o.species.empty() ? 1 : o.species.count();
  for (int k = 0; k < told; ++k)
    for (char const* what : {"out", "in"}) table.columns.emplace_back(Sizes::name(what, k));
  for (char const* name : {"intensity", "lacey"}) table.columns.emplace_back(name);
  checkpoints.restore(solver, o.output.duration, {table});
  run.begin(solver);
  auto history = checkpoints.open(table);
  using Frames = scree::BodySeries<
      scree::Merge<scree::Fields<scree::Velocity>, typename Sizes::Output, scree::Fields<scree::Pressure>>,
      scree::Bodies<scree::Material, scree::Wall>>;
  auto frames = checkpoints.frames<Frames>();
  scree::Progress progress({.end = o.output.duration, .quiet = run.quiet});
  double const start = scree::wall_seconds();
  scree::Profiler const profiler(solver);
  scree::run_with(
      solver, o.output.duration,
      {scree::every<S>(
           o.output.interval,
           [&](S& now) {
             auto const [V, C] = now.whole().values(volume, mixture);
             typename Discharge<Sizes>::Grains in;
             for (std::size_t i = 0; i < V.size(); ++i) in.add(rho * V[i], C[i]);
             auto const [rate, shares] = discharge.add(now.time(), in);
             std::vector<double> row = {now.time(), in.mass, discharge.out(), rate, beverloo(o, rate)};
             for (std::size_t k = 0; k < std::size_t(told); ++k)
               row.insert(row.end(), {shares[k], in.mass > 0 ? in.of_kind[k] / in.mass : std::nan("")});
             row.insert(row.end(), {scree::segregation_intensity(now).value, scree::lacey_index(now).index});
             history.row(row);
           }),
       scree::every<S>(o.output.frames, [&](S& now) { frames.append(now); })},
      progress, checkpoints);
  progress.finish(solver);
  checkpoints.save(solver.snapshot());
  app::print_profile(run, profiler, solver);

  double const rate = discharge.steady_rate();
  app::Json::Object summary;
  double const seconds = scree::wall_seconds() - start;
  auto const figures = app::figures_of(solver);
  summary.emplace_back("particles_at_start", int(figures.particles + solver.turnover().removed));
  summary.emplace_back("removed", int(solver.turnover().removed));
  app::add_counts(summary, figures, seconds);
  summary.emplace_back("mass_at_start", discharge.at_start());
  summary.emplace_back("mass_out", discharge.out());
  summary.emplace_back("largest_error_of_mass", discharge.drift());
  summary.emplace_back(o.species.empty() ? "largest_error_of_small" : "largest_error_of_a_size",
                       discharge.drift_of_kinds());
  summary.emplace_back("rate", rate);
  summary.emplace_back("beverloo", beverloo(o, rate));
  summary.emplace_back("intensity_inside", scree::segregation_intensity(solver).value);
  summary.emplace_back("lacey_inside", scree::lacey_index(solver).index);
  app::add_packing(summary, figures.packing);
  scree::write_file(run.output / "summary.json", app::to_json(summary));
  if (!run.quiet)
    app::say(stdout, "rate {:.4g} {}, {:.3f} rho sqrt(g) D^{}; {:.1f} % has left\n", rate,
             Dim == 2 ? "kg/(m s)" : "kg/s", beverloo(o, rate), Dim == 2 ? "3/2" : "5/2",
             100 * discharge.out() / discharge.at_start());
  return checkpoints.exit_code();
}

template <int Dim, class Sizes>
int simulate(app::Run<Options> const& run) {
  using P = app::AsCompiled<Formulation<Dim, Sizes>>;
  return app::run_ranks<P>(run, {}, run.options.numerics.ranks, simulate_rank<P, Sizes>);
}

}  // namespace silo
