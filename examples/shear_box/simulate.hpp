// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "models.hpp"
#include "results.hpp"

#include <scree/io/body_series.hpp>
#include <scree/run/progress.hpp>
#include <scree/run/run_with.hpp>

// The oscillating shear box of Zhu, Peng & Wu (2024), section 5: the affine motion of the box is prescribed (5), the
// concentration of small grains follows (2.10) without flux through any boundary.
namespace shear_box {

template <int Dim, class Real, class Segregation>
struct Formulation : scree::Formulation<Dim, Real> {
  using physics = Segregation;
  using motion = scree::OscillatingShear;
  using diagnostics = scree::SurfaceDetection;
  template <class P>
  using search = scree::CellList<P>;  // the box moves by many particles in a step
};

/// Of particles.vtkhdf.
using FrameFields = scree::Fields<scree::Concentration, scree::SegregationVelocity, scree::Diffusivity,
                                  scree::SurfaceSet, scree::FreeSurfaceNormal, scree::WallNormal, scree::Identity>;

template <int Dim, class Real, class Segregation>
void simulate(app::Run<Options> const& run, Segregation const& segregation) {
  using S = scree::Solver<Formulation<Dim, Real, Segregation>>;
  Options const& o = run.options;
  auto const particles = points<Dim>(o);

  S solver({.spacing = spacing(o),
            .smoothing = o.numerics.smoothing,
            .physics = segregation,
            .motion = motion(o),
            .periods = periods<Dim>(o)},
           scree::cast<Real>(particles.material), scree::cast<Real>(particles.wall));
  solver.set(scree::concentration, particles.cells, [&](auto const& x) { return Real(layered(x[Dim - 1], o)); });

  run.begin();
  Results results(run, material_points(o, particles.cells, particles.material));
  scree::BodySeries frames(run.output / "particles.vtkhdf", FrameFields{},
                           scree::Bodies<scree::Material, scree::Wall>{},
                           {.single_precision = true, .provenance = {{"case", run.case_text}}});
  double const T = o.geometry.period;
  scree::Progress progress({.end = o.time.periods, .name = "t/T", .unit = T, .quiet = run.quiet});
  auto const C_of = [](S const& now) {
    auto const C = now.material().to_host(scree::concentration);
    return std::vector<double>(C.begin(), C.end());
  };
  auto compared = results.compared_times();
  for (double& time : compared) time *= T;
  scree::run_with(
      solver, o.time.periods * T,
      {scree::every<S>(o.output.history_interval * T, [&](S& now) { results.add_history(now.time() / T, C_of(now)); }),
       scree::every<S>(o.output.frame_interval * T, [&](S& now) { frames.append(now); }),
       scree::at<S>(compared, [&](S& now) { results.keep_profile(now.time() / T, C_of(now)); })},
      progress);
  progress.finish(solver);
  results.finish(app::figures_of(solver));
}

/// Chooses the segregation model by its names in the case file.
template <int Dim, class Real, class Closure>
void simulate_with(app::Run<Options> const& run) {
  Options const& o = run.options;
  if (o.model.scheme == Scheme::conservative)
    simulate<Dim, Real>(run, scree::ConservativeSegregation<Closure>{closure<Closure>(o), flux(o), transport_step(o)});
  else
    simulate<Dim, Real>(run, scree::HybridSegregation<Closure>{closure<Closure>(o), flux(o), transport_step(o)});
}
template <int Dim, class Real>
int simulate(app::Run<Options> const& run) {
  if (run.options.model.closure == Closure::constant)
    simulate_with<Dim, Real, scree::ConstantClosure>(run);
  else
    simulate_with<Dim, Real, scree::ShearRateClosure>(run);
  return 0;
}

}  // namespace shear_box
