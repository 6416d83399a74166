// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "case.hpp"
#include "observe.hpp"

#include <scree/app/checkpoints.hpp>

#include <scree/granular/segregating.hpp>
#include <scree/integrators/symplectic_euler.hpp>
#include <scree/run/run_with.hpp>

// The rotating drum of Zhu, Peng & Wu (2024), section 6: granular flow by mu(I), and segregation driven by its shear.
namespace drum {

template <int Dim, class Real, class Segregation>
struct Formulation : scree::Formulation<Dim, Real> {
  using physics = scree::SegregatingGranular<Mechanics, Segregation>;
  // The paper's predictor-corrector makes elastic waves grow, by (omega dt)^4/8 per step; this one does not.
  using integrator = scree::SymplecticEuler;
  using motion = scree::Rotation;
  using diagnostics = Diagnostics;
};

template <int Dim, class Real, template <class> class Segregation>
int simulate_with(scree::app::Run<Options> const& run) {
  using P = Formulation<Dim, Real, Segregation<SegregationClosure>>;
  Options const& o = run.options;
  auto const particles = points<Dim>(o);
  auto const wall = motion(o);

  scree::Solver<P> solver({.spacing = o.numerics.spacing,
                           .smoothing = o.numerics.smoothing,
                           .physics = {mechanics(o), {closure(o), flux(o)}, segregation_period(o)},
                           .motion = wall,
                           .periods = periods<Dim>(o),
                           .sort_period = 20'000},  // several times per turn or more, because grains mix
                          scree::cast<Real>(particles.material), scree::cast<Real>(particles.wall));

  // The bed turns with the drum from the beginning, under its own weight, well inside yield.
  scree::Geostatic const weight{
      .surface_height = initial_level(o), .density = o.material.density, .gravity = o.geometry.gravity, .K0 = 1};
  auto const& x = particles.material;
  solver.set(scree::stress, x,
             [&](auto const& at) { return scree::packed<Dim>(weight(at)).template cast<Real>().eval(); });
  solver.set(scree::velocity, x, [&](auto const& at) { return wall.velocity(at, 0).template cast<Real>().eval(); });
  solver.set(scree::concentration, x, [&](auto const&) { return Real(o.segregation.C0); });
  solver.set(scree::volume, particles.volumes, [](double v) { return Real(v); });

  scree::app::Checkpoints checkpoints({.file = run.output / "checkpoint.h5",
                                       .interval = o.output.checkpoint_interval,
                                       .notes = {{"case", run.case_text}}});
  Start start;
  if (!o.time.restart_from.empty()) {
    auto const snapshot = checkpoints.read(o.time.restart_from, scree::app::print_note);
    solver.restore(snapshot);
    start = {.time = snapshot.time, .memory = scree::numbers_in(snapshot, "recorder")};
  }
  Recorder recorder(run, start);
  checkpoints.keep("recorder", [&] { return recorder.memory(); });
  run_with(solver, o.time.duration, observers<scree::Solver<P>>(recorder, o), checkpoints);
  recorder.finish(figures_of(solver));
  return checkpoints.exit_code();
}

template <int Dim, class Real>
int simulate(scree::app::Run<Options> const& run) {
  if (run.options.segregation.scheme == Scheme::conservative)
    return simulate_with<Dim, Real, scree::ConservativeSegregation>(run);
  return simulate_with<Dim, Real, scree::HybridSegregation>(run);
}

}  // namespace drum
