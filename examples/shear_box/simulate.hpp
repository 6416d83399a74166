// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "models.hpp"
#include "results.hpp"

#include <scree/app/profile.hpp>
#include <scree/app/run_ranks.hpp>
#include <scree/io/body_series.hpp>
#include <scree/mixing/lacey.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// The oscillating shear box of Zhu, Peng & Wu (2024), section 5: the affine motion of the box is prescribed (5); the
// concentration of small grains follows (2.10), with no flux through any boundary.
namespace shear_box {

template <int Dim, class Real, class Segregation>
struct Formulation : scree::Formulation<Dim, Real> {
  using physics = Segregation;
  using motion = scree::OscillatingShear;
  using diagnostics = scree::SurfaceDetection;
  template <class P>
  using search = scree::CellList<P>;  // the box moves by many spacings in a step
};

/// The fields in particles.vtkhdf.
using FrameFields = scree::Fields<scree::Concentration, scree::SegregationVelocity, scree::Diffusivity,
                                  scree::SurfaceSet, scree::FreeSurfaceNormal, scree::WallNormal, scree::Identity>;

/// Runs a case, or one rank of a case.
template <class P>
int simulate_rank(app::Run<Options> const& run, typename P::physics const& segregation, typename P::space const& space,
                  app::Ranks<P> const& ranks) {
  using namespace scree::fields;
  using S = scree::Solver<P>;
  using Real = typename P::real;
  constexpr int Dim = P::dim;
  Options const& o = run.options;
  auto const particles = points<Dim>(o);

  S solver(space,
           {.spacing = spacing(o),
            .smoothing = o.numerics.smoothing,
            .physics = segregation,
            .motion = motion(o),
            .periods = periods<Dim>(o),
            .ranks = ranks},
           scree::cast<Real>(particles.material), scree::cast<Real>(particles.wall));
  solver.set(concentration, particles.cells, [&](auto const& x) { return Real(layered(x[Dim - 1], o)); });

  double const T = o.geometry.period;
  Results results(run, material_points(o, particles.cells, particles.material));
  app::Checkpoints checkpoints(run, o.output.checkpoints, o.output.restart_from);
  checkpoints.keep(
      "results", [&] { return results.numbers(); }, [&](auto const& kept) { results.take(kept); });
  checkpoints.restore(solver, o.time.periods * T, {Results::table(o)});
  run.begin(solver);
  results.open(checkpoints.open(Results::table(o)));
  using Frames = scree::BodySeries<FrameFields, scree::Bodies<scree::Material, scree::Wall>>;
  auto frames = checkpoints.frames<Frames>();
  scree::Progress progress({.end = o.time.periods, .name = "t/T", .unit = T, .quiet = run.quiet});
  auto const C_of = [](S const& now) {
    auto const C = now.whole().values(concentration);
    return std::vector<double>(C.begin(), C.end());
  };
  // If C is not finite, add_history() reports the error.
  auto const mixing_of = [](S const& now, std::vector<double> const& C) {
    double const nan = std::numeric_limits<double>::quiet_NaN();
    if (!std::ranges::all_of(C, [](double c) { return std::isfinite(c); })) return Mixing{nan, nan};
    return Mixing{scree::segregation_intensity(now).value, scree::lacey_index(now).index};
  };
  auto compared = results.compared_times();
  for (double& time : compared) time *= T;
  scree::Profiler const profiler(solver);
  scree::run_with(solver, o.time.periods * T,
                  {scree::every<S>(o.output.history_interval * T,
                                   [&](S& now) {
                                     auto const C = C_of(now);
                                     results.add_history(now.time() / T, C, mixing_of(now, C));
                                   }),
                   scree::every<S>(o.output.frame_interval * T, [&](S& now) { frames.append(now); }),
                   scree::at<S>(compared, [&](S& now) { results.keep_profile(now.time() / T, C_of(now)); })},
                  progress, checkpoints);
  progress.finish(solver);
  checkpoints.save(solver.snapshot());
  app::print_profile(run, profiler, solver);
  results.finish(app::figures_of(solver), checkpoints.interrupted());
  return checkpoints.exit_code();
}

template <int Dim, class Real, class Segregation>
int simulate(app::Run<Options> const& run, Segregation const& segregation) {
  using P = app::AsCompiled<Formulation<Dim, Real, Segregation>>;
  return app::run_ranks<P>(run, {}, run.options.numerics.ranks,
                           [&](auto const& rank, auto const& space, auto const& ranks) {
                             return simulate_rank<P>(rank, segregation, space, ranks);
                           });
}

/// Runs a case with the segregation model that the case file names.
template <int Dim, class Real, class Closure>
int simulate_with(app::Run<Options> const& run) {
  Options const& o = run.options;
  using scree::ConservativeSegregation, scree::HybridSegregation;
  if (o.model.scheme == Scheme::conservative)
    return simulate<Dim, Real>(run, ConservativeSegregation<Closure>{closure<Closure>(o), flux(o), transport_step(o)});
  return simulate<Dim, Real>(run, HybridSegregation<Closure>{closure<Closure>(o), flux(o), transport_step(o)});
}
template <int Dim, class Real>
int simulate(app::Run<Options> const& run) {
  if (run.options.model.closure == Closure::constant) return simulate_with<Dim, Real, scree::ConstantClosure>(run);
  return simulate_with<Dim, Real, scree::ShearRateClosure>(run);
}

}  // namespace shear_box
