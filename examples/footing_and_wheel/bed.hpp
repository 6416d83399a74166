// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case.hpp"

#include <scree/app/checkpoints.hpp>
#include <scree/app/figures.hpp>
#include <scree/app/run_ranks.hpp>
#include <scree/app/say.hpp>
#include <scree/app/summary.hpp>
#include <scree/fields/groups.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/io/write_file.hpp>
#include <scree/rigid/measured_mass.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/setup/rings.hpp>
#include <scree/solver/slip.hpp>
#include <scree/solver/solver.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <vector>

// A rigid strip or wheel on a bed of soil, and the force and moment that the soil exerts on it.
namespace footing_and_wheel {

using X = scree::Vec<2, double>;

struct Models : scree::GranularModels {
  using law = scree::VolumeMemory<scree::DruckerPrager>;
  using volume_control = scree::VolumeConsistency;
};
struct RigidTool : scree::RigidBody {
  static constexpr std::string_view name = "tool";
};
template <class Real>
struct Formulation : scree::Formulation<2, Real> {
  using physics = scree::Granular<Models>;
  using bodies = scree::Bodies<scree::Material, scree::Wall, RigidTool>;
  using integrator = scree::SymplecticEuler;
};

inline scree::Granular<Models> physics_of(Options const& o) {
  auto const& soil = o.soil;
  scree::MohrCoulomb const strength{radians(soil.friction_angle), soil.cohesion};
  bool const loose = soil.cohesion == 0;  // gaps open without resistance and have to close again
  scree::DruckerPrager const law{{soil.young, soil.poisson, soil.density}, scree::plane_strain_cone(strength)};
  return {.law = {law, loose},
          .gravity = {soil.gravity},
          .viscosity_speed = o.numerics.viscosity_speed,
          .cfl = o.numerics.cfl,
          .volume_control = {.per_strain = loose ? 3.0 : 0.0}};
}

/// The rigid body, its particles and the volumes of the particles (m^2).
struct Placed {
  scree::Rigid<2> rigid = {};
  scree::Groups<2> particles = {};
  std::vector<double> volumes = {};
};
inline Placed strip_of(Options const& o) {
  double const dr = o.numerics.spacing, half = o.strip.width / 2;
  scree::Box<2> const strip{{o.body.centre - half, o.bed.depth}, {o.body.centre + half, o.bed.depth + 4 * dr}};
  Placed placed;
  auto const points = scree::fill_lattice(strip, dr, strip.low);
  placed.particles.add("tool", points);
  placed.volumes.assign(points.size(), dr * dr);
  placed.rigid = scree::Rigid<2>{.properties = scree::mass_properties(strip, 2500, dr),
                                 .given_velocity = {0.0, -o.strip.speed},
                                 .given_turning = {0.0}};
  return placed;
}
inline Placed wheel_of(Options const& o) {
  scree::Ball<2> const disc{.centre = {o.body.centre, o.bed.depth + o.wheel.radius}, .radius = o.wheel.radius};
  auto const rings = scree::fill_rings(disc, o.numerics.spacing);
  double const mass = o.wheel.load / o.soil.gravity;
  Placed placed;
  placed.particles.add("tool", rings.points);
  placed.volumes = rings.volumes;
  placed.rigid.properties =
      scree::mass_properties(disc, mass / (std::numbers::pi * scree::sq(o.wheel.radius)), o.numerics.spacing);
  placed.rigid.given_turning = {-o.wheel.turning};
  if (o.wheel.slip) placed.rigid.given_velocity[0] = placed.rigid.velocity[0] = o.wheel.given_speed();
  return placed;
}
inline Placed placed(Options const& o) { return o.body.tool == Tool::strip ? strip_of(o) : wheel_of(o); }

/// Returns the particles of a rough floor and of smooth sides that are higher than the soil pushed up by the body.
inline scree::Groups<2> walls_of(Options const& o) {
  double const L = o.bed.length, top = 1.5 * o.bed.depth, t = 4 * o.numerics.spacing, dr = o.numerics.spacing;
  X const anchor(-t, -t);
  scree::Groups<2> walls;
  walls.add("floor", scree::fill_lattice(scree::Box<2>{{-t, -t}, {L + t, 0}}, dr, anchor));
  walls.add("left", scree::fill_lattice(scree::Box<2>{{-t, 0}, {0, top}}, dr, anchor));
  walls.add("right", scree::fill_lattice(scree::Box<2>{{L, 0}, {L + t, top}}, dr, anchor));
  return walls;
}

/// The state of the body at an instant or on average, with the forces and moments exerted by the soil, per metre of
/// depth.
struct Reading {
  double travel = 0, sinkage = 0, speed = 0, rising = 0;  // m, m, m/s, m/s
  double drawbar = 0, support = 0, torque = 0;            // N/m, N/m, N m/m; the torque drives the wheel
  double dissipated = 0;                                  // W/m; power transferred from the body to the soil

