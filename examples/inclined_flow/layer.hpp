// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case.hpp"

#include <scree/app/figures.hpp>
#include <scree/app/profile.hpp>
#include <scree/app/run_ranks.hpp>
#include <scree/app/say.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/laws/mu_of_i.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// A layer on a rough floor in plane strain, periodic down the slope, and the exact solution of its flow.
namespace inclined_flow {

/// The steady uniform flow of a mu(I) material down a rough plane in plane strain. The shear stress rho g sin(theta)(H
/// - y) is tan(theta) times the pressure p = rho g cos(theta)(H - y) everywhere, so the friction, and with it I, is
/// uniform. The shear rate I sqrt(p/rho_s)/d then integrates to Bagnold's profile. The friction coefficient in plane
/// shear is k_mu, not mu.
struct Bagnold {
  scree::MuOfI<> law;
  double angle = 0;  ///< theta, rad
  double depth = 0;  ///< H, m
  double gravity = 9.81;

  /// Returns the mu that solves k = 3 mu/sqrt(9 + 12 mu^2), where k is tan(theta). The result is not finite for k >=
  /// sqrt(3)/2.
  static double friction_for(double k) { return 3 * k / std::sqrt(9 - 12 * k * k); }

  /// Returns the angle (rad) at which flow starts, with tan(theta) = k_mu at rest. Flow is steady up to
  /// greatest_angle(), with k_mu at large I.
  double least_angle() const { return std::atan(scree::friction_ratio(law.mu_s)); }
  double greatest_angle() const { return std::atan(scree::friction_ratio(law.mu_d)); }

  double pressure(double y) const {
    return law.density() * gravity * std::cos(angle) * std::clamp(depth - y, 0.0, depth);
  }
  double shear_stress(double y) const { return std::tan(angle) * pressure(y); }
  double inertial_number() const {
    double const mu = friction_for(std::tan(angle));
    return law.I0 * (mu - law.mu_s) / (law.mu_d - mu);
  }
  double velocity(double y) const {
    double const fraction = law.density() / law.grain_density, left = 1 - std::clamp(y / depth, 0.0, 1.0);
    double const scale = std::sqrt(fraction * gravity * std::cos(angle)) * std::pow(depth, 1.5);
    return 2.0 / 3 * inertial_number() / law.grains.diameter * scale * (1 - std::pow(left, 1.5));
  }
  /// Returns the kinematic viscosity for small changes of the shear rate, (1/rho) dtau/d(shear rate), at half depth,
  /// m^2/s. Other viscosities are compared with this value, which also sets the settling time of the profile.
  double differential_viscosity() const {
    double const I = inertial_number(), p = pressure(depth / 2), mu = friction_for(std::tan(angle));
    double const dmu_dI = (law.mu_d - law.mu_s) * law.I0 / scree::sq(law.I0 + I);
    double const dk_dmu = 27 / std::pow(9 + 12 * mu * mu, 1.5);
    return p * dk_dmu * dmu_dI * law.grains.diameter / std::sqrt(p / law.grain_density) / law.density();
  }
  /// Returns the decay time (s) of the slowest disturbance of a layer that is fixed at the bottom and free at the top.
  double settling_time() const { return scree::sq(2 * depth / 3.14159265358979) / differential_viscosity(); }
};

/// Granular models with a viscosity that keeps the particle rows in order and vanishes in steady flow.
struct Models : scree::GranularModels {
  using viscosity = scree::ResidualViscosity;
};
using Physics = scree::Granular<Models>;

template <class Real>
struct Formulation : scree::Formulation<2, Real> {
  using physics = Physics;
  using integrator = scree::SymplecticEuler;
};

/// Returns grains with the density of Zhu et al. (2024), Table 1, and the wave speed `sound_speed` (m/s).
inline scree::MuOfI<> beads(double sound_speed, double diameter) {
  double const nu = 0.3, rho = 1500;
  double const young = rho * scree::sq(sound_speed) * (1 + nu) * (1 - 2 * nu) / (1 - nu);
  return {.elastic = {young, nu, rho}, .grains = {diameter}};
}

struct Numbers {
  int rows = 20;                 ///< rows of particles over the depth
  double viscosity_speed = 0.5;  ///< m/s
  double cfl = 0.4;
  double start = 1;  ///< initial velocity over the exact velocity
};

/// Returns the solver of a layer ten spacings long that starts with the stress of the exact flow.
template <class P>
scree::Solver<P> layer(Bagnold const& flow, Numbers const& numbers, typename P::space const& space,
                       app::Ranks<P> const& ranks) {
  using namespace scree::fields;
  using Real = typename P::real;
  double const dr = flow.depth / numbers.rows, length = 10 * dr;
  Physics const physics{.law = flow.law,
                        .gravity = {flow.gravity, flow.angle},
                        .viscosity_speed = numbers.viscosity_speed,
                        .cfl = numbers.cfl};
  scree::Solver<P> solver(space, {.spacing = dr, .physics = physics, .periods = {{0, 0, length}}, .ranks = ranks},
                          scree::cast<Real>(scree::fill_lattice(scree::Box<2>{{0, 0}, {length, flow.depth}}, dr)),
                          scree::cast<Real>(scree::fill_lattice(scree::Box<2>{{0, -4 * dr}, {length, 0}}, dr)));
  solver.set(stress, [&](auto const& x) {
    Real const p = Real(flow.pressure(x[1]));
    return scree::Vec<4, Real>(-p, -p, -p, Real(flow.shear_stress(x[1])));
  });
  solver.set(velocity,
             [&](auto const& x) { return scree::Vec<2, Real>(Real(numbers.start * flow.velocity(x[1])), 0); });
  return solver;
}

inline Bagnold flow_of(Options const& o) {
  auto law = beads(o.numerics.sound_speed, o.slope.diameter);
  law.mu_s = o.model.mu_s, law.mu_d = o.model.mu_d, law.I0 = o.model.I0;
  return {.law = law, .angle = o.slope.angle * std::numbers::pi / 180, .depth = o.slope.depth * o.slope.diameter};
}

/// Means over slices as thick as a row, from the bottom: height (in H), velocity (m/s), exact velocity (m/s) and
/// pressure over the exact pressure; and two measures of the error.
struct Profile {
  std::vector<std::array<double, 4>> slices = {};
  double deviation = 0;  ///< largest relative one from the exact velocity, 0.2 H to 0.8 H
  double ratio = 0;      ///< mean velocity over the mean exact velocity
};

template <class S>
Profile profile_of(S const& solver, Bagnold const& flow, int rows) {
  using namespace scree::fields;
  struct Slice {
    double number = 0, height = 0, velocity = 0, exact = 0, pressure = 0;
  };
  auto const [x, u, sigma] = solver.whole().values(position, velocity, stress);
  std::vector<Slice> slices(std::size_t(rows) + 1);  // the last slice has everything above the layer
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const row = std::clamp(x[i][1] / flow.depth * rows, 0.0, double(rows));
    Slice& s = slices[std::size_t(row)];
    s.number += 1, s.height += x[i][1], s.velocity += u[i][0], s.exact += flow.velocity(x[i][1]);
    s.pressure -= (sigma[i][0] + sigma[i][1] + sigma[i][2]) / 3 / flow.pressure(x[i][1]);
  }
  Profile profile;
  double all = 0, exact = 0;
  for (Slice const& s : slices) {
    if (s.number == 0) continue;
    double const height = s.height / s.number / flow.depth, off = s.velocity / s.exact - 1;
    profile.slices.push_back({height, s.velocity / s.number, s.exact / s.number, s.pressure / s.number});
    if (height > 0.2 && height < 0.8 && std::abs(off) > std::abs(profile.deviation)) profile.deviation = off;
    all += s.velocity, exact += s.exact;
  }
  profile.ratio = all / exact;
  return profile;
}

