// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "recorder.hpp"

#include <scree/scree.hpp>

// From a solver to what the recorder understands.
namespace shear_box {

template <class S>
State state_of(S const& solver, double period) {
  auto const C = solver.material().to_host(scree::concentration);
  return {.time = solver.time() / period, .steps = solver.steps(), .C = {C.begin(), C.end()}};
}

/// Of particles.vtkhdf.
using FrameFields = scree::Fields<scree::Concentration, scree::SegregationVelocity, scree::Diffusivity,
                                  scree::SurfaceSet, scree::FreeSurfaceNormal, scree::WallNormal, scree::Identity>;

/// What is recorded when; recorder and frames must outlive the observers.
template <class S, class Frames>
typename S::Observers observers(Recorder& recorder, Frames& frames, Options const& o) {
  double const T = o.geometry.period;
  auto compared = recorder.compared_times();
  for (double& time : compared) time *= T;
  return {scree::every<S>(o.output.history_interval * T, [&, T](S& s) { recorder.record_history(state_of(s, T)); }),
          scree::every<S>(o.output.frame_interval * T, [&](S& s) { frames.append(s); }),
          scree::at<S>(compared, [&, T](S& s) { recorder.keep_profile(state_of(s, T)); })};
}

template <class S>
RunFigures figures_of(S const& solver, double period) {
  return {.time = solver.time() / period,
          .steps = solver.steps(),
          .neighbour_builds = solver.neighbour_builds(),
          .particles = solver.material().size(),
          .wall_particles = solver.wall().size(),
          .steps_by_limit = solver.limits(),
          .execution_space = S::policy::space::name()};
}

}  // namespace shear_box