  template <class S>
  static Reading of(S const& now, X const& start) {
    using namespace scree::fields;
    auto const& states = now.template body<scree::RigidStates>();
    X const way = states.to_host(rigid_centre)[0] - start, u = states.to_host(rigid_velocity)[0];
    X const F = states.to_host(rigid_force)[0];
    double const M = states.to_host(rigid_moment)[0][0], w = states.to_host(angular_velocity)[0][0];
    return {way[0], -way[1], u[0], u[1], F[0], F[1], M, -F.dot(u) - M * w};
  }
  Reading& add(Reading const& o, double weight) {
    travel += weight * o.travel, sinkage += weight * o.sinkage, speed += weight * o.speed, rising += weight * o.rising;
    drawbar += weight * o.drawbar, support += weight * o.support, torque += weight * o.torque;
    dissipated += weight * o.dissipated;
    return *this;
  }
};

/// The mean reading over the last part of a run.
class Steady {
 public:
  explicit Steady(double from) : from_(from) {}
  void add(double time, Reading const& reading) {
    if (time >= from_) sum_.add(reading, 1), ++number_;
  }
  Reading mean() const { return number_ > 0 ? Reading{}.add(sum_, 1.0 / number_) : Reading{}; }
  /// Returns the sums for a checkpoint; take() restores them.
  std::vector<double> numbers() const {
    auto const sum = std::bit_cast<std::array<double, 8>>(sum_);
    std::vector<double> all(sum.begin(), sum.end());
    all.push_back(number_);
    return all;
  }
  void take(std::vector<double> const& all) {
    if (all.size() != 9) throw std::runtime_error("the checkpoint holds other sums of a steady run");
    std::array<double, 8> sum;
    std::copy_n(all.begin(), sum.size(), sum.begin());
    sum_ = std::bit_cast<Reading>(sum), number_ = int(all.back());
  }

