// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case.hpp"

#include <scree/app/figures.hpp>
#include <scree/app/profile.hpp>
#include <scree/app/run_ranks.hpp>
#include <scree/granular/granular.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/csv_series.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/geostatic.hpp>
#include <scree/setup/lattice.hpp>
#include <scree/solver/solver.hpp>

#include <cstddef>
#include <numbers>
#include <vector>

// The collapse of a granular column: half a column in the plane, a quarter of a cylinder in 3D. Smooth walls represent
// the planes of symmetry; the floor is rough.
namespace column_collapse {

using Physics = scree::Granular<>;

template <int Dim, class Real = double>
struct Formulation : scree::Formulation<Dim, Real> {
  using physics = Physics;
  using integrator = scree::SymplecticEuler;
};

struct Column {
  double aspect = 2;        ///< a = H0/L0
  double width = 0.05;      ///< L0, half the width or the radius, m
  double spacing = 0.0025;  ///< particle spacing, m
  double reach = 5;         ///< end of the floor, in L0
  double gravity = 9.81;    ///< m/s^2
  double height() const { return aspect * width; }
  double fall_time() const { return std::sqrt(height() / gravity); }  ///< sqrt(H0/g), s
};

/// Returns mu for a measured friction k_mu in plane shear (the tangent of the friction angle).
inline double mu_for(double k) { return 3 * k / std::sqrt(9 - 12 * k * k); }

/// Returns beads as in Zhu et al. (2024), Table 1, but with a wave speed of 12 sqrt(g H0), at which the foot of the
/// column is compressed by one per cent. `mu_s` and `mu_d` are values of mu, see mu_for().
inline scree::MuOfI<> beads(Column const& column, double mu_s, double mu_d) {
  double const nu = 0.3, rho = 1500, c = 12 * std::sqrt(column.gravity * column.height());
  double const young = rho * c * c * (1 + nu) * (1 - 2 * nu) / (1 - nu);
  return {.elastic = {young, nu, rho}, .grains = {0.5e-3}, .mu_s = mu_s, .mu_d = mu_d};
}

template <int Dim>
std::vector<scree::Vec<Dim, double>> grains(Column const& column) {
  scree::Box<Dim> corner{scree::Vec<Dim, double>::Zero(), scree::Vec<Dim, double>::Constant(column.width)};
  corner.high[Dim - 1] = column.height();
  if constexpr (Dim == 2) {
    return scree::fill_lattice(corner, column.spacing);
  } else {
    scree::Cylinder const cylinder{2, scree::Vec<3, double>::Zero(), column.width, 0, column.height()};
    return scree::points_within(scree::fill_lattice(corner, column.spacing), cylinder);
  }
}

/// Returns the particles of the floor and of the planes of symmetry, three rows each. The planes are higher than the
/// column; the floor extends beyond the run-out.
template <int Dim>
std::vector<scree::Vec<Dim, double>> walls(Column const& column) {
  double const dr = column.spacing, thick = 3 * dr, far = column.reach * column.width;
  auto const all = scree::Vec<Dim, double>::Constant(1);
  scree::Box<Dim> floor{-thick * all, far * all};
  floor.high[Dim - 1] = 0;
  auto points = scree::fill_lattice(floor, dr);
  for (int axis = 0; axis < Dim - 1; ++axis) {
    scree::Box<Dim> plane{-thick * all, far * all};
    plane.low[Dim - 1] = 0;
    plane.high[Dim - 1] = column.height() + 6 * dr;
    plane.high[axis] = 0;
    if (axis == 1) plane.low[0] = 0;  // the corner belongs to the first plane
    auto const more = scree::fill_lattice(plane, dr);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

/// Returns the slip normal of a wall particle: planes of symmetry are slip walls, the floor is not.
template <int Dim, class X>
X slip_normal_at(X const& x) {
  X n = X::Zero();
  if (x[Dim - 1] < 0) return n;
  for (int axis = 0; axis < Dim - 1; ++axis)
    if (x[axis] < 0) n[axis] = 1;
  return n.squaredNorm() > 0 ? X(n.normalized()) : n;
}

template <class P>
scree::Solver<P> at_rest(Column const& column, typename P::physics const& physics,
                         scree::SolverSettings<P> settings = {}, typename P::space const& space = {}) {
  using namespace scree::fields;
  using real = typename P::real;
  using vector = scree::Vec<P::dim, real>;
  auto const wall = scree::cast<real>(walls<P::dim>(column));
  settings.spacing = column.spacing, settings.physics = physics;
  scree::Solver<P> solver(space, settings, scree::cast<real>(grains<P::dim>(column)), wall);
  scree::Geostatic const bed{column.height(), physics.law.density(), column.gravity, 1};
  solver.set(stress,
             [&](vector const& x) { return scree::packed<P::dim>(scree::Mat<3, real>(bed(x).template cast<real>())); });
  solver.template set<scree::Wall>(slip_normal, wall, [](vector const& x) { return slip_normal_at<P::dim>(x); });
  return solver;
}

/// The depth of a deposit as a function of the distance from the axis, computed from the volume of the particles in
/// slices two spacings wide. The deposit is that of half a column in the plane, or of a quarter of a cylinder in 3D.
class Profile {
 public:
  /// Takes particle positions, whose last coordinate points upwards, and the spacing, both in m.
  template <class Positions>
  Profile(Positions const& positions, double spacing) : width_(2 * spacing) {
    constexpr int dim = std::remove_cvref_t<decltype(positions[0])>::RowsAtCompileTime;
    for (auto const& x : positions) {
      double const distance = dim == 2 ? std::abs(double(x[0])) : std::hypot(double(x[0]), double(x[1]));
      auto const slice = std::size_t(distance / width_);
      if (slice >= depth_.size()) depth_.resize(slice + 1, 0.0);
      double const area = dim == 2 ? width_ : std::numbers::pi / 2 * middle(slice) * width_;
      depth_[slice] += std::pow(spacing, dim) / area;
    }
  }

  std::size_t slices() const { return depth_.size(); }
  double middle(std::size_t slice) const { return (double(slice) + 0.5) * width_; }  // m
  double depth(std::size_t slice) const { return slice < depth_.size() ? depth_[slice] : 0; }

  /// Returns the outermost distance (m) at which the depth of the deposit is `deep` (m), interpolated between the
  /// middles of slices, or 0 if there is none.
  double reach(double deep) const {
    for (std::size_t slice = depth_.size(); slice-- > 0;)
      if (depth(slice) >= deep)
        return middle(slice) + width_ * (depth(slice) - deep) / (depth(slice) - depth(slice + 1));
    return 0;
  }
  /// Returns the depth near the axis (m), the mean over three slices.
  double summit() const { return (depth(0) + depth(1) + depth(2)) / 3; }

 private:
  double width_;
  std::vector<double> depth_;
};

inline Column column_of(Options const& o) {
  return {.aspect = o.geometry.aspect,
          .width = o.geometry.width,
          .spacing = o.geometry.width / o.numerics.across,
          .reach = floor_reach(o)};
}
inline Physics physics_of(Options const& o) {
  auto const law = beads(column_of(o), mu_for(o.model.friction_at_rest), mu_for(o.model.friction_at_speed));
  return {.law = law, .viscosity_speed = o.model.viscosity_speed, .cfl = o.numerics.cfl};
}

/// Runs a case, or one rank of a case, and writes its tables and frames.
template <class P>
int simulate_rank(app::Run<Options> const& run, typename P::space const& space, app::Ranks<P> const& ranks) {
  using namespace scree::fields;
  using S = scree::Solver<P>;
  Options const& o = run.options;
  Column const column = column_of(o);
  S solver = at_rest<P>(column, physics_of(o), {.ranks = ranks}, space);
  double const L0 = column.width, unit = column.fall_time();
  auto const profile_of = [&](S const& now) { return Profile(now.whole().values(position), column.spacing); };
  auto const reach_of = [&](Profile const& profile) { return profile.reach(o.output.reading_depth * column.height()); };
  auto const speed_of = [](S const& now) {
    double speed = 0;
    for (auto const& u : now.material().to_host(velocity)) speed = std::max(speed, u.norm());
    return now.whole().largest(speed);
  };

  double const duration = o.output.duration * unit;
  app::Checkpoints checkpoints(run, o.output.checkpoints, o.output.restart_from);
  app::Table const table{.file = "history.csv",
                         .columns = {{"time", "sqrt(H0/g)"}, {"run_out", "L0"}, {"summit", "L0"}, {"speed", "m/s"}},
                         .unit = unit};
  checkpoints.restore(solver, duration, {table});
  run.begin(solver);
  auto history = checkpoints.open(table);
  using Frames =
      scree::BodySeries<scree::Fields<scree::Velocity, scree::Pressure>, scree::Bodies<scree::Material, scree::Wall>>;
  auto frames = checkpoints.frames<Frames>();
  scree::Progress progress({.end = o.output.duration, .name = "t/sqrt(H0/g)", .unit = unit, .quiet = run.quiet});
  double const start = scree::wall_seconds();
  scree::Profiler const profiler(solver);
  scree::run_with(
      solver, duration,
      {scree::every<S>(
          o.output.interval * unit,
          [&](S& now) {
            Profile const profile = profile_of(now);
            history.row({now.time() / unit, reach_of(profile) / L0 - 1, profile.summit() / L0, speed_of(now)});
            frames.append(now);
          })},
      progress, checkpoints);
  progress.finish(solver);
  checkpoints.save(solver.snapshot());
  app::print_profile(run, profiler, solver);

  Profile const last = profile_of(solver);
  scree::CsvSeries deposit(run.output / "profile.csv", {"distance_over_L0", "depth_over_L0"});
  for (std::size_t k = 0; k < last.slices(); ++k) deposit.row({last.middle(k) / L0, last.depth(k) / L0});
  double const seconds = scree::wall_seconds() - start;
  report(run, {.reach = reach_of(last),
               .summit = last.summit(),
               .largest_speed = speed_of(solver),
               .figures = app::figures_of(solver),
               .wall_seconds = seconds});
  return checkpoints.exit_code();
}

template <int Dim>
int simulate(app::Run<Options> const& run) {
  using P = app::AsCompiled<Formulation<Dim>>;
  return app::run_ranks<P>(run, {}, run.options.numerics.ranks, simulate_rank<P>);
}

}  // namespace column_collapse
