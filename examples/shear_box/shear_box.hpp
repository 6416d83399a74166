// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case.hpp"
#include "observe.hpp"

#include <scree/io/body_series.hpp>

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

template <int Dim, class Real, class Segregation>
void simulate(scree::app::Run<Options> const& run, Segregation const& segregation) {
  using P = Formulation<Dim, Real, Segregation>;
  Options const& o = run.options;
  auto const particles = points<Dim>(o);

  scree::Solver<P> solver({.spacing = spacing(o),
                           .smoothing = o.numerics.smoothing,
                           .physics = segregation,
                           .motion = motion(o),
                           .periods = periods<Dim>(o)},
                          scree::cast<Real>(particles.material), scree::cast<Real>(particles.wall));
  solver.set(scree::concentration, particles.cells, [&](auto const& x) { return Real(layered(x[Dim - 1], o)); });

  Recorder recorder(run, material_points(o, particles.cells, particles.material));
  scree::BodySeries frames(run.output / "particles.vtkhdf", FrameFields{},
                           scree::Bodies<scree::Material, scree::Wall>{},
                           {.single_precision = true, .provenance = {{"case", run.case_text}}});
  solver.run(o.time.periods * o.geometry.period, observers<scree::Solver<P>>(recorder, frames, o));
  recorder.finish(figures_of(solver, o.geometry.period));
}

/// Chooses the segregation model by its names in the case file.
template <int Dim, class Real, class Closure>
void simulate_with(scree::app::Run<Options> const& run) {
  Options const& o = run.options;
  if (o.model.scheme == Scheme::conservative)
    simulate<Dim, Real>(run, scree::ConservativeSegregation<Closure>{closure<Closure>(o), flux(o), transport_step(o)});
  else
    simulate<Dim, Real>(run, scree::HybridSegregation<Closure>{closure<Closure>(o), flux(o), transport_step(o)});
}
template <int Dim, class Real>
void simulate(scree::app::Run<Options> const& run) {
  if (run.options.model.closure == Closure::constant)
    simulate_with<Dim, Real, scree::ConstantClosure>(run);
  else
    simulate_with<Dim, Real, scree::ShearRateClosure>(run);
}

}  // namespace shear_box