 private:
  double from_;
  Reading sum_ = {};
  int number_ = 0;
};

inline void report(app::Run<Options> const& run, Reading const& mean, Reading const& last, app::Json::Object summary) {
  Options const& o = run.options;
  summary.emplace_back("sinkage", last.sinkage);
  summary.emplace_back("support", mean.support);
  summary.emplace_back("dissipated", mean.dissipated);
  if (o.body.tool == Tool::strip) {
    double const pressure = mean.support / o.strip.width, exact = bearing_capacity(o);
    summary.emplace_back("pressure", pressure);
    summary.emplace_back("bearing_capacity", exact);
    if (!run.quiet)
      app::say(stdout, "{:.4g} Pa carry the strip; weightless soil {:.4g} Pa (Prandtl)\n", pressure, exact);
  } else {
    double const slip = 1 - mean.speed / o.wheel.speed();
    summary.emplace_back("slip", slip);
    summary.emplace_back("travel", last.travel);
    summary.emplace_back("drawbar", mean.drawbar);
    summary.emplace_back("torque", mean.torque);
    if (!run.quiet)
      app::say(stdout, "slip {:.3f}: drawbar pull {:.4g} N/m, torque {:.4g} N m/m, sinkage {:.4g} m\n", slip,
               mean.drawbar, mean.torque, last.sinkage);
  }
  scree::write_file(run.output / "summary.json", app::to_json(summary));
}

/// Runs a case, or one rank of a case, and writes its table and frames.
template <class P>
int simulate_rank(app::Run<Options> const& run, typename P::space const& space, app::Ranks<P> const& ranks) {
  using namespace scree::fields;
  using Real = typename P::real;
  using S = scree::Solver<P>;
  using scree::particles_of;
  Options const& o = run.options;
  double const dr = o.numerics.spacing, end = o.output.duration, began = scree::wall_seconds();
  Placed const tool = placed(o);
  auto const walls = walls_of(o);
  scree::Box<2> const soil{{0, 0}, {o.bed.length, o.bed.depth}};
  scree::RigidBodies<2> rigid;
  rigid.bodies = {tool.rigid};
  S solver(space, {.spacing = dr, .physics = physics_of(o), .rigid = rigid, .ranks = ranks},
           particles_of<scree::Material>(scree::cast<Real>(scree::fill_lattice(soil, dr, X(0, 0)))),
           particles_of<scree::Wall>(walls), particles_of<RigidTool>(tool.particles));
  scree::set_slip(solver, walls, "left", X(1, 0));
  scree::set_slip(solver, walls, "right", X(-1, 0));
  solver.template set<RigidTool>(volume, tool.volumes, [](double v) { return Real(v); });
  double const K0 = 1 - std::sin(radians(o.soil.friction_angle));  // Jaky (1944)
  scree::Geostatic const at_rest{o.bed.depth, o.soil.density, o.soil.gravity, K0};
  solver.set(stress, [&](auto const& x) {
    return scree::packed<2>(scree::Mat<3, double>(at_rest(x))).template cast<Real>().eval();
  });

  Steady steady((o.body.tool == Tool::strip ? 0.8 : 0.5) * end);
  app::Checkpoints checkpoints(run, o.output.checkpoints, o.output.restart_from);
  checkpoints.keep(
      "steady", [&] { return steady.numbers(); }, [&](auto const& kept) { steady.take(kept); });
  app::Table const table{.file = "history.csv",
                         .columns = {{"time", "s"},
                                     {"travel", "m"},
                                     {"sinkage", "m"},
                                     {"speed", "m/s"},
                                     {"drawbar", "N/m"},
                                     {"support", "N/m"},
                                     {"torque", "N m/m"},
                                     {"dissipated", "W/m"}}};
  checkpoints.restore(solver, end, {table});
  run.begin(solver);
  auto history = checkpoints.open(table);
  using Frames = scree::BodySeries<scree::Fields<scree::Velocity, scree::Pressure>,
                                   scree::Bodies<scree::Material, scree::Wall, RigidTool>>;
  auto frames = checkpoints.frames<Frames>();
  scree::Progress progress({.end = end, .name = "t", .unit = 1, .quiet = run.quiet});
  X const start = tool.rigid.properties.centre;
  scree::run_with(
      solver, end,
      {scree::every<S>(
           o.output.interval,
           [&](S& now) {
             auto const r = Reading::of(now, start);
             steady.add(now.time(), r);
             history.row({now.time(), r.travel, r.sinkage, r.speed, r.drawbar, r.support, r.torque, r.dissipated});
           }),
       scree::every<S>(o.output.frames, [&](S& now) { frames.append(now); })},
      progress, checkpoints);
  progress.finish(solver);
  checkpoints.save(solver.snapshot());
  app::Json::Object summary;
  auto const figures = app::figures_of(solver);
  app::add_counts(summary, figures, scree::wall_seconds() - began);
  app::add_packing(summary, figures.packing);
  report(run, steady.mean(), Reading::of(solver, start), summary);
  return checkpoints.exit_code();
}

template <class Real>
int simulate(app::Run<Options> const& run) {
  using P = app::AsCompiled<Formulation<Real>>;
  return app::run_ranks<P>(run, {}, run.options.numerics.ranks, simulate_rank<P>);
}

}  // namespace footing_and_wheel