/// Runs a case, or one rank of a case, and writes its tables and frames.
template <class P>
int simulate_rank(app::Run<Options> const& run, typename P::space const& space, app::Ranks<P> const& ranks) {
  Options const& o = run.options;
  Bagnold const flow = flow_of(o);
  int const rows = o.numerics.rows;
  auto solver = layer<P>(
      flow, {.rows = rows, .viscosity_speed = o.model.viscosity_speed, .cfl = o.numerics.cfl, .start = o.slope.start},
      space, ranks);
  using S = decltype(solver);
  double const unit = flow.settling_time();

  double const duration = o.output.duration * unit;
  app::Checkpoints checkpoints(run, o.output.checkpoints, o.output.restart_from);
  app::Table const table{
      .file = "history.csv", .columns = {{"time", "s"}, "mean_velocity_ratio", "deviation_of_core"}, .unit = unit};
  checkpoints.restore(solver, duration, {table});
  run.begin(solver);
  if (auto const note = note_on_law(o); !note.empty()) app::print_note(note);
  auto history = checkpoints.open(table);
  auto frames = checkpoints.frames<scree::BodySeries<scree::Fields<scree::Velocity, scree::Pressure>>>();
  scree::Progress progress({.end = o.output.duration, .name = "t/settling time", .unit = unit, .quiet = run.quiet});
  double const start = scree::wall_seconds();
  scree::Profiler const profiler(solver);
  scree::run_with(solver, duration,
                  {scree::every<S>(o.output.interval * unit,
                                   [&](S& now) {
                                     Profile const profile = profile_of(now, flow, rows);
                                     history.row({now.time(), profile.ratio, profile.deviation});
                                     frames.append(now);
                                   })},
                  progress, checkpoints);
  progress.finish(solver);
  checkpoints.save(solver.snapshot());
  app::print_profile(run, profiler, solver);

  Profile const last = profile_of(solver, flow, rows);
  scree::CsvSeries core(run.output / "profile.csv",
                        {{"height", "H"}, {"velocity", "m/s"}, {"exact_velocity", "m/s"}, {"pressure_ratio"}});
  for (auto const& slice : last.slices) core.row(slice);
  double const seconds = scree::wall_seconds() - start;
  report(run, {.deviation = last.deviation,
               .ratio = last.ratio,
               .settling_time = unit,
               .granular_viscosity = flow.differential_viscosity(),
               .figures = app::figures_of(solver),
               .wall_seconds = seconds});
  return checkpoints.exit_code();
}

template <class Real>
int simulate(app::Run<Options> const& run) {
  using P = app::AsCompiled<Formulation<Real>>;
  return app::run_ranks<P>(run, {}, run.options.numerics.ranks, simulate_rank<P>);
}

}  // namespace inclined_flow
